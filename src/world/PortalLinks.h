#pragma once

#include "world/BlockContent.h"

namespace limen::world {

/// Two openings that agree to this are one and the same; metres.
inline constexpr double kExactTolerance = 0.001;
/// Openings farther apart than this are different ones; metres (docs/ray-rule.md).
inline constexpr double kOpeningTolerance = 0.01;

/// Resolves the destinations of the cells' portals and finds their ways back. A way back that the data names
/// must lead back; otherwise one with the same polygon is taken, or the portal is one-way. A pair is exact if
/// both are flagged so and their polygons agree, facing each other. Findings say what does not fit. Exit
/// portals get the outside as destination.
void linkCellPortals(BlockContent& block);

/// Appends the portals of one building, paired with the exit portals they name. `ownPolygons` are the
/// polygons of the building's model by portal (block-local, empty if it has none): only compared.
void linkBuilding(BlockContent& block, const dat::Building& building,
                  std::span<const std::vector<Vec3>> ownPolygons, dat::RecordId record);

/// After all buildings: says which exits no building leads to, and marks the cells of buildings.
void finishBuildings(BlockContent& block);

} // namespace limen::world
