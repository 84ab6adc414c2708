#include "reference/Gap.h"

#include "geometry/Segment.h"
#include "geometry/Tolerances.h"

#include <limits>

namespace limen::reference {
namespace {

constexpr double kRounding = 1e-9; // metres: doubles of a few thousand metres, several operations

/// The point of a triangle that is nearest to another point. Ref: Ericson, "Real-Time Collision Detection" (2005),
/// section 5.1.5.
Vec3 nearestOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = glm::cross(b - a, c - a);
    const auto isInside = [&](const Vec3& from, const Vec3& to) {
        return glm::dot(glm::cross(to - from, p - from), n) >= 0.0;
    };
    const double squared = glm::dot(n, n);
    if (squared > 0.0 && isInside(a, b) && isInside(b, c) && isInside(c, a))
        return p - n * (glm::dot(p - a, n) / squared);
    Vec3 nearest = a;
    double least = std::numeric_limits<double>::infinity();
    const auto edge = [&](const Vec3& from, const Vec3& to) {
        const SegmentDistance d = distanceToSegment(p, from, to);
        if (d.distance < least) {
            least = d.distance;
            nearest = from + (to - from) * d.t;
        }
    };
    edge(a, b);
    edge(b, c);
    edge(c, a);
    return nearest;
}

/// The same of a convex polygon.
Vec3 nearestOf(const Vec3& p, std::span<const Vec3> corners) {
    Vec3 nearest = corners[0];
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vec3 q = nearestOfTriangle(p, corners[0], corners[i - 1], corners[i]);
        if (glm::length(q - p) < glm::length(nearest - p))
            nearest = q;
    }
    return nearest;
}

} // namespace

Gap::Gap(const Vec3& passes, std::span<const Vec3> corners)
    : passes_(passes), across_(passes - nearestOf(passes, corners)) {}

bool Gap::isRounding() const {
    return glm::length(across_) <= kRounding;
}

bool Gap::hasSide(std::span<const Vec3> corners) const {
    const Vec3 beyond = passes_ + across_;
    const Vec3 nearest = nearestOf(beyond, corners);
    return glm::length(nearest - beyond) <= kGapTolerance && glm::dot(nearest - passes_, across_) > 0.0;
}

} // namespace limen::reference
