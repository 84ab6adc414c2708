#pragma once

#include "worlds/builtin/places/Places.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Adds the models of leaves and panes, and makes the list of doors of `world.json`: the doors by name, then a pane
/// for every window of the village's buildings. Requires: the map's buildings are placed.
[[nodiscard]] nlohmann::ordered_json buildDoors(ModelWriter& sink, const VillageMap& map);

} // namespace limen::worlds
