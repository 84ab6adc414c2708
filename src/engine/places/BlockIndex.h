#pragma once

#include "dat/Archive.h"

#include <vector>

namespace limen::engine {

/// The content of one landblock as far as the index and its LandBlockInfo show it.
struct BlockFacts {
    dat::BlockCoord coord;
    bool hasLand = false;
    std::uint32_t cells = 0;
    dat::RecordId firstCell = 0;
    std::uint32_t buildings = 0;
    std::uint32_t doors = 0; ///< portals of its buildings
    Vec3 middle{0.0};        ///< of its buildings, global
};
/// All blocks of an archive, ascending by block word. Cost: the whole index of the cell file, and the
/// LandBlockInfo records. Errors: a damaged index.
[[nodiscard]] Result<std::vector<BlockFacts>> readBlockIndex(const dat::Archive& archive);

/// Buildings of blocks that touch each other.
struct Town {
    std::vector<std::size_t> blocks; ///< indices of BlockFacts, the one with most buildings first
    std::uint32_t buildings = 0;
    Vec3 middle{0.0}; ///< of all buildings
};
/// Groups of neighbouring blocks with buildings, the largest first. A group spans at most 5 x 5 blocks;
/// otherwise a chain of farms along a road would be one town.
[[nodiscard]] std::vector<Town> findTowns(const std::vector<BlockFacts>& blocks);

/// The middle of the blocks with land; the middle of the map without any.
[[nodiscard]] Vec3 middleOfLand(const std::vector<BlockFacts>& blocks);

} // namespace limen::engine
