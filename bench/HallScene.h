#pragma once

#include "FloodScenes.h"

namespace limen::bench {

/// A level of halls that are cut into many cells, like an arena after the map compiler of a shooter.
struct HallSpec {
    std::uint32_t cells = 3364;
    std::uint32_t openings = 9705; ///< pairs of portals
    std::uint32_t halls = 3;       ///< convex, without walls inside
    std::uint32_t views = 1000;    ///< from random positions in random cells, 90 by 60 degrees
    std::uint32_t seed = 1;
    bool merged = true; ///< one zone, as the loader merges closed, disjoint cells; else a zone for each cell
};

/// A box that tilted planes cut into halls, and each hall into convex cells. Openings are whole faces between
/// two cells: the largest faces inside of halls, and one opening in twenty between halls.
[[nodiscard]] FloodScene hallScene(const HallSpec& spec);

} // namespace limen::bench
