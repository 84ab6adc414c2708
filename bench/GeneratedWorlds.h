#pragma once

#include "worlds/Generated.h"
#include "visibility/Graph.h"
#include "visibility/View.h"
#include "world/World.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// Generates a world, writes it to a temporary directory and loads what a session there would: the landblocks
/// around its first place, or that block alone if it is a dungeon. Errors: of writing and of loading.
[[nodiscard]] Result<world::World> generatedWorld(const worlds::GeneratedSpec& spec);

/// The same world with every space a zone of its own, as if nothing could be merged.
[[nodiscard]] world::World apart(world::World world);

// Views of 90 by 60 degrees, the same for the same world and seed.

/// Eyes anywhere inside random cells, looking anywhere but steeply up or down.
[[nodiscard]] std::vector<visibility::View> viewsInCells(const world::World& world, std::size_t count,
                                                         std::uint32_t seed);

/// Eyes 1.7 m above the ground, up to 25 m from a random building portal, outside every cell, looking about level.
[[nodiscard]] std::vector<visibility::View> viewsOutdoors(const world::World& world, std::size_t count,
                                                          std::uint32_t seed);

/// Eyes in the cells behind random building portals, 0.3 to 1 m from the middle of the opening, looking out.
[[nodiscard]] std::vector<visibility::View> viewsAtWindows(const world::World& world, std::size_t count,
                                                           std::uint32_t seed);

} // namespace limen::bench
