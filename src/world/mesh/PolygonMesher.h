#pragma once

#include "world/mesh/BakedGeometry.h"
#include "world/mesh/MeshData.h"
#include "world/mesh/Triangulate.h"

namespace limen::world {

/// Triangulates baked polygons into a MeshData. A two-sided polygon is added twice, the second time reversed
/// and with negated normals.
class PolygonMesher {
public:
    /// `lists`: the index list of each surface slot.
    explicit PolygonMesher(std::vector<SurfaceList> lists) : lists_(std::move(lists)) {}

    /// Adds one polygon of baked geometry. All its loops get the same polygon number.
    void add(const BakedGeometry& geometry, std::uint32_t handle);
    [[nodiscard]] MeshData finish() { return std::move(mesh_); }

private:
    void addLoop(std::span<const StitchCorner> loop, const SourcePolygon& source,
                 std::span<const Vec3> vertices);
    void emitSide(std::span<const StitchCorner> loop, std::int32_t slot, bool back);

    std::vector<SurfaceList> lists_;
    MeshData mesh_;
    std::vector<Vec3> points_;
    std::vector<TriangleCorners> triangles_;
};

} // namespace limen::world
