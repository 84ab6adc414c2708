#pragma once

#include "world/CellBuilder.h"
#include "world/CellClosure.h"

namespace limen::world {

/// The portals of a cell, wound and oriented, not yet linked. Which side is inside follows from the edges the
/// shell leaves open; where these don't tell, from the side all other vertices lie on; else from the record's
/// flags. A record that contradicts is a finding. A polygon that is missing, without area, not flat or not
/// convex gets no points. The portals are added to `closure`.
[[nodiscard]] std::vector<PortalContent> cellPortals(const CellDraft& draft, std::uint32_t cell,
                                                     const BakedGeometry& geometry, CellClosure& closure,
                                                     std::span<const Vec3> shellPoints,
                                                     std::vector<Finding>& findings);

} // namespace limen::world
