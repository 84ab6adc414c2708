#pragma once

#include "worlds/builtin/effects/Effects.h"
#include "worlds/builtin/places/Places.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Adds the villagers' models and fills the map's routes and villagers. Requires: the map's buildings are
/// placed.
void addFolk(ModelWriter& writer, const Effects& effects, VillageMap& map);

/// The torches beside the meeting hall's door, in the hall's coordinates. Their backs face +x.
[[nodiscard]] std::vector<Vec3> hallTorches();

} // namespace limen::worlds
