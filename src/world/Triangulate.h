#pragma once

#include "geometry/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::world {

using TriangleCorners = std::array<std::uint32_t, 3>; ///< positions in the polygon

/// Cuts a flat simple polygon into triangles of the same winding, appended to `out`. Corners may lie on the
/// line between their neighbours: no triangle is degenerate for it, and every edge of the polygon is the edge
/// of a triangle. Need not be convex. A polygon without area yields nothing. Cost: O(n^2) for convex
/// polygons. Ref: ear clipping (Meisters 1975), always the ear with the largest smallest altitude first.
void triangulate(std::span<const Vec3> polygon, std::vector<TriangleCorners>& out);

} // namespace limen::world
