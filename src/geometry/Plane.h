#pragma once

#include "core/Api.h"
#include "geometry/Vec.h"

#include <span>

namespace limen {

/// The plane n·p + d = 0; a point with n·p + d > 0 is in front of it. n has unit length.
struct Plane {
    Vec3 n{0.0, 0.0, 1.0};
    double d = 0.0;

    [[nodiscard]] double signedDistance(const Vec3& p) const { return glm::dot(n, p) + d; }
    [[nodiscard]] Plane flipped() const { return {-n, -d}; }
    /// The same plane for points given relative to `origin`.
    [[nodiscard]] Plane relativeTo(const Vec3& origin) const { return {n, signedDistance(origin)}; }
    friend bool operator==(const Plane&, const Plane&) = default;
};

/// The plane of a polygon by Newell's sum. The normal points to the side from which the vertices run
/// counter-clockwise. Exact for planar polygons, a mean for others. A polygon without area gives n = (0,0,0),
/// d = 0: callers check `glm::dot(n, n) > 0`.
[[nodiscard]] LIMEN_API Plane planeOf(std::span<const Vec3> polygon);

} // namespace limen
