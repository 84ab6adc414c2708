#pragma once

#include "world/mesh/PointTree.h"

#include <unordered_map>
#include <utility>

namespace limen::world {

/// A corner of a polygon after welding, with the values that are interpolated along its edges.
struct StitchCorner {
    std::uint32_t vertex = 0; ///< canonical: Welder::vertexOf
    Vec3f normal{0.0f};
    Vec2f front{0.0f}, back{0.0f}; ///< texture coordinates of the two sides
};
using StitchLoop = std::vector<StitchCorner>;

/// Removes T-junctions: every vertex within kWeldTolerance of the interior of a polygon's edge becomes a
/// corner of that polygon. The vertices inserted into an edge depend only on its two vertices and on the set
/// of all vertices. So two polygons that share an edge still share all of its parts. Cost: O(log n) an edge.
class Stitcher {
public:
    /// `vertices` must outlive the stitcher.
    explicit Stitcher(std::span<const Vec3> vertices);

    /// Yields the polygon with the vertices inserted. A vertex that occurs twice cuts the polygon in two.
    /// Parts with fewer than three corners (slivers thinner than the tolerance) are dropped; their neighbours
    /// still match.
    [[nodiscard]] std::vector<StitchLoop> stitch(const StitchLoop& polygon);

    /// If one edge runs a-v-c-b and another a-c, v may be just too far from the second to be found, which
    /// leaves a crack as thin as the tolerance. This function gives such edges their missing vertices. True
    /// if there were any: then all polygons must be stitched again.
    [[nodiscard]] bool reconcile();

private:
    struct Inserted {
        std::uint32_t vertex = 0;
        double t = 0.0; ///< from the edge's smaller vertex
    };
    const std::vector<Inserted>& onEdge(std::uint32_t a, std::uint32_t b);
    static bool along(const Inserted& a, const Inserted& b);
    static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b);
    bool force(std::uint32_t a, std::uint32_t b, std::uint32_t vertex);
    bool insertInto(const StitchLoop& in, StitchLoop& out);

    std::span<const Vec3> vertices_;
    PointTree tree_;
    std::unordered_map<std::uint64_t, std::vector<Inserted>> edges_;
    std::vector<std::uint32_t> near_;
};

} // namespace limen::world
