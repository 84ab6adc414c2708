#pragma once

#include "worlds/builtin/dungeon/DungeonPlan.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The cave in the hillside and the dungeon behind it, in one plan: the mouth at the origin, looking south; cells in the
/// order of the cave from the mouth inwards, then the dungeon's.
struct CavePlan {
    BuildingPlan building;
    DungeonParts parts;
    std::size_t chamber = 0; ///< the cave's wide part
};
[[nodiscard]] CavePlan planCave(ModelWriter& sink, const DungeonProps& props);

/// How far the mouth's floor lies above the level ground before it, metres.
inline constexpr double kCaveSill = 0.3125;
/// The middle of the chamber's floor.
inline constexpr double kChamberX = -1.0, kChamberY = 20.0, kChamberFloor = -4.0;

} // namespace limen::worlds
