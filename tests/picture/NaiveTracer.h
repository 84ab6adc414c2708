#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

#include <vector>

namespace limen::test {

/// The ray rule of docs/ray-rule.md implemented directly, triangle by triangle and space by space, without
/// zones, flood or regions. The oracle for drawn pictures. Shares no code with visibility, frame and gpu.
class NaiveTracer {
public:
    /// Keeps a copy of every triangle in global coordinates; `world` must outlive it. Copies `dynamics`:
    /// poses and closed portals.
    explicit NaiveTracer(const world::World& world, world::DynamicState dynamics = {});

    struct Ray {
        Vec3 eye{0.0};
        Vec3 direction{0.0, 1.0, 0.0}; ///< scaled so that its component along the view's axis is 1
        double nearPlane = 0.02;       ///< surfaces nearer than this along the view's axis are skipped
    };
    struct Answer {
        std::uint32_t id = 0; ///< 0 void, 1 sky, else Instance::idBase + polygon
        double t = 0.0;       ///< in units of `direction`; infinite for sky, NaN for void
        bool reachedOutside = false;
        std::uint32_t spacesVisited = 0;
        /// ids of the transparent polygons hit, ascending, without duplicates
        std::vector<std::uint32_t> layers;
    };
    [[nodiscard]] Answer trace(world::SpaceIndex root, const Ray& ray) const;

private:
    struct Triangle {
        Vec3 a{0.0}, ab{0.0}, ac{0.0};
        Vec2f uvA{0.0f}, uvB{0.0f}, uvC{0.0f};
        std::uint32_t id = 0;
        bool blended = false;
        /// material of a cut-out, for the test of its texel; else kNone
        std::uint32_t material = world::kNone;
    };
    struct Body {
        Sphere bounds;
        std::size_t firstTriangle = 0, triangleCount = 0;
        bool filling = false;
        Vec3 block{0.0}; ///< the origin of its block, global
        std::uint32_t level = world::kNone;
    };
    /// Adjacent bodies of one space, so that a ray does not test thousands one by one.
    struct Cluster {
        Sphere bounds;
        std::vector<world::InstanceIndex> bodies;
    };
    void addTriangles(const world::Instance& instance);
    void addClusters(world::SpaceIndex index);
    /// Whether it is drawn for this eye; both in sixteenths of a metre, rounded down.
    [[nodiscard]] bool isInLevelRange(const Body& body, const Vec3& eye) const;
    [[nodiscard]] static bool mayMeet(const Sphere& bounds, const Ray& ray);
    /// Distance to the triangle's front; infinite without an intersection.
    [[nodiscard]] static double meets(const Triangle& triangle, const Ray& ray, double& v, double& w);
    /// Adds the transparent polygons of a space that the ray hits from `after` to `until`.
    void addLayers(world::SpaceIndex space, const Ray& ray, double after, double until,
                   std::vector<std::uint32_t>& layers) const;
    void nearestIn(const Body& body, const Ray& ray, double after, Answer& best) const;
    [[nodiscard]] bool isHole(const Triangle& triangle, double v, double w) const;
    [[nodiscard]] world::PortalIndex nearestPortal(world::SpaceIndex space, const Ray& ray, double after,
                                                   world::PortalIndex cameBy, double& t) const;

    [[nodiscard]] double beforePlane(const world::Portal& portal) const;
    [[nodiscard]] bool isNearest(world::PortalIndex portal, const Vec3& eye) const;
    [[nodiscard]] world::SpaceIndex beyondPassed(world::SpaceIndex space, const Vec3& eye) const;
    /// An inexact pair is open where both polygons are; through only one of them a ray enters a hole.
    [[nodiscard]] bool passesReciprocal(world::PortalIndex portal, const Ray& ray) const;

    const world::World& world_;
    world::DynamicState dynamics_;
    std::vector<Triangle> triangles_;
    std::vector<Body> bodies_;                   ///< by instance; dynamic instances follow the static ones
    std::vector<std::vector<Cluster>> clusters_; ///< by space
};

} // namespace limen::test
