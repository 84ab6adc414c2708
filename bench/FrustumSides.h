#pragma once

#include "geometry/Bounds.h"
#include "visibility/View.h"

#include <array>

namespace limen::bench {

/// The four side planes of a frustum, for culling by bounding spheres. A sphere behind the eye is outside of
/// at least one.
struct FrustumSides {
    Vec3 eye{0.0};
    std::array<Vec3, 4> inwards{}; ///< normals, unit length

    [[nodiscard]] static FrustumSides of(const visibility::View& view) {
        const Vec3 wide = view.forward * view.tanHalfX, high = view.forward * view.tanHalfY;
        return {view.eye,
                {glm::normalize(wide - view.right), glm::normalize(wide + view.right),
                 glm::normalize(high - view.up), glm::normalize(high + view.up)}};
    }
    [[nodiscard]] bool sees(const Sphere& bounds) const {
        const Vec3 centre = bounds.centre - eye;
        return glm::dot(inwards[0], centre) >= -bounds.radius &&
               glm::dot(inwards[1], centre) >= -bounds.radius &&
               glm::dot(inwards[2], centre) >= -bounds.radius &&
               glm::dot(inwards[3], centre) >= -bounds.radius;
    }
};

} // namespace limen::bench
