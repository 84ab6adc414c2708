#include "geometry/Bounds.h"

namespace limen {

Sphere boundingSphere(std::span<const Vec3> points) {
    Aabb box;
    for (const Vec3& p : points)
        box.include(p);
    if (box.empty())
        return {};
    Sphere sphere{box.centre(), 0.0};
    for (const Vec3& p : points) {
        const Vec3 offset = p - sphere.centre;
        sphere.radius = std::max(sphere.radius, std::sqrt(glm::dot(offset, offset)));
    }
    return sphere;
}

} // namespace limen
