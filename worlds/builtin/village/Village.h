#pragma once

#include "worlds/builtin/land/Plants.h"
#include "worlds/builtin/places/Places.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Adds the village block: both cottages and their yards, inn, hall and people. Returns the placements.
[[nodiscard]] VillageMap addVillage(ModelWriter& writer, const Plants& plants);

} // namespace limen::worlds
