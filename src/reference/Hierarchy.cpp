#include "reference/Hierarchy.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace limen::reference {
namespace {

/// Shares of a float: its successor is nearer than kStep, and rounding a double moves it by half of that at
/// most. kLeast covers zero and denormal floats.
constexpr float kStep = 0x1p-23f, kLeast = 1e-30f;

float below(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded - (std::abs(rounded) * kStep + kLeast);
}
float above(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded + (std::abs(rounded) * kStep + kLeast);
}

/// Half the surface area: the weight of a box in the heuristic.
float weightOf(const Box& box) {
    const float x = box.max[0] - box.min[0], y = box.max[1] - box.min[1], z = box.max[2] - box.min[2];
    return x < 0.0f ? 0.0f : x * y + y * z + z * x;
}

} // namespace

void Box::grow(double margin) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        min[axis] = below(min[axis] - margin);
        max[axis] = above(max[axis] + margin);
    }
}

Box Extent::box() const {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] = below(least[static_cast<int>(axis)]);
        box.max[axis] = above(greatest[static_cast<int>(axis)]);
    }
    return box;
}

BoxRay::BoxRay(const Vec3& eye, const Vec3& direction, double margin) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at = eye[static_cast<int>(axis)], step = direction[static_cast<int>(axis)];
        // The eye as a float is off by 2^-24 of itself; this is four times that, plus a micrometre, so that
        // an eye in the side of a flat box is clearly on both sides.
        const double off = std::abs(at) * 0x1p-22 + 1e-6 + margin;
        negative[axis] = std::signbit(step) ? 1 : 0;
        const double sign = negative[axis] ? -1.0 : 1.0;
        // Smaller components count as 1e-15: over any distance on the map that moves the ray by less than the
        // micrometre.
        inverse[axis] = static_cast<float>(sign / std::max(std::abs(step), 1e-15));
        nearOrigin[axis] = static_cast<float>(at + sign * off);
        farOrigin[axis] = static_cast<float>(at - sign * off);
    }
}

/// The inputs of a build beside the nodes.
struct Hierarchy::Build {
    std::span<const Box> boxes;
    std::vector<std::uint32_t>& order;
    const std::uint32_t leafSize;

    [[nodiscard]] float centre(std::uint32_t thing, std::size_t axis) const {
        return boxes[thing].min[axis] * 0.5f + boxes[thing].max[axis] * 0.5f;
    }
    [[nodiscard]] Box boxOf(std::uint32_t first, std::uint32_t count) const {
        Box box;
        for (std::uint32_t i = first; i < first + count; ++i)
            box.include(boxes[order[i]]);
        return box;
    }
    [[nodiscard]] Box centresOf(const Range& range) const {
        Box box;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box.min[axis] = std::min(box.min[axis], centre(order[i], axis));
                box.max[axis] = std::max(box.max[axis], centre(order[i], axis));
            }
        }
        return box;
    }
    [[nodiscard]] std::uint32_t halve(const Range& range, std::size_t axis) const;
    [[nodiscard]] std::uint32_t divide(const Range& range, std::uint32_t depth) const;
};

namespace {

constexpr std::uint32_t kBins = 16;

struct Bins {
    std::array<Box, kBins> boxes;
    std::array<std::uint32_t, kBins> counts{};
};

/// The equal slices of an interval, and the slice of a centre.
struct Slices {
    float low, scale;
    [[nodiscard]] std::uint32_t of(float centre) const {
        return std::min(static_cast<std::uint32_t>(std::max((centre - low) * scale, 0.0f)), kBins - 1);
    }
};

struct Cut {
    float cost = std::numeric_limits<float>::infinity();
    std::uint32_t bin = 0; ///< the first of the right side
};

/// The cheapest cut between two slices.
Cut cheapest(const Bins& bins) {
    std::array<float, kBins> left{};
    Box box;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i + 1 < kBins; ++i) {
        box.include(bins.boxes[i]);
        count += bins.counts[i];
        left[i + 1] = weightOf(box) * static_cast<float>(count);
    }
    Cut best;
    box = {};
    count = 0;
    for (std::uint32_t i = kBins - 1; i > 0; --i) {
        box.include(bins.boxes[i]);
        count += bins.counts[i];
        const float cost = left[i] + weightOf(box) * static_cast<float>(count);
        if (cost < best.cost)
            best = {cost, i};
    }
    return best;
}

} // namespace

/// Puts the lower half along `axis` first. Returns the begin of the upper half.
std::uint32_t Hierarchy::Build::halve(const Range& range, std::size_t axis) const {
    const auto begin = order.begin() + range.first, middle = begin + range.count / 2;
    std::nth_element(begin, middle, begin + range.count, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(centre(a, axis), a) < std::pair(centre(b, axis), b);
    });
    return range.first + range.count / 2;
}

