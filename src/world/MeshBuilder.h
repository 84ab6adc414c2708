#pragma once

#include "world/BakedGeometry.h"
#include "world/Triangulate.h"
#include "world/World.h"

namespace limen::world {

/// A mesh before it joins the world's arenas. `vertices`, `polygonIds` as in World; indices by SurfaceClass.
struct MeshData {
    std::vector<MeshVertex> vertices;
    std::array<std::vector<std::uint32_t>, 3> indices;
    std::vector<std::uint16_t> polygonIds;

    [[nodiscard]] bool empty() const { return vertices.empty(); }
};

/// Collects polygons into a MeshData: two-sided ones twice, the second time reversed and with negated
/// normals.
class MeshBuilder {
public:
    /// `classes`: by surface slot.
    explicit MeshBuilder(std::vector<SurfaceClass> classes) : classes_(std::move(classes)) {}

    /// A polygon of baked geometry, all its loops under one number.
    void add(const BakedGeometry& geometry, std::uint32_t handle);
    [[nodiscard]] MeshData finish() { return std::move(mesh_); }

private:
    void addLoop(std::span<const StitchCorner> loop, const SourcePolygon& source,
                 std::span<const Vec3> vertices);
    void emitSide(std::span<const StitchCorner> loop, std::int32_t slot, bool back);

    std::vector<SurfaceClass> classes_;
    MeshData mesh_;
    std::vector<Vec3> points_;
    std::vector<TriangleCorners> triangles_;
};

} // namespace limen::world
