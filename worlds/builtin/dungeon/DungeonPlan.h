#pragma once

#include "worlds/builtin/dungeon/DungeonProps.h"
#include "worlds/records/CellPlan.h"
#include "worlds/shapes/CellComplex.h"

namespace limen::worlds {

/// Where in a complex of cells things are, for whoever goes there.
struct DungeonParts {
    std::size_t hub = 0;
    std::size_t crypt = 0, wrap = 0, wrapCount = 0; ///< the crypt, and the corridor that overlaps it
    std::size_t recess = 0, yard = 0; ///< the U-shaped room and the shaft of light it wraps around
    std::size_t longCorridor = 0, longCorridorCount = 0;
    std::size_t pit = 0, pitCount = 0; ///< the shaft, from its bottom up
    std::size_t gallery = 0;           ///< the eastern one, highest floor
    std::size_t anteroom = 0;          ///< behind the hub's two northern doors
};

/// The dungeon's own coordinates are the cave's: the mouth at the origin, north inwards. The hub's middle is at
/// (0, kHubY), its floor at kDungeonFloor; the entrance is a rock tunnel that ends at (0, kEntranceY, kDungeonFloor).
inline constexpr double kHubY = 80.0, kDungeonFloor = -16.0, kEntranceY = 52.0;
/// The pit's middle.
inline constexpr double kPitX = -52.0, kPitY = kHubY;

/// The outline of the rock tunnel at its end, y = `y`, floor at z around x.
[[nodiscard]] Outline tunnelOutline(double x, double y, double z);

/// Builds the dungeon behind `entrance`, the cell that ends with the tunnel's outline at kEntranceY.
[[nodiscard]] DungeonParts addDungeonCells(CellComplex& complex, ModelWriter& sink, const DungeonProps& props,
                                           std::size_t entrance);

/// A small ring of rooms that nothing else leads to, around its own origin. The first cell is the hall.
[[nodiscard]] std::vector<CellPlan> planSealedDungeon(ModelWriter& sink, const DungeonProps& props);

} // namespace limen::worlds
