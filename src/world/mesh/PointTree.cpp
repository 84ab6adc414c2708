#include "world/mesh/PointTree.h"

#include "core/Assert.h"
#include "geometry/Segment.h"

#include <algorithm>
#include <numeric>

namespace limen::world {
namespace {

constexpr std::uint32_t kLeafSize = 8;

/// True if the segment meets the box grown by `radius`. Conservative: a segment that only passes near a
/// corner may count, too. The slab method.
bool meets(const Aabb& box, const Vec3& a, const Vec3& direction, double radius) {
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min[axis] - radius - a[axis], high = box.max[axis] + radius - a[axis];
        const double d = direction[axis];
        if (std::abs(d) < 1e-12) {
            if (low > 0.0 || high < 0.0)
                return false;
            continue;
        }
        const double t0 = low / d, t1 = high / d;
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
    }
    return enter <= leave + 1e-9;
}

} // namespace

PointTree::PointTree(std::span<const Vec3> points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!points.empty())
        build(0, static_cast<std::uint32_t>(points.size()));
}

void PointTree::build(std::uint32_t first, std::uint32_t count) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Aabb box;
    for (std::uint32_t i = first; i < first + count; ++i)
        box.include(points_[order_[i]]);
    nodes_[at].box = box;
    if (count <= kLeafSize) {
        nodes_[at].first = first;
        nodes_[at].count = count;
        return;
    }
    const Vec3 size = box.max - box.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t i, std::uint32_t j) {
        return points_[i][axis] != points_[j][axis] ? points_[i][axis] < points_[j][axis] : i < j;
    });
    build(first, half);
    nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
    build(first + half, count - half);
}

void PointTree::nearSegment(const Vec3& a, const Vec3& b, double radius,
                            std::vector<std::uint32_t>& out) const {
    LIMEN_ASSERT(radius >= 0.0, "a distance");
    if (nodes_.empty())
        return;
    const Vec3 direction = b - a;
    std::uint32_t stack[64]; // each level halves the points: the depth is below 32
    std::size_t top = 0;
    stack[top++] = 0;
    while (top > 0) {
        const std::uint32_t at = stack[--top];
        const Node& node = nodes_[at];
        if (!meets(node.box, a, direction, radius))
            continue;
        if (node.count == 0) {
            LIMEN_ASSERT(top + 2 <= std::size(stack), "the stack holds a node for each level");
            stack[top++] = node.right;
            stack[top++] = at + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (distanceToSegment(points_[order_[i]], a, b).distance <= radius)
                out.push_back(order_[i]);
    }
}

} // namespace limen::world
