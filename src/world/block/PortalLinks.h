#pragma once

#include "world/block/BuildingReader.h"

namespace limen::world {

/// Metres. Two polygons that agree within this are one opening, and their portals are exact.
inline constexpr double kExactTolerance = 0.001;
/// Metres. Polygons that do not agree within this are different openings (docs/ray-rule.md).
inline constexpr double kOpeningTolerance = 0.01;

/// Sets the destinations and reciprocals of the cells' portals. If the way back that the record names does
/// not lead back, one with the same polygon is used; without any, the portal is one-way. A pair is exact if
/// both portals are flagged so and their polygons agree and face each other. Contradictions are findings.
/// Exit portals get the outside as destination.
void linkCellPortals(BlockContent& block);

/// Appends the portals of one building, paired with the exit portals they name. `ownPolygons`: the polygons
/// of the building's model by portal. They are compared, and say which portals are walled from outside: the
/// exit's polygon is used both ways.
void linkBuilding(BlockContent& block, const dat::Building& building,
                  std::span<const BuildingDraft::PortalPolygon> ownPolygons, dat::RecordId record);

/// Called after the last building. Reports the exits that no building leads to, and sets
/// CellContent::ofBuilding. Walled portals lose their way back: each direction of the opening is one-way.
void finishBuildings(BlockContent& block);

} // namespace limen::world
