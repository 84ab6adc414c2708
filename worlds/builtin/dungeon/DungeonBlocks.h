#pragma once

#include "worlds/builtin/dungeon/DungeonPlan.h"
#include "worlds/builtin/land/Plants.h"

namespace limen::worlds {

/// A landblock of nothing but cells, far from all others: heights all 0, no building.
inline constexpr dat::BlockCoord kSealedBlock{0x01, 0x10};

/// Where tower, cave and dungeons stand (coordinates of their landblocks), and their cells.
struct DungeonMap {
    Placement tower, cave, sealed;
    std::vector<dat::RecordId> towerCells, caveCells, sealedCells;
    DungeonParts parts;      ///< places in caveCells
    std::size_t chamber = 0; ///< likewise
};

/// Builds the landblocks of the tower, of the cave with the dungeon behind it, and of the sealed dungeon.
[[nodiscard]] DungeonMap addDungeonBlocks(ModelWriter& sink, const Furniture& furniture,
                                          const Plants& plants);

} // namespace limen::worlds
