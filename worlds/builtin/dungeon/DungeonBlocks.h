#pragma once

#include "worlds/builtin/dungeon/DungeonPlan.h"
#include "worlds/builtin/land/Plants.h"

namespace limen::worlds {

/// A landblock without land, far from all others: heights are all 0; it has cells and no building.
inline constexpr dat::BlockCoord kSealedBlock{0x01, 0x10};

/// The placements of tower, cave and dungeons (coordinates of their landblocks), and their cells.
struct DungeonMap {
    Placement tower, cave, sealed;
    std::vector<dat::RecordId> towerCells, caveCells, sealedCells;
    DungeonParts parts;      ///< indices in caveCells
    std::size_t chamber = 0; ///< index in caveCells
};

/// Builds the landblocks of the tower, of the cave with the dungeon behind it, and of the sealed dungeon.
[[nodiscard]] DungeonMap addDungeonBlocks(ModelWriter& writer, const Furniture& furniture,
                                          const Plants& plants);

} // namespace limen::worlds
