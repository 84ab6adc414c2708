#pragma once

#include "worlds/builtin/buildings/Furniture.h"
#include "worlds/builtin/effects/Effects.h"
#include "worlds/builtin/land/Plants.h"
#include "worlds/builtin/places/Places.h"
#include "worlds/builtin/village/OutdoorProps.h"
#include "worlds/records/LandblockWriter.h"

namespace limen::worlds {

struct VillageModels {
    const Furniture& furniture;
    const OutdoorProps& props;
    const Plants& plants;
    const Effects& effects;
};

/// Stands a model on the ground at the village block's coordinates.
void stand(LandblockWriter& block, dat::RecordId model, double x, double y, double turn);

/// Adds the inn, the meeting hall, what stands around them, and everything that moves in the village. Requires: the
/// map's cottages are placed. Fills the rest of the map.
void addEastVillage(ModelWriter& sink, LandblockWriter& block, const VillageModels& models, VillageMap& map);

} // namespace limen::worlds
