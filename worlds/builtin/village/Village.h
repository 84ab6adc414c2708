#pragma once

#include "worlds/builtin/land/Plants.h"
#include "worlds/builtin/places/Places.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Builds the village block: both cottages and what stands in their yards. Returns where things are.
[[nodiscard]] VillageMap addVillage(ModelWriter& sink, const Plants& plants);

} // namespace limen::worlds
