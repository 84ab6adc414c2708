#pragma once

#include "worlds/Models.h"
#include "worlds/Places.h"

namespace limen::worlds {

/// Adds the models of leaves and panes, and makes the list of doors of `world.json`: the doors by name, then a pane
/// for every window of the village's buildings. Requires: the map's buildings are placed.
[[nodiscard]] nlohmann::ordered_json buildDoors(ModelSink& sink, const VillageMap& map);

} // namespace limen::worlds
