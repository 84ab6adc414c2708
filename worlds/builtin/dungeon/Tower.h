#pragma once

#include "worlds/builtin/dungeon/DungeonProps.h"
#include "worlds/records/CellPlan.h"
#include "worlds/shapes/CellComplex.h"

namespace limen::worlds {

/// An eight-sided tower of three rooms, one above the other. In its coordinates the middle is the origin, z =
/// 0 the ground floor; the door is in the south. A winding stair goes up through eight-sided openings in the
/// floors; the last one leads outside onto the roof. Cells from below: room, hatch, room, hatch, room.
[[nodiscard]] BuildingPlan planTower(ModelWriter& writer, const DungeonProps& props);

inline constexpr double kTowerStorey = 4.75;                  ///< from floor to floor
inline constexpr double kTowerRoof = 3.0 * kTowerStorey;      ///< height of the roof's surface
inline constexpr double kTowerWall = 4.25, kTowerOuter = 5.0; ///< from the middle to the walls' faces
inline constexpr double kTowerSill = 0.375;                   ///< height of the ground floor above the ground
inline constexpr double kStairRadius = 1.05;                  ///< radius of the path on the stair
/// The angle (radians, counter-clockwise from east) of the step at height z of the winding stair.
[[nodiscard]] double stairAngle(double z);

} // namespace limen::worlds
