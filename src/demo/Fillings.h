#pragma once

#include "demo/Models.h"
#include "demo/Places.h"

namespace limen::demo {

/// Adds the models of leaves and panes, and makes the list of doors of `world.json`: the doors by name, then a pane
/// for every window of the village's buildings. Requires: the map's buildings are placed.
[[nodiscard]] nlohmann::ordered_json buildDoors(ModelSink& sink, const VillageMap& map);

} // namespace limen::demo
