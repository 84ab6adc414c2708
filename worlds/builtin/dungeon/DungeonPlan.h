#pragma once

#include "worlds/builtin/dungeon/DungeonProps.h"
#include "worlds/records/CellPlan.h"
#include "worlds/shapes/CellComplex.h"

namespace limen::worlds {

/// Indices of cells in a complex, for places and walks.
struct DungeonParts {
    std::size_t hub = 0;
    std::size_t crypt = 0, wrap = 0, wrapCount = 0; ///< crypt, and the corridor that overlaps it
    std::size_t recess = 0, yard = 0;               ///< U-shaped room, and the yard between its arms
    std::size_t longCorridor = 0, longCorridorCount = 0;
    std::size_t pit = 0, pitCount = 0; ///< shaft, from its bottom up
    std::size_t gallery = 0;           ///< eastern gallery of the highest floor
    std::size_t anteroom = 0;          ///< behind the hub's two northern doors
};

/// The dungeon has the coordinates of the cave: the mouth at the origin, north inwards. The hub's middle is
/// at (0, kHubY), its floor at kDungeonFloor. The entrance is a rock tunnel that ends at (0, kEntranceY,
/// kDungeonFloor).
inline constexpr double kHubY = 80.0, kDungeonFloor = -16.0, kEntranceY = 52.0;
/// The pit's middle.
inline constexpr double kPitX = -52.0, kPitY = kHubY;

/// The outline of the rock tunnel in the plane y = `y`: around x, its floor at z.
[[nodiscard]] Outline tunnelOutline(double x, double y, double z);

/// Adds the dungeon behind `entrance`, the cell that ends with the tunnel's outline at kEntranceY.
[[nodiscard]] DungeonParts addDungeonCells(CellComplex& complex, ModelWriter& writer,
                                           const DungeonProps& props, std::size_t entrance);

/// An isolated small ring of rooms, around its own origin. The first cell is the hall.
[[nodiscard]] std::vector<CellPlan> planSealedDungeon(ModelWriter& writer, const DungeonProps& props);

} // namespace limen::worlds
