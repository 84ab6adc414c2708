#pragma once

#include "visibility/Graph.h"
#include "visibility/View.h"
#include "world/World.h"
#include "worlds/Generated.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// Generates a world in a temporary directory and loads the part that a session would load: the landblocks
/// around its first place, or only that block if it is a dungeon. Errors: those of writing and of loading.
[[nodiscard]] Result<world::World> generatedWorld(const worlds::GeneratedSpec& spec);

/// The same world with a zone for each space, as if no cells could be merged.
[[nodiscard]] world::World apart(world::World world);

// Views of 90 by 60 degrees. Equal worlds and seeds give equal views.

/// Eyes at random positions in random cells; random directions that are not steep.
[[nodiscard]] std::vector<visibility::View> viewsInCells(const world::World& world, std::size_t count,
                                                         std::uint32_t seed);

/// Eyes outside of all cells, 1.7 m above the ground, up to 25 m from a random building portal; nearly level
/// directions.
[[nodiscard]] std::vector<visibility::View> viewsOutdoors(const world::World& world, std::size_t count,
                                                          std::uint32_t seed);

/// Eyes in the cells behind random building portals, 0.3 to 1 m from the middle of the opening, that look
/// out.
[[nodiscard]] std::vector<visibility::View> viewsAtWindows(const world::World& world, std::size_t count,
                                                           std::uint32_t seed);

} // namespace limen::bench
