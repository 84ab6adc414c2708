#pragma once

#include "geometry/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::world {

using TriangleCorners = std::array<std::uint32_t, 3>; ///< positions in the polygon

/// Cuts a flat simple polygon into triangles of the same winding, appended to `out`. The polygon need not be
/// convex. Corners may be on the line between their neighbours: no triangle is degenerate, and every edge of
/// the polygon is an edge of a triangle. A polygon without area yields no triangle. Cost: O(n^2) for convex
/// polygons.
/// Ref: ear clipping (Meisters 1975); the ear whose smallest altitude is largest is cut first.
void triangulate(std::span<const Vec3> polygon, std::vector<TriangleCorners>& out);
/// The same of a polygon that is simple as seen along `normal`, a unit vector; counter-clockwise from its tip.
void triangulate(std::span<const Vec3> polygon, const Vec3& normal, std::vector<TriangleCorners>& out);

} // namespace limen::world
