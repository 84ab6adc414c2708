#pragma once

#include "geometry/Plane.h"

#include <span>
#include <vector>

namespace limen {

/// Clips a convex polygon to the closed half-space n·p + d >= -tolerance (Sutherland, Hodgman 1974).
/// Overwrites `out`, keeping its capacity, with the part inside, in the same winding; empty if there is none.
/// Vertices inside keep their bits; new vertices are on the plane n·p + d = -tolerance. `out` must not alias
/// `polygon`.
void clipPolygon(std::span<const Vec3> polygon, const Plane& plane, double tolerance, std::vector<Vec3>& out);

/// The normal by Newell's sum; its length is twice the polygon's area.
[[nodiscard]] Vec3 newellNormal(std::span<const Vec3> polygon);

/// True if the point's projection onto the polygon's plane lies inside the convex polygon or within
/// `tolerance` (same unit) of it. `normal` is the polygon's unit normal, counter-clockwise seen from its tip.
[[nodiscard]] bool containsProjection(std::span<const Vec3> polygon, const Vec3& normal, const Vec3& point,
                                      double tolerance);

} // namespace limen
