#pragma once

#include "dat/records/Cells.h"
#include "dat/records/Landscape.h"
#include "world/MeshBuilder.h"
#include "world/TerrainBlend.h"

#include <functional>

namespace limen::world {

inline constexpr double kLandcellSize = 24.0;

/// A block's ground: 9x9 vertices 24 m apart, index x*9 + y.
struct Ground {
    dat::BlockCoord coord;
    std::array<float, 81> heights{};
    std::array<std::uint16_t, 81> words{}; ///< road, type and scenery bits as in LandBlock

    [[nodiscard]] std::uint32_t road(int x, int y) const {
        return words[static_cast<std::size_t>(x * 9 + y)] & 3u;
    }
    [[nodiscard]] std::uint32_t type(int x, int y) const {
        return (words[static_cast<std::size_t>(x * 9 + y)] >> 2) & 31u;
    }
    [[nodiscard]] std::uint32_t scenery(int x, int y) const {
        return words[static_cast<std::size_t>(x * 9 + y)] >> 11;
    }
    [[nodiscard]] CellCorners corners(int cellX, int cellY) const;
};
[[nodiscard]] Ground groundOf(const dat::LandBlock& record, const dat::Region& region);

/// Which way a landcell of a block is cut.
[[nodiscard]] bool splitsSouthWestNorthEast(dat::BlockCoord block, int cellX, int cellY);

/// The plane of the ground's triangle under a block-local position; positions outside 0..192 are clamped into
/// it. `heights`: 81, as in Block::heights.
struct GroundPoint {
    double z = 0.0;
    Vec3 normal{0.0, 0.0, 1.0};
};
[[nodiscard]] GroundPoint groundAt(dat::BlockCoord block, std::span<const float> heights, double x, double y);

/// Heights of the vertices of other blocks, by global vertex; no value where nothing is known.
using HeightLookup = std::function<std::optional<float>(int globalX, int globalY)>;

/// The block's mesh, block-local: per landcell two triangles, numbered landcell*2 and landcell*2 + 1. Normals
/// are the means of the faces around each vertex, across the block's border too where `neighbours` knows the
/// heights.
[[nodiscard]] MeshData terrainMesh(const Ground& ground, const HeightLookup& neighbours);

} // namespace limen::world
