#pragma once

#include "world/mesh/BakedGeometry.h"
#include "world/mesh/MeshData.h"
#include "world/mesh/Triangulate.h"

namespace limen::world {

/// Triangulates baked polygons into a MeshData. A two-sided polygon is added twice, the second time reversed.
/// The back keeps the front's normals, or gets negated ones if it has a surface of its own. Zero normals stay zero.
class PolygonMesher {
public:
    /// `lists`: the index list of each surface slot.
    explicit PolygonMesher(std::vector<SurfaceList> lists)
        : lists_(std::move(lists)), clamped_(lists_.size(), true) {}

    /// Adds one polygon of baked geometry. All its loops get the same polygon number.
    void add(const BakedGeometry& geometry, std::uint32_t handle);
    [[nodiscard]] MeshData finish() { return std::move(mesh_); }
    /// By slot: whether its picture is clamped. One polygon that repeats it makes the whole slot repeat.
    [[nodiscard]] const std::vector<bool>& clamped() const { return clamped_; }

private:
    void addLoop(std::span<const StitchCorner> loop, const SourcePolygon& source,
                 std::span<const Vec3> vertices);
    enum class Side : std::uint8_t { Front, Back, BackLitAsFront };
    void emitSide(std::span<const StitchCorner> loop, std::int32_t slot, Side side);
    void noteRepeat(std::int32_t slot, bool repeats);

    std::vector<SurfaceList> lists_;
    std::vector<bool> clamped_;
    MeshData mesh_;
    std::vector<Vec3> points_;
    std::vector<TriangleCorners> triangles_;
};

} // namespace limen::world
