#pragma once

#include "demo/Building.h"
#include "demo/Furniture.h"

namespace limen::demo {

/// The inn's openings in its outer walls.
[[nodiscard]] std::vector<Opening> innDoors();
[[nodiscard]] std::vector<Opening> innWindows();

/// The inn's cells in the order of InnCell.
[[nodiscard]] std::vector<CellPlan> planInnRooms(ModelSink& sink, const Furniture& furniture);

} // namespace limen::demo
