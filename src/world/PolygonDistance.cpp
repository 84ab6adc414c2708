#include "world/PolygonDistance.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Segment.h"

#include <algorithm>
#include <limits>

namespace limen::world {

double distanceToPolygon(std::span<const Vec3> polygon, const Plane& plane, const Vec3& point) {
    if (polygon.size() < 3)
        return std::numeric_limits<double>::infinity();
    if (plane.n != Vec3(0.0) && containsProjection(polygon, plane.n, point, 0.0))
        return std::abs(plane.signedDistance(point));
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        nearest = std::min(nearest,
                           distanceToSegment(point, polygon[i], polygon[(i + 1) % polygon.size()]).distance);
    return nearest;
}

bool samePolygon(std::span<const Vec3> a, std::span<const Vec3> b, double tolerance) {
    const Plane planeA = planeOf(a), planeB = planeOf(b);
    return std::all_of(a.begin(), a.end(),
                       [&](const Vec3& p) { return distanceToPolygon(b, planeB, p) <= tolerance; }) &&
           std::all_of(b.begin(), b.end(),
                       [&](const Vec3& p) { return distanceToPolygon(a, planeA, p) <= tolerance; });
}

} // namespace limen::world
