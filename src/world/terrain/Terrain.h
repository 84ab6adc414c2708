#pragma once

#include "core/Assert.h"
#include "dat/records/Cells.h"
#include "dat/records/Landscape.h"
#include "world/Ground.h"
#include "world/mesh/MeshData.h"
#include "world/terrain/TerrainBlend.h"

#include <functional>
#include <optional>

namespace limen::world {

/// A block's ground: 9 x 9 vertices 24 m apart, index x*9 + y.
struct Ground {
    dat::BlockCoord coord;
    std::array<float, 81> heights{};       ///< metres
    std::array<std::uint16_t, 81> words{}; ///< road, type and scenery bits as in LandBlock

    [[nodiscard]] std::uint32_t road(int x, int y) const { return word(x, y) & 3u; }
    [[nodiscard]] std::uint32_t type(int x, int y) const { return (word(x, y) >> 2) & 31u; }
    [[nodiscard]] std::uint32_t scenery(int x, int y) const { return word(x, y) >> 11; }
    /// The corners of landcell (cellX, cellY), each 0..7.
    [[nodiscard]] CellCorners corners(int cellX, int cellY) const;

private:
    [[nodiscard]] std::uint32_t word(int x, int y) const {
        LIMEN_ASSERT(x >= 0 && y >= 0 && x <= 8 && y <= 8, "a vertex of the block");
        return words[static_cast<std::size_t>(x * 9 + y)];
    }
};
/// The ground at the heights of the records, on which scenery stands. Heights that are not finite become 0; others are clamped
/// to 100 km.
[[nodiscard]] Ground groundOf(const dat::LandBlock& record, const dat::Region& region);

/// Metres: the land is this much below the heights of the records (decision 194), so that floors at those heights cover it.
inline constexpr float kLandBelowHeights = 0.01f;
/// The height of the land for a height of the records.
[[nodiscard]] inline float landHeight(float height) {
    return height - kLandBelowHeights;
}
/// The ground with the heights of the land.
[[nodiscard]] Ground landOf(Ground ground);

/// Heights of the vertices of other blocks by global vertex, metres; no value for an unknown height.
using HeightLookup = std::function<std::optional<float>(int globalX, int globalY)>;

/// The block's mesh, block-local: two triangles a landcell, numbered landcell*2 and landcell*2 + 1. A normal
/// is the mean of the faces around its vertex, including faces of other blocks whose heights `neighbours`
/// knows.
[[nodiscard]] MeshData terrainMesh(const Ground& ground, const HeightLookup& neighbours);

} // namespace limen::world
