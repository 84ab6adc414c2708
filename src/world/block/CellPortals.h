#pragma once

#include "world/block/CellClosure.h"
#include "world/block/CellReader.h"

namespace limen::world {

/// The polygons of a block, and the index list of each surface slot of the cell.
struct CellGeometry {
    const BakedGeometry& baked;
    std::span<const SurfaceList> lists;
};

/// The portals of a cell with their polygons oriented, not yet linked. They are added to `closure`. The inner
/// side follows from the edges that the shell leaves open; if these are ambiguous, from the side that all
/// other vertices are on; else from the record's flags. A record that contradicts is a finding. A polygon
/// that is missing, without area, not flat or not convex gets no points.
[[nodiscard]] std::vector<PortalContent> cellPortals(const CellDraft& draft, std::uint32_t cell,
                                                     const CellGeometry& geometry, CellClosure& closure,
                                                     std::span<const Vec3> shellPoints,
                                                     std::vector<Finding>& findings);

} // namespace limen::world
