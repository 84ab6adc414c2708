#pragma once

#include "demo/Building.h"
#include "demo/Effects.h"
#include "demo/Furniture.h"
#include "demo/OutdoorProps.h"
#include "demo/Places.h"
#include "demo/Plants.h"

namespace limen::demo {

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

} // namespace limen::demo
