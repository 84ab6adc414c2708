#pragma once

#include "visibility/Graph.h"

#include <cstdint>
#include <span>

namespace limen::visibility {

/// A wall of a space: a run of vertices.
struct WallDesc {
    std::uint32_t space = 0;
    std::uint32_t firstVertex = 0, vertexCount = 0; ///< flat; may be non-convex; in either winding
};

/// Checks the zones of several spaces, as far as portals and walls show their faults (SpaceDesc). The portals between
/// spaces of a zone are exact pairs and connect all of them. No portal or wall of a space is in the plane of, and
/// overlaps, a portal that leads from another space out of the zone. `vertices`: metres, in the frame of the graph. Without
/// walls, portals alone are compared. Not checked: that the spaces are closed and disjoint, and that none which overlaps
/// other spaces touches such a portal from the far side.
///
/// Cost: a sort of the portals and walls in such zones, and a comparison of those whose boxes overlap along one axis. Errors:
/// BadArgument, naming the portal and the spaces of the first fault; for a wall outside the arrays, or a vertex that
/// is not finite.
[[nodiscard]] LIMEN_API Result<void> checkZones(const Graph& graph, std::span<const WallDesc> walls = {},
                                                std::span<const Vec3> vertices = {});

} // namespace limen::visibility
