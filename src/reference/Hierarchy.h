#pragma once

#include "geometry/Vec.h"

#include <array>
#include <cstdint>
#include <emmintrin.h>
#include <span>
#include <vector>

namespace limen::reference {

/// An axis-aligned box in floats, rounded outwards, so it contains all points that it was made from. The
/// fourth number of each corner fills the register.
struct Box {
    alignas(16) std::array<float, 4> min{1e30f, 1e30f, 1e30f, 1e30f};
    alignas(16) std::array<float, 4> max{-1e30f, -1e30f, -1e30f, -1e30f};

    void include(const Box& other) {
        _mm_store_ps(min.data(), _mm_min_ps(_mm_load_ps(min.data()), _mm_load_ps(other.min.data())));
        _mm_store_ps(max.data(), _mm_max_ps(_mm_load_ps(max.data()), _mm_load_ps(other.max.data())));
    }
    /// Moves every side outwards by `margin` (metres) and one rounding step.
    void grow(double margin);
};

/// The bounds of points in double; box() rounds them once.
struct Extent {
    Vec3 least{1e30}, greatest{-1e30};

    void include(const Vec3& p) {
        least = glm::min(least, p);
        greatest = glm::max(greatest, p);
    }
    [[nodiscard]] Box box() const;
};

/// A ray prepared for box tests in float. The tests never miss a box that the ray in double meets.
struct BoxRay {
    /// Boxes are tested as if they were larger by `margin` metres on each side.
    BoxRay(const Vec3& eye, const Vec3& direction, double margin);

    // The near side of a slab is tested from `nearOrigin` and the far side from `farOrigin`. The two are on
    // either side of the eye, so the interval is slightly too long.
    std::array<float, 3> nearOrigin{}, farOrigin{}, inverse{};
    std::array<std::uint8_t, 3> negative{}; ///< 1 where the direction runs down its axis
};

/// A hierarchy of boxes with four children a node. The owner keeps the elements in the order of the leaves.
/// Ref: Dammertz, Hanika, Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of
/// Incoherent Rays" (2008); the split is the binned surface area heuristic of Wald, "On fast Construction of
/// SAH-based Bounding Volume Hierarchies" (2007).
class Hierarchy {
public:
    /// Rebuilds over `boxes`. A leaf has at most `leafSize` elements; `order` becomes their order in the
    /// leaves. Costs n log n; keeps its capacity. The same boxes always give the same hierarchy.
    void build(std::span<const Box> boxes, std::uint32_t leafSize, std::vector<std::uint32_t>& order);
    /// Takes the grouping of `other` over different boxes, given in the order of its leaves. Costs n.
    void fit(const Hierarchy& other, std::span<const Box> boxes);
    void clear() { nodes_.clear(); }
    [[nodiscard]] bool empty() const { return nodes_.empty(); }

    /// Calls leaf(first, count) for runs of elements whose boxes the ray may meet at a parameter in [nearest,
    /// farthest], roughly from near to far. `leaf` may lower `farthest`; elements at `farthest` itself are
    /// still visited.
    template <class Leaf>
    void walk(const BoxRay& ray, double nearest, const double& farthest, Leaf&& leaf) const;

    /// One step of a caller's own walk. test(sides, least) returns the node's boxes that count, as bits, and
    /// sets a number for each. visit(child, count, least) is called for each of them: `child` is a node if
    /// `count` is 0, else the first element of a leaf. The root is node 0; the hierarchy must not be empty.
    template <class Test, class Visit>
    void open(std::uint32_t node, Test&& test, Visit&& visit) const {
        const Node& opened = nodes_[node];
        alignas(16) float least[kWidth];
        for (int met = test(opened.sides, least); met != 0; met &= met - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(static_cast<unsigned>(met)));
            visit(opened.child[i], opened.count[i], least[i]);
        }
    }

private:
    static constexpr std::uint32_t kWidth = 4;
    /// From this depth on ranges are halved. So no data makes a hierarchy deeper than kMaxDepth.
    static constexpr std::uint32_t kHalvingDepth = 32, kMaxDepth = kHalvingDepth + 32;

    struct alignas(16) Node {
        float sides[2][3][kWidth];     ///< [0] least, [1] greatest; reversed for an unused child
        std::uint32_t child[kWidth]{}; ///< a node, or the first element of a leaf; 0, the root: unused
        std::uint32_t count[kWidth]{}; ///< elements in a leaf; 0: an inner node
    };
    struct Range {
        std::uint32_t first = 0, count = 0;
        Box box;
    };
    struct Build;
    /// The box of a child, from the elements' boxes in the order of the leaves, or from the node below.
    [[nodiscard]] Box boxOfChild(const Node& node, std::uint32_t child, std::span<const Box> boxes) const;
    static void setChildBox(Node& node, std::uint32_t child, const Box& box);
    std::uint32_t buildNode(Build& build, const Range& range, std::uint32_t depth);

    std::vector<Node> nodes_; ///< the root first, children after their parents
};

template <class Leaf>
void Hierarchy::walk(const BoxRay& ray, double nearest, const double& farthest, Leaf&& leaf) const {
    if (nodes_.empty())
        return;
    struct Entry {
        std::uint32_t child, count;
        float entered;
    };
    // Each level leaves at most three siblings on the stack.
    Entry stack[(kWidth - 1) * kMaxDepth + kWidth];
    std::uint32_t height = 0;
    stack[height++] = {0, 0, -1e30f};
    // A parameter in float carries three roundings (difference, reciprocal, product), 2^-24 of itself each.
    // 2^-20 covers them; 1e-6 covers parameters near zero.
    constexpr float kWiden = 1.0f + 1.0f / (1 << 20), kNearZero = 1e-6f;
    const __m128 lower =
        _mm_set1_ps(static_cast<float>(nearest) - kNearZero - std::abs(static_cast<float>(nearest)) * 1e-6f);
    while (height > 0) {
        const Entry top = stack[--height];
        const float bound = static_cast<float>(farthest) * kWiden + kNearZero;
        if (top.entered > bound)
            continue;
        if (top.count > 0) {
            leaf(top.child, top.count);
            continue;
        }
        const Node& node = nodes_[top.child];
        __m128 enter = lower, leave = _mm_set1_ps(bound);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t down = ray.negative[axis];
            const __m128 inverse = _mm_set1_ps(ray.inverse[axis]);
            const __m128 in = _mm_mul_ps(
                _mm_sub_ps(_mm_load_ps(node.sides[down][axis]), _mm_set1_ps(ray.nearOrigin[axis])), inverse);
            const __m128 out = _mm_mul_ps(
                _mm_sub_ps(_mm_load_ps(node.sides[1 - down][axis]), _mm_set1_ps(ray.farOrigin[axis])),
                inverse);
            enter = _mm_max_ps(enter, in);
            leave = _mm_min_ps(leave, out);
        }
        leave = _mm_add_ps(_mm_mul_ps(leave, _mm_set1_ps(kWiden)), _mm_set1_ps(kNearZero));
        int met = _mm_movemask_ps(_mm_cmple_ps(enter, leave));
        alignas(16) float entered[kWidth];
        _mm_store_ps(entered, enter);
        const std::uint32_t base = height;
        for (; met != 0; met &= met - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(static_cast<unsigned>(met)));
            // Inserted in order, the nearest on top.
            std::uint32_t at = height++;
            for (; at > base && stack[at - 1].entered < entered[i]; --at)
                stack[at] = stack[at - 1];
            stack[at] = {node.child[i], node.count[i], entered[i]};
        }
    }
}

} // namespace limen::reference
