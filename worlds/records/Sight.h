#pragma once

#include "geometry/Plane.h"

#include <vector>

namespace limen::worlds {

/// Convex cells and the openings between them, for tests of visibility.
struct SightMap {
    static constexpr std::size_t kOutside = 0xFFFF;
    struct Portal {
        std::vector<Vec3> points;
        std::size_t to = kOutside;
    };
    struct Cell {
        std::vector<Plane> planes; ///< of the shell, interior in front
        std::vector<Portal> portals;
    };
    std::vector<Cell> cells;
};

/// True if some ray from inside the cell reaches the outside. Sampled by rays from a grid of points on the
/// cell's own openings to a grid of points on every opening that leads outside.
[[nodiscard]] bool seesOutside(const SightMap& map, std::size_t cell);

/// seesOutside of every cell. Samples only neighbours of cells that see outside, because every ray passes
/// such a cell.
[[nodiscard]] std::vector<bool> cellsThatSeeOutside(const SightMap& map);

} // namespace limen::worlds
