#pragma once

#include "geometry/Plane.h"

#include <span>

namespace limen::world {

/// Distance of a point from a convex polygon (its area included). `plane` is the polygon's. Infinite for
/// fewer than three corners.
[[nodiscard]] double distanceToPolygon(std::span<const Vec3> polygon, const Plane& plane, const Vec3& point);

/// True if every corner of each polygon lies within `tolerance` of the other: the same opening, whatever the
/// winding and the corners inserted into edges.
[[nodiscard]] bool samePolygon(std::span<const Vec3> a, std::span<const Vec3> b, double tolerance);

} // namespace limen::world
