#pragma once

#include "world/block/BlockContent.h"

namespace limen::world {

/// Metres. Cells that overlap by no more than this count as disjoint (docs/ray-rule.md, "Zones"). Depth alone
/// decides within a zone, so a hidden cell may reach through the wall in front of it by as much; the picture
/// moves that much back behind the wall (MeshArena.cpp, kMostReach). Cells that overlap more are in different
/// zones, which is slower and exact.
inline constexpr double kOverlapTolerance = 0.0001;

/// True if a plane that is parallel to a face of either cell, or to an edge of each, separates their vertices
/// up to kOverlapTolerance. Never true for cells that overlap more. May be false for disjoint cells that wind
/// around each other.
/// Ref: the separating axis theorem (Gottschalk 1996).
[[nodiscard]] bool areDisjoint(const CellShape& a, const CellShape& b);

/// Groups a block's cells into zones. The cells of a zone are connected by exact portals, closed and pairwise
/// disjoint; no portal between two of them is inexact or one-way. Deterministic: breadth first from the
/// smallest id. `merge` false: a zone for each cell.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groupIntoZones(const BlockContent& block, bool merge);

} // namespace limen::world
