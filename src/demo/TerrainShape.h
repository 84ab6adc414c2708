#pragma once

#include "dat/Ids.h"
#include "dat/records/Landscape.h"
#include "demo/WorldRecords.h"

namespace limen::demo {

/// The ground of the built-in world: kBlocksAcross² landblocks from kSouthWest on. Vertices are counted from
/// the south-west corner of the area, 24 m apart; metres likewise.
inline constexpr dat::BlockCoord kSouthWest{0xA8, 0xB3};
inline constexpr int kBlocksAcross = 3;
inline constexpr int kCellsPerBlock = 8;
inline constexpr int kVertices = kBlocksAcross * kCellsPerBlock + 1;
inline constexpr double kLandcell = 24.0;
inline constexpr dat::BlockCoord kVillage{kSouthWest.x + 1, kSouthWest.y + 1};

/// Terrain types used (landscape.md), and the scenes that grow on them: index into a type's list of scene
/// types.
enum class TerrainKind : std::uint8_t {
    BarrenRock = 0x00,
    Grassland = 0x01,
    LushGrass = 0x03,
    PackedDirt = 0x07,
    PatchyGrass = 0x09,
    ForestFloor = 0x15,
    Moss = 0x1C
};

/// The Region's table: 256 heights in metres, finer steps below than above; multiples of 1/64 m.
[[nodiscard]] double heightOfIndex(int index);
/// The level, on the table, of the ground around both cottages.
[[nodiscard]] double siteLevel();

/// Height (metres) of the ground at a point of the area, by the triangle there.
[[nodiscard]] double groundHeight(double x, double y);

/// The vertices the lane runs through, from the hill in the north-west to the south-east; consecutive ones
/// are neighbours along an edge or a diagonal.
[[nodiscard]] std::vector<std::pair<int, int>> lanePath();

/// Metres from the area's south-west corner to metres on the map.
[[nodiscard]] Vec3 toGlobal(const Vec3& area);

/// Adds the LandBlocks; those of `withObjects` have a LandBlockInfo.
void addLandBlocks(WorldRecords& records, const std::vector<dat::BlockCoord>& withObjects);

} // namespace limen::demo
