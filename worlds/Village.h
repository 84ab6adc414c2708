#pragma once

#include "worlds/Models.h"
#include "worlds/Places.h"
#include "worlds/Plants.h"

namespace limen::worlds {

/// Builds the village block: both cottages and what stands in their yards. Returns where things are.
[[nodiscard]] VillageMap addVillage(ModelSink& sink, const Plants& plants);

} // namespace limen::worlds
