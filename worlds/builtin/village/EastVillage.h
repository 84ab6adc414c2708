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

/// Puts a model on the ground at a point of the village block.
void stand(LandblockWriter& block, dat::RecordId model, double x, double y, double turn);

/// Adds the inn, the meeting hall, props around them, doors and people of the village. Fills the rest of the
/// map. Requires: the map's cottages are placed.
void addEastVillage(ModelWriter& writer, LandblockWriter& block, const VillageModels& models,
                    VillageMap& map);

} // namespace limen::worlds
