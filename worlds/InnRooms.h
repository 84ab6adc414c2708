#pragma once

#include "worlds/Building.h"
#include "worlds/Furniture.h"

namespace limen::worlds {

/// The inn's openings in its outer walls.
[[nodiscard]] std::vector<Opening> innDoors();
[[nodiscard]] std::vector<Opening> innWindows();

/// The inn's cells in the order of InnCell.
[[nodiscard]] std::vector<CellPlan> planInnRooms(ModelSink& sink, const Furniture& furniture);

} // namespace limen::worlds
