#pragma once

#include "world/World.h"

#include <gmpxx.h>

#include <vector>

namespace limen::test {

/// The ray rule (docs/ray-rule.md) in floats of 512 bits, for the opaque triangles of a world at rest: a second opinion on
/// rays that double precision may decide wrongly. Takes the records' corners as they are, without rounding. Closes no
/// gap. Shares no code with src/reference and tests/picture.
class ExactTracer {
public:
    struct Vector {
        mpf_class x, y, z;
    };
    /// Global coordinates and normals are exact sums of the world's floats. `world` must outlive it.
    explicit ExactTracer(const world::World& world);

    struct Answer {
        std::uint32_t id = 0; ///< 0 void, 1 sky, else Instance::idBase + polygon
        double t = 0.0;       ///< in units of the direction; 0 for void and sky
    };
    /// `nearPlane`: in units of the direction.
    [[nodiscard]] Answer trace(world::SpaceIndex root, const Vec3& eye, const Vec3& direction,
                               double nearPlane) const;

private:
    struct Triangle {
        Vector a, ab, ac, normal;
        Vec3 roughA{0.0}, roughAb{0.0}, roughAc{0.0}; ///< rounded
        std::uint32_t id = 0;
    };
    struct Plane {
        Vector n;
        mpf_class d;
    };
    struct Opening {
        Plane plane;
        mpf_class before;                     ///< metres before the plane up to which an eye is in it
        std::vector<Vector> corners, outline; ///< global
    };
    struct Ray;
    struct Exit;
    struct Best;
    [[nodiscard]] bool isPassed(world::PortalIndex portal, const Vector& eye) const;
    [[nodiscard]] world::SpaceIndex beyondPassed(world::SpaceIndex space, const Vector& eye) const;
    [[nodiscard]] bool passesPair(world::PortalIndex portal, const Ray& ray, const mpf_class& after) const;
    void nearestPortal(world::SpaceIndex space, const Ray& ray, const mpf_class& after,
                       world::PortalIndex cameBy, Exit& exit) const;
    void nearestSurface(world::SpaceIndex space, const Ray& ray, const mpf_class& after, const Exit& exit,
                        Best& best) const;

    const world::World& world_;
    std::vector<Opening> openings_;                ///< by portal
    std::vector<std::vector<Triangle>> triangles_; ///< by instance
};

} // namespace limen::test
