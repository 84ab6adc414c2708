#pragma once

#include "core/Api.h"
#include "geometry/Vec.h"

#include <span>

namespace limen {

/// A sphere with its inside. A negative radius: empty.
struct Sphere {
    Vec3 centre{0.0};
    double radius = -1.0;
    friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// An axis-aligned box. Default-constructed it is empty (min > max) and grows by `include`.
struct Aabb {
    Vec3 min{1e300};
    Vec3 max{-1e300};

    [[nodiscard]] bool empty() const { return min.x > max.x; }
    [[nodiscard]] Vec3 centre() const { return (min + max) * 0.5; }
    void include(const Vec3& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    void include(const Aabb& b) {
        min = glm::min(min, b.min);
        max = glm::max(max, b.max);
    }
    [[nodiscard]] bool contains(const Vec3& p) const {
        return p.x >= min.x && p.y >= min.y && p.z >= min.z && p.x <= max.x && p.y <= max.y && p.z <= max.z;
    }
    friend bool operator==(const Aabb&, const Aabb&) = default;
};

/// A sphere that contains all points: around the centre of their box, at most 1.74 times as large as the
/// smallest one. Empty for no points.
[[nodiscard]] LIMEN_API Sphere boundingSphere(std::span<const Vec3> points);

} // namespace limen
