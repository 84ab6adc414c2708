#pragma once

#include "worlds/generate/DungeonShapes.h"
#include "worlds/generate/Props.h"
#include "worlds/generate/WorldNotes.h"

namespace limen::worlds {

/// Leaves for the doors of dungeons, by the openings they fit.
struct DungeonLeaves {
    dat::RecordId narrow = 0, half = 0, glass = 0;
};
[[nodiscard]] DungeonLeaves addDungeonLeaves(ModelWriter& sink);

/// What landblocks of dungeons are made of, and written into.
struct DungeonTools {
    ModelWriter& sink;
    DungeonShapes& shapes;
    const Props& props;
    const DungeonLeaves& leaves;
};

/// Adds a landblock that is all dungeon: its cells, its LandBlock, whose heights are all 0, and its LandBlockInfo.
void writeDungeonBlock(const DungeonTools& tools, dat::BlockCoord coord, const DungeonLayout& layout,
                       Random random, WorldNotes& notes);

} // namespace limen::worlds
