#pragma once

#include "worlds/Effects.h"
#include "worlds/Models.h"
#include "worlds/Places.h"

namespace limen::worlds {

/// Adds the villagers' models and fills the map's routes and villagers. Requires: the map's buildings are
/// placed.
void addFolk(ModelSink& sink, const Effects& effects, VillageMap& map);

/// Where torches hang beside the meeting hall's door; coordinates of the hall, their backs towards +x.
[[nodiscard]] std::vector<Vec3> hallTorches();

} // namespace limen::worlds
