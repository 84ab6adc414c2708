#include "geometry/ConvexPolygon.h"

#include "core/Assert.h"

namespace limen {

Vec3 newellNormal(std::span<const Vec3> polygon) {
    Vec3 sum(0.0);
    if (polygon.size() < 3)
        return sum;
    for (size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return sum;
}

Plane planeOf(std::span<const Vec3> polygon) {
    const Vec3 normal = newellNormal(polygon);
    const double length = std::sqrt(glm::dot(normal, normal));
    if (!(length > 1e-12))
        return {Vec3(0.0), 0.0};
    const Vec3 n = normal / length;
    double offset = 0.0;
    for (const Vec3& p : polygon)
        offset += glm::dot(n, p - polygon[0]);
    return {n, -(glm::dot(n, polygon[0]) + offset / static_cast<double>(polygon.size()))};
}

void clipPolygon(std::span<const Vec3> polygon, const Plane& plane, double tolerance,
                 std::vector<Vec3>& out) {
    out.clear();
    if (polygon.empty())
        return;
    LIMEN_ASSERT(out.data() == nullptr || out.data() != polygon.data(), "clipPolygon cannot clip in place");
    Vec3 previous = polygon.back();
    double previousDistance = plane.signedDistance(previous) + tolerance;
    for (const Vec3& current : polygon) {
        const double distance = plane.signedDistance(current) + tolerance;
        if ((distance >= 0.0) != (previousDistance >= 0.0)) {
            const double t = previousDistance / (previousDistance - distance);
            out.push_back(previous + (current - previous) * t);
        }
        if (distance >= 0.0)
            out.push_back(current);
        previous = current;
        previousDistance = distance;
    }
    if (out.size() < 3)
        out.clear();
}

bool containsProjection(std::span<const Vec3> polygon, const Vec3& normal, const Vec3& point,
                        double tolerance) {
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& a = polygon[i];
        const Vec3 edge = polygon[(i + 1) % polygon.size()] - a;
        const Vec3 inward = glm::cross(normal, edge);
        const double length = std::sqrt(glm::dot(inward, inward));
        if (length > 0.0 && glm::dot(inward, point - a) < -tolerance * length)
            return false;
    }
    return polygon.size() >= 3;
}

} // namespace limen
