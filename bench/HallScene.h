#pragma once

#include "FloodScenes.h"

namespace limen::bench {

/// A level of halls cut finely: what a shooter's compiler makes of an arena.
struct HallSpec {
    std::uint32_t cells = 3364;
    std::uint32_t openings = 9705; ///< pairs of portals
    std::uint32_t halls = 3;       ///< convex, open from end to end
    std::uint32_t views = 1000;    ///< from random places in random cells, 90 by 60 degrees
    std::uint32_t seed = 1;
    bool merged = true; ///< one zone, as closed and disjoint cells would be loaded; else every cell its own
};

/// A box cut into halls by tilted planes and each hall into convex cells. Openings are whole faces that two cells share: inside
/// halls the largest, and one in twenty between halls.
[[nodiscard]] FloodScene hallScene(const HallSpec& spec);

} // namespace limen::bench
