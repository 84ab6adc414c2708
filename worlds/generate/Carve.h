#pragma once

#include "geometry/Plane.h"

#include <span>
#include <vector>

namespace limen::worlds {

using Polygon = std::vector<Vec3>;

/// A convex polygon cut in two. Corners within `kOnCut` of the plane belong to both; a new corner is the same
/// to the bit whichever way the edge runs. A part that would have no area is empty.
struct Halves {
    Polygon front, back;
};
inline constexpr double kOnCut = 1e-4; ///< metres
[[nodiscard]] Halves splitPolygon(std::span<const Vec3> polygon, const Plane& plane);

/// What two coplanar convex polygons with the same winding have in common; empty if nothing. `normal` is the
/// side from which they run counter-clockwise.
[[nodiscard]] Polygon commonPart(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& normal);

/// What is left of a convex wall around convex openings in its plane that lie inside it or touch its border,
/// and do not overlap each other: convex pieces that meet the openings' edges exactly, with the wall's
/// winding. T-junctions between the pieces are left to closeSeams.
[[nodiscard]] std::vector<Polygon> withoutOpenings(const Polygon& wall, std::span<const Polygon> openings);

/// The polygon wound so that `inside` lies in front of it.
[[nodiscard]] Polygon facing(Polygon polygon, const Vec3& inside);

[[nodiscard]] double areaOf(std::span<const Vec3> polygon);
/// The mean of the triangles' centres, weighted by area.
[[nodiscard]] Vec3 centroidOf(std::span<const Vec3> polygon);
/// How far a point of a convex polygon's plane lies from its nearest edge's line.
[[nodiscard]] double edgeDistance(std::span<const Vec3> polygon, const Vec3& point);

} // namespace limen::worlds
