#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The cottage north of the lane: front room with the front door, rear room with a window in line with it,
/// stairs down to a cellar. Cells in the order of CottageCell.
enum class CottageCell : std::uint32_t { Front, Doorway, Rear, Stairwell, CellarDoorway, Cellar };
[[nodiscard]] BuildingPlan planCottage(ModelWriter& writer, const Furniture& furniture);

/// The neighbour's cottage across the lane: a room with door and windows, a back room with a window in line
/// with the door.
enum class NeighbourCell : std::uint32_t { Room, Doorway, BackRoom };
[[nodiscard]] BuildingPlan planNeighbour(ModelWriter& writer, const Furniture& furniture);

/// Metres from the level ground up to the ground floors.
inline constexpr double kFloorAboveGround = 0.375;

/// The cottage's stairs, for walks (building coordinates).
inline constexpr double kStairsX = -1.3, kStairsTopY = 5.9, kStairsRun = 2.64, kStairsDrop = 2.6;

} // namespace limen::worlds
