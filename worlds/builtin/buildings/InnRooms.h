#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/shapes/RoomPlan.h"

namespace limen::worlds {

/// The inn's openings in its outer walls.
[[nodiscard]] std::vector<Opening> innDoors();
[[nodiscard]] std::vector<Opening> innWindows();

/// The inn's cells in the order of InnCell.
[[nodiscard]] std::vector<CellPlan> planInnRooms(ModelWriter& writer, const Furniture& furniture);

} // namespace limen::worlds
