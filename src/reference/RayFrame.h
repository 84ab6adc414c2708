#pragma once

#include "geometry/Vec.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace limen::reference {

/// A point in a ray's coordinates: x and y across, z along (in units of the ray's parameter times the
/// direction's largest component). The ray is x = y = 0.
struct Sheared {
    double x, y, z;
};

/// The coordinates in which a ray is the z axis, as in Woop, Benthin, Wald, "Watertight Ray/Triangle
/// Intersection" (2013). A corner goes through the same arithmetic for each polygon that has it, and an edge
/// has exactly opposite signs for the two polygons that share it. So rays cannot slip between the two, and no
/// tolerance is needed. Walls and openings share their corners to the bit (src/world/README.md), so the same
/// holds between a wall and an opening.
struct RayFrame {
    RayFrame(const Vec3& from, const Vec3& along) : eye(from), direction(along) {
        const Vec3 size = glm::abs(along);
        z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        if (along[z] < 0.0) // keeps the winding
            std::swap(x, y);
        shearX = along[x] / along[z];
        shearY = along[y] / along[z];
        scale = 1.0 / along[z];
    }

    [[nodiscard]] Sheared operator()(const Vec3& p) const {
        const double depth = p[z] - eye[z];
        return {(p[x] - eye[x]) - shearX * depth, (p[y] - eye[y]) - shearY * depth, depth};
    }

    Vec3 eye, direction;
    int x = 0, y = 0, z = 0;
    double shearX = 0.0, shearY = 0.0, scale = 0.0;
};

/// Positive if the ray passes on the inner side of the edge from `a` to `b` of a polygon that faces the eye,
/// zero if the ray meets the edge's line. edgeSide(a, b) == -edgeSide(b, a), exactly.
[[nodiscard]] inline double edgeSide(const Sheared& a, const Sheared& b) {
    return b.x * a.y - b.y * a.x;
}

} // namespace limen::reference
