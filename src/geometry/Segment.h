#pragma once

#include "geometry/Vec.h"

#include <algorithm>

namespace limen {

/// The distance of a point from a segment.
struct SegmentDistance {
    double distance = 0.0; ///< metres, to the segment's nearest point
    double t = 0.0;        ///< the nearest point is a + t (b - a), 0 <= t <= 1
};

/// The ends may coincide.
[[nodiscard]] inline SegmentDistance distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return {glm::length(p - (a + along * t)), t};
}

} // namespace limen
