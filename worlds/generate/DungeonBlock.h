#pragma once

#include "worlds/generate/DungeonShapes.h"
#include "worlds/generate/Props.h"
#include "worlds/generate/WorldNotes.h"

namespace limen::worlds {

/// Models of door leaves, by the opening that they fit.
struct DungeonLeaves {
    dat::RecordId narrow = 0, half = 0, glass = 0;
};
[[nodiscard]] DungeonLeaves addDungeonLeaves(ModelWriter& writer, bool furnished);

/// The models and shapes of dungeons, and the writer of models.
struct DungeonTools {
    ModelWriter& writer;
    DungeonShapes& shapes;
    const Props& props;
    const DungeonLeaves& leaves;
};

/// Adds a landblock without land: cells, a LandBlock whose heights are all 0, and a LandBlockInfo.
void writeDungeonBlock(const DungeonTools& tools, dat::BlockCoord coord, const DungeonLayout& layout,
                       Random random, WorldNotes& notes);

} // namespace limen::worlds
