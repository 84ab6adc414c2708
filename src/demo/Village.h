#pragma once

#include "demo/Models.h"
#include "demo/Places.h"
#include "demo/Plants.h"

namespace limen::demo {

/// Builds the village block: both cottages and what stands in their yards. Returns where things are.
[[nodiscard]] VillageMap addVillage(ModelSink& sink, const Plants& plants);

} // namespace limen::demo
