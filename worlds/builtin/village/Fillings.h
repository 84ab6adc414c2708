#pragma once

#include "worlds/builtin/places/Places.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Adds the models of leaves and panes. Returns the doors of `world.json`: named doors, then a pane for every
/// window of the village's buildings. Requires: the map's buildings are placed.
[[nodiscard]] nlohmann::ordered_json buildDoors(ModelWriter& writer, const VillageMap& map);

} // namespace limen::worlds
