#pragma once

#include "world/World.h"

#include <array>
#include <cstdint>
#include <vector>

namespace limen::world {

/// The order of a mesh's index lists: by SurfaceClass; of the blended triangles, those with Material::kSplit
/// come first.
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

/// A mesh before it joins the world's arenas. `vertices` and `polygonIds` have the layout they have in World.
struct MeshData {
    std::vector<MeshVertex> vertices;
    std::array<std::vector<std::uint32_t>, 4> indices; ///< by SurfaceList
    std::vector<std::uint16_t> polygonIds;
    std::vector<std::uint16_t> inOpenings; ///< numbers of polygons that are portal polygons, ascending

    [[nodiscard]] bool empty() const { return vertices.empty(); }
    [[nodiscard]] std::vector<std::uint32_t>& indicesOf(SurfaceList list) {
        return indices[static_cast<std::size_t>(list)];
    }
};

/// A copy whose triangles are all blended, for bodies and particles that fade. None is in the split list, so
/// all of them are drawn in the same pass at every opacity.
[[nodiscard]] MeshData blendedMesh(const MeshData& mesh);

/// A rectangle in the plane y = 0 that faces -y. `low` and `high` are its x and z limits in metres. Seen from
/// -y, u runs to the right and v downwards.
[[nodiscard]] MeshData spriteMesh(SurfaceList surfaces, const Vec2f& low, const Vec2f& high);

} // namespace limen::world
