#pragma once

#include "dat/Ids.h"
#include "world/World.h"

#include <optional>
#include <vector>

namespace limen::viewer {

/// The loaded content of a landblock.
struct ResidentBlock {
    enum class State : std::uint8_t {
        Absent, ///< not loaded, or beyond the map
        Loaded
    };
    dat::BlockCoord coord;
    State state = State::Absent;
    bool hasTerrain = false;
    std::uint32_t cells = 0;
    std::uint32_t buildingPortals = 0; ///< portals from outside into its buildings
    bool holdsEye = false, holdsPlayer = false;
};

/// A square of landblocks in rows from the north-west corner; north is up. Blocks beyond the edge of the map
/// are Absent.
struct ResidencyMap {
    int side = 0; ///< blocks per row, and number of rows
    std::vector<ResidentBlock> blocks;
    // Totals of everything loaded, also outside the square:
    std::uint32_t loaded = 0, terrains = 0, cells = 0, buildingPortals = 0;
};

/// The square of `radius` blocks on each side of the eye's block. `eye` and `player` are the blocks that
/// contain them.
[[nodiscard]] ResidencyMap residencyMap(const world::World& world, dat::BlockCoord eye,
                                        dat::BlockCoord player, int radius);

/// The block of a position: the block of its cell, or outside the block below it.
[[nodiscard]] dat::BlockCoord blockOf(const world::World& world, world::SpaceIndex space, const Vec3& at);

} // namespace limen::viewer
