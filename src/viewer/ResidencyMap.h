#pragma once

#include "dat/Ids.h"
#include "world/World.h"

#include <optional>
#include <vector>

namespace limen::viewer {

/// What of a landblock is in memory.
struct ResidentBlock {
    enum class State : std::uint8_t {
        Absent, ///< not loaded, or there is no such block
        Loaded
    };
    dat::BlockCoord coord;
    State state = State::Absent;
    bool hasTerrain = false;
    std::uint32_t cells = 0;
    std::uint32_t buildingPortals = 0; ///< from outside into its buildings
    bool holdsEye = false, holdsPlayer = false;
};

/// The landblocks around one of them, from the north-west corner on, row by row: north is up. Blocks beyond the edge of the map are Absent.
struct ResidencyMap {
    int side = 0; ///< blocks a row, and rows
    std::vector<ResidentBlock> blocks;
    // Of all that is loaded, also beyond the map:
    std::uint32_t loaded = 0, terrains = 0, cells = 0, buildingPortals = 0;
};

/// The map of `radius` blocks each way around the block of the eye. `eye` and `player`: the blocks that these are in.
[[nodiscard]] ResidencyMap residencyMap(const world::World& world, dat::BlockCoord eye,
                                        dat::BlockCoord player, int radius);

/// The block that something in a space belongs to: its cell's, or outside the one it is above.
[[nodiscard]] dat::BlockCoord blockOf(const world::World& world, world::SpaceIndex space, const Vec3& at);

} // namespace limen::viewer
