#pragma once

#include "dat/Ids.h"
#include "dat/records/Landscape.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// The ground of the built-in world: kBlocksAcross² landblocks around the village. Vertices, 24 m apart, and metres
/// of the area are counted from the south-west corner of kSouthWest, the village's neighbour; kBlocksBeyond more
/// landblocks lie to the west and south of it, at negative coordinates.
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

/// Terrain types used (landscape.md), and the scenes that grow on them: index into a type's list of scene
/// types.
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

/// The Region's table: 256 heights in metres, finer steps below than above; multiples of 1/64 m.
[[nodiscard]] double heightOfIndex(int index);
/// The level, on the table, of the ground around both cottages.
[[nodiscard]] double siteLevel();
/// The levels of the ground around the tower and before the cave.
[[nodiscard]] double towerLevel();
[[nodiscard]] double caveLevel();

/// Height (metres) of the ground at a point of the area, by the triangle there.
[[nodiscard]] double groundHeight(double x, double y);

/// Vertices that a way runs through; consecutive ones are neighbours along an edge or a diagonal.
using VertexPath = std::vector<std::pair<int, int>>;
/// The part of the lane near the village, from the hill in the north-west to the south-east.
[[nodiscard]] VertexPath lanePath();
/// The whole lane, from border to border, and the tracks that leave it for the tower and the cave.
[[nodiscard]] VertexPath wholeLane();
[[nodiscard]] VertexPath towerTrack();
[[nodiscard]] VertexPath caveTrack();

/// A point above a vertex of the ground; global metres.
[[nodiscard]] Vec3 overVertex(std::pair<int, int> vertex, double height);

/// Metres of the area to metres on the map.
[[nodiscard]] Vec3 toGlobal(const Vec3& area);
/// Metres of a landblock to metres of the area.
[[nodiscard]] Vec3 toArea(dat::BlockCoord block, const Vec3& local);

/// Adds the LandBlocks; those of `withObjects` have a LandBlockInfo.
void addLandBlocks(WorldRecords& records, const std::vector<dat::BlockCoord>& withObjects);

} // namespace limen::worlds