/// Divides a range into two non-empty parts. Returns the begin of the second.
std::uint32_t Hierarchy::Build::divide(const Range& range, std::uint32_t depth) const {
    if (range.count == 2)
        return range.first + 1;
    const Box centres = centresOf(range);
    std::size_t widest = 0;
    Cut best;
    std::size_t bestAxis = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float extent = centres.max[axis] - centres.min[axis];
        if (extent > centres.max[widest] - centres.min[widest])
            widest = axis;
        if (!(extent > 0.0f))
            continue;
        const Slices slices{centres.min[axis], static_cast<float>(kBins) / extent};
        Bins bins;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const std::uint32_t slice = slices.of(centre(order[i], axis));
            bins.boxes[slice].include(boxes[order[i]]);
            ++bins.counts[slice];
        }
        if (const Cut cut = cheapest(bins); cut.cost < best.cost) {
            best = cut;
            bestAxis = axis;
        }
    }
    if (best.bin == 0 || depth >= kHalvingDepth)
        return halve(range, widest);
    const Slices slices{centres.min[bestAxis],
                        static_cast<float>(kBins) / (centres.max[bestAxis] - centres.min[bestAxis])};
    const auto begin = order.begin() + range.first, end = begin + range.count;
    const auto middle = std::stable_partition(
        begin, end, [&](std::uint32_t thing) { return slices.of(centre(thing, bestAxis)) < best.bin; });
    return middle == begin || middle == end ? halve(range, widest)
                                            : range.first + static_cast<std::uint32_t>(middle - begin);
}

void Hierarchy::setChildBox(Node& node, std::uint32_t child, const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        node.sides[0][axis][child] = box.min[axis];
        node.sides[1][axis][child] = box.max[axis];
    }
}

Box Hierarchy::boxOfChild(const Node& node, std::uint32_t child, std::span<const Box> boxes) const {
    Box box;
    if (node.count[child] > 0) {
        for (const Box& thing : boxes.subspan(node.child[child], node.count[child]))
            box.include(thing);
    } else if (node.child[child] > 0) {
        const Node& below = nodes_[node.child[child]];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.min[axis] = *std::min_element(below.sides[0][axis], below.sides[0][axis] + kWidth);
            box.max[axis] = *std::max_element(below.sides[1][axis], below.sides[1][axis] + kWidth);
        }
    }
    return box;
}

void Hierarchy::fit(const Hierarchy& other, std::span<const Box> boxes) {
    nodes_.assign(other.nodes_.begin(), other.nodes_.end());
    for (std::size_t i = nodes_.size(); i-- > 0;)
        for (std::uint32_t child = 0; child < kWidth; ++child)
            setChildBox(nodes_[i], child, boxOfChild(nodes_[i], child, boxes));
}

std::uint32_t Hierarchy::buildNode(Build& build, const Range& range, std::uint32_t depth) {
    LIMEN_ASSERT(depth < kMaxDepth, "a hierarchy is never deeper than its walk's stack");
    std::array<Range, kWidth> children{range};
    std::uint32_t used = 1;
    while (used < kWidth) { // divide the heaviest child that has more than a leaf's elements
        Range* heaviest = nullptr;
        for (std::uint32_t i = 0; i < used; ++i)
            if (children[i].count > build.leafSize &&
                (!heaviest || weightOf(children[i].box) > weightOf(heaviest->box)))
                heaviest = &children[i];
        if (!heaviest)
            break;
        const Range whole = *heaviest;
        const std::uint32_t middle = build.divide(whole, depth);
        const std::uint32_t firstCount = middle - whole.first;
        *heaviest = {whole.first, firstCount, build.boxOf(whole.first, firstCount)};
        children[used++] = {middle, whole.count - firstCount, build.boxOf(middle, whole.count - firstCount)};
    }
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    for (std::uint32_t i = 0; i < kWidth; ++i) {
        setChildBox(nodes_[index], i, i < used ? children[i].box : Box{});
        if (i >= used)
            continue;
        const bool leaf = children[i].count <= build.leafSize;
        const std::uint32_t child = leaf ? children[i].first : buildNode(build, children[i], depth + 1);
        nodes_[index].child[i] = child;
        nodes_[index].count[i] = leaf ? children[i].count : 0;
    }
    return index;
}

void Hierarchy::build(std::span<const Box> boxes, std::uint32_t leafSize, std::vector<std::uint32_t>& order) {
    LIMEN_ASSERT(leafSize > 0, "a leaf has room for an element");
    nodes_.clear();
    order.resize(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    if (boxes.empty())
        return;
    Build state{boxes, order, leafSize};
    const auto count = static_cast<std::uint32_t>(boxes.size());
    buildNode(state, {0, count, state.boxOf(0, count)}, 0);
}

} // namespace limen::reference
