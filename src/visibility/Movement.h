#pragma once

#include "visibility/Graph.h"

#include <cstdint>
#include <span>

namespace limen::visibility {

/// The end of a straight movement through a graph.
struct Movement {
    std::uint32_t space = kNone;     ///< the space at its end; kNone for a start in no space of the graph
    double fraction = 1.0;           ///< share of the way, 0 to 1; less than 1 if a portal stops it
    std::uint32_t stoppedBy = kNone; ///< a portal that is closed, leads nowhere, or is missed by its pair
};

/// Follows a movement from `from`, which is in `space`, to `to`, through the portals on its way (docs/ray-rule.md).
/// Walls are not known here. A movement that ends in a portal's plane has not passed it; the next one does. `from` and `to`:
/// metres, in the graph's frame. `closed`: by portal; empty: all open. For a position that is not finite, or a space that does
/// not exist, the result has no space. Cost: the portals of the spaces passed.
[[nodiscard]] LIMEN_API Movement spaceAfterMove(const Graph& graph, std::span<const std::uint8_t> closed,
                                                std::uint32_t space, const Vec3& from, const Vec3& to);

} // namespace limen::visibility
