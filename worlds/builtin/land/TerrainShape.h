#pragma once

#include "dat/Ids.h"
#include "dat/records/Landscape.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// The ground of the built-in world: kBlocksAcross² landblocks around the village. Vertices (24 m apart) and
/// metres of the area count from the south-west corner of kSouthWest, the village's neighbour. kBlocksBeyond
/// more landblocks, to the west and south, have negative coordinates.
inline constexpr dat::BlockCoord kSouthWest{0xA8, 0xB3};
inline constexpr int kBlocksBeyond = 1;
inline constexpr int kBlocksAcross = 5;
inline constexpr int kCellsPerBlock = 8;
inline constexpr int kFirstVertex = -kBlocksBeyond * kCellsPerBlock;
inline constexpr int kLastVertex = (kBlocksAcross - kBlocksBeyond) * kCellsPerBlock;
inline constexpr double kLandcell = 24.0;
inline constexpr double kBlockMetres = kLandcell * kCellsPerBlock; ///< metres
inline constexpr dat::BlockCoord kVillage{kSouthWest.x + 1, kSouthWest.y + 1};
inline constexpr dat::BlockCoord kTowerBlock{kVillage.x, kVillage.y + 1};
inline constexpr dat::BlockCoord kCaveBlock{kVillage.x + 1, kVillage.y + 1};

/// The terrain types in use (docs/formats/landscape.md#terrain-types).
enum class TerrainKind : std::uint8_t {
    BarrenRock = 0x00,
    Grassland = 0x01,
    LushGrass = 0x03,
    PackedDirt = 0x07,
    PatchyGrass = 0x09,
    RunningWater = 0x10,
    ForestFloor = 0x15,
    Moss = 0x1C
};

/// The Region's table: 256 heights in metres, multiples of 1/64 m; steps are finer at the lower end.
[[nodiscard]] double heightOfIndex(int index);
/// The height of the ground around both cottages, metres.
[[nodiscard]] double siteLevel();
/// The heights of the ground around the tower and before the cave, metres.
[[nodiscard]] double towerLevel();
[[nodiscard]] double caveLevel();

/// The height (metres) of the records' triangle at a point of the area.
[[nodiscard]] double groundHeight(double x, double y);
/// The height at which the land is drawn and walked there: docs/formats/landscape.md#drawing-the-ground.
[[nodiscard]] double landHeight(double x, double y);

/// A path through vertices; consecutive ones are neighbours along an edge or a diagonal.
using VertexPath = std::vector<std::pair<int, int>>;
/// The part of the lane near the village, from the hill in the north-west to the south-east.
[[nodiscard]] VertexPath lanePath();
/// The whole lane, from border to border, and the tracks that leave it for the tower and the cave.
[[nodiscard]] VertexPath wholeLane();
[[nodiscard]] VertexPath towerTrack();
[[nodiscard]] VertexPath caveTrack();

/// A point above a vertex of the ground; global metres.
[[nodiscard]] Vec3 overVertex(std::pair<int, int> vertex, double height);

/// Converts metres of the area to global metres.
[[nodiscard]] Vec3 toGlobal(const Vec3& area);
/// Converts metres of a landblock to metres of the area.
[[nodiscard]] Vec3 toArea(dat::BlockCoord block, const Vec3& local);

/// Adds the LandBlocks; those of `withObjects` have a LandBlockInfo.
void addLandBlocks(WorldRecords& records, const std::vector<dat::BlockCoord>& withObjects);

} // namespace limen::worlds
