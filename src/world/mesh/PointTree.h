#pragma once

#include "geometry/Bounds.h"

#include <span>
#include <vector>

namespace limen::world {

/// A tree of boxes over points, which finds the points near a segment. Cost to build: O(n log n).
class PointTree {
public:
    /// `points` must outlive the tree.
    explicit PointTree(std::span<const Vec3> points);

    /// Appends the indices of all points within `radius` of the segment a-b, in no particular order.
    void nearSegment(const Vec3& a, const Vec3& b, double radius, std::vector<std::uint32_t>& out) const;

private:
    struct Node {
        Aabb box;
        std::uint32_t first = 0, count = 0; ///< a leaf's run of order_; count 0: an inner node
        std::uint32_t right = 0;            ///< an inner node's second child; its first is the next node
    };
    void build(std::uint32_t first, std::uint32_t count);

    std::span<const Vec3> points_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace limen::world
