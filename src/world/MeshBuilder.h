#pragma once

#include "world/BakedGeometry.h"
#include "world/Triangulate.h"
#include "world/World.h"

namespace limen::world {

/// How a mesh lists its triangles: by SurfaceClass, and of the blended ones those first that are split (Material::kSplit).
enum class SurfaceList : std::uint8_t { Opaque, CutOut, Split, Blended };

[[nodiscard]] constexpr SurfaceList listOf(SurfaceClass surfaces, bool split) {
    switch (surfaces) {
    case SurfaceClass::Opaque:
        return SurfaceList::Opaque;
    case SurfaceClass::CutOut:
        return SurfaceList::CutOut;
    case SurfaceClass::Blended:
        break;
    }
    return split ? SurfaceList::Split : SurfaceList::Blended;
}

/// A mesh before it joins the world's arenas. `vertices`, `polygonIds` as in World.
struct MeshData {
    std::vector<MeshVertex> vertices;
    std::array<std::vector<std::uint32_t>, 4> indices; ///< by SurfaceList
    std::vector<std::uint16_t> polygonIds;

    [[nodiscard]] bool empty() const { return vertices.empty(); }
    [[nodiscard]] std::vector<std::uint32_t>& indicesOf(SurfaceList list) {
        return indices[static_cast<std::size_t>(list)];
    }
};

/// Collects polygons into a MeshData: two-sided ones twice, the second time reversed and with negated
/// normals.
class MeshBuilder {
public:
    /// `lists`: by surface slot.
    explicit MeshBuilder(std::vector<SurfaceList> lists) : lists_(std::move(lists)) {}

    /// A polygon of baked geometry, all its loops under one number.
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
