#pragma once

#include "worlds/Building.h"
#include "worlds/Effects.h"
#include "worlds/Furniture.h"
#include "worlds/OutdoorProps.h"
#include "worlds/Places.h"
#include "worlds/Plants.h"

namespace limen::worlds {

struct VillageModels {
    const Furniture& furniture;
    const OutdoorProps& props;
    const Plants& plants;
    const Effects& effects;
};

/// Stands a model on the ground at the village block's coordinates.
void stand(BlockBuilder& block, dat::RecordId model, double x, double y, double turn);

/// Adds the inn, the meeting hall, what stands around them, and everything that moves in the village. Requires: the
/// map's cottages are placed. Fills the rest of the map.
void addEastVillage(ModelSink& sink, BlockBuilder& block, const VillageModels& models, VillageMap& map);

} // namespace limen::worlds
