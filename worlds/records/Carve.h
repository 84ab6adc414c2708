#pragma once

#include "geometry/Plane.h"

#include <span>
#include <vector>

namespace limen::worlds {

using Polygon = std::vector<Vec3>;

/// The two parts of a convex polygon. Corners within kOnCut of the plane belong to both. A new corner has the
/// same bits for both directions of its edge. A part without area is empty.
struct Halves {
    Polygon front, back;
};
inline constexpr double kOnCut = 1e-4; ///< metres
[[nodiscard]] Halves splitPolygon(std::span<const Vec3> polygon, const Plane& plane);

/// The intersection of two coplanar convex polygons with the same winding; may be empty. `normal`: of the
/// side from which they are counter-clockwise.
[[nodiscard]] Polygon commonPart(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& normal);

/// A convex wall without openings: convex pieces with the wall's winding that match the openings' edges
/// exactly. Openings are convex, in the wall's plane, inside it or touching its border, and do not overlap.
/// closeSeams removes the T-junctions between the pieces.
[[nodiscard]] std::vector<Polygon> withoutOpenings(const Polygon& wall, std::span<const Polygon> openings);

/// The polygon with the winding that puts `inside` in front of it.
[[nodiscard]] Polygon facing(Polygon polygon, const Vec3& inside);

[[nodiscard]] double areaOf(std::span<const Vec3> polygon);
/// The mean of the triangles' centres, weighted by area.
[[nodiscard]] Vec3 centroidOf(std::span<const Vec3> polygon);
/// The distance of a point of a convex polygon's plane from the line of its nearest edge.
[[nodiscard]] double edgeDistance(std::span<const Vec3> polygon, const Vec3& point);

} // namespace limen::worlds
