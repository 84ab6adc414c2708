#pragma once

#include "geometry/Tolerances.h"
#include "world/block/BlockContent.h"

namespace limen::world {

/// True if a plane that is parallel to a face of either cell, or to an edge of each, separates their vertices
/// up to kOverlapTolerance. Never true for cells that overlap more. May be false for disjoint cells that wind
/// around each other.
/// Ref: the separating axis theorem (Gottschalk 1996).
[[nodiscard]] bool areDisjoint(const CellShape& a, const CellShape& b);

/// Groups a block's cells into zones. The cells of a zone are connected by exact portals, closed and pairwise
/// disjoint; no portal between two of them is inexact or one-way, and none is right behind an opening that leads to
/// another cell. Deterministic: breadth first from the
/// smallest id. `merge` false: a zone for each cell.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groupIntoZones(const BlockContent& block, bool merge);

} // namespace limen::world
