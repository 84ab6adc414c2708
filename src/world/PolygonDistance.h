#pragma once

#include "geometry/Plane.h"

#include <span>

namespace limen::world {

/// Distance of a point from a convex polygon with its area. `plane`: that of the polygon. Infinite for fewer
/// than three corners.
[[nodiscard]] double distanceToPolygon(std::span<const Vec3> polygon, const Plane& plane, const Vec3& point);

/// True if every corner of each polygon is within `tolerance` of the other polygon. Winding and corners on
/// edges do not matter.
[[nodiscard]] bool samePolygon(std::span<const Vec3> a, std::span<const Vec3> b, double tolerance);

} // namespace limen::world
