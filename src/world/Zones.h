#pragma once

#include "geometry/Tolerances.h"
#include "world/BlockContent.h"

namespace limen::world {

/// True if it can be shown that two cells do not overlap: a plane parallel to a face of either, or to an edge
/// of each, parts their vertices up to kOverlapTolerance. Never true for cells that overlap more; may be
/// false for cells that wind around each other. Ref: the separating axis theorem (Gottschalk 1996).
[[nodiscard]] bool areDisjoint(const CellShape& a, const CellShape& b);

/// Groups a block's cells into zones: each connected by exact portals, every cell in it closed and disjoint
/// from all others, no two of them joined by a portal that is not exact or has no way back. Deterministic:
/// breadth first from the smallest id. `merge` false: each cell alone.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groupIntoZones(const BlockContent& block, bool merge);

} // namespace limen::world
