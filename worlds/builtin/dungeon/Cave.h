#pragma once

#include "worlds/builtin/dungeon/DungeonPlan.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The cave in the hillside and the dungeon behind it, in one plan. The mouth is at the origin and looks
/// south. Cells are in this order: the cave from the mouth inwards, then the dungeon.
struct CavePlan {
    BuildingPlan building;
    DungeonParts parts;
    std::size_t chamber = 0; ///< index of the cave's wide part
};
[[nodiscard]] CavePlan planCave(ModelWriter& writer, const DungeonProps& props);

/// Metres from the level ground in front of the mouth up to the mouth's floor.
inline constexpr double kCaveSill = 0.3125;
/// The middle of the chamber's floor, metres.
inline constexpr double kChamberX = -1.0, kChamberY = 20.0, kChamberFloor = -4.0;

} // namespace limen::worlds
