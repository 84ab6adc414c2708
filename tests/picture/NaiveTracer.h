#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

#include <vector>

namespace limen::test {

/// The ray rule of docs/ray-rule.md done the obvious way, triangle by triangle and
/// space by space: no zones, no flood, no regions. The oracle that drawn pictures are held against. Shares
/// nothing with visibility, frame and gpu.
class NaiveTracer {
public:
    /// Keeps a copy of every triangle in global coordinates; `world` must outlive it.
    /// `moment`: what moves, and what is shut; a copy is kept.
    explicit NaiveTracer(const world::World& world, world::DynamicState dynamics = {});

    struct Ray {
        Vec3 eye{0.0};
        Vec3 direction{0.0, 1.0, 0.0}; ///< scaled so that its component along the view's axis is 1
        double nearPlane = 0.02;       ///< surfaces nearer than this along the view's axis are not met
    };
    struct Answer {
        std::uint32_t id = 0; ///< 0 void, 1 sky, else Instance::idBase + polygon
        double t = 0.0;       ///< in units of `direction`; infinite for sky, NaN for void
        bool reachedOutside = false;
        std::uint32_t spacesVisited = 0;
        std::vector<std::uint32_t> layers; ///< ids of the translucent polygons met, ascending, each once
    };
    [[nodiscard]] Answer trace(world::SpaceIndex root, const Ray& ray) const;

private:
    struct Triangle {
        Vec3 a{0.0}, ab{0.0}, ac{0.0};
        Vec2f uvA{0.0f}, uvB{0.0f}, uvC{0.0f};
        std::uint32_t id = 0;
        bool blended = false;
        std::uint32_t material = world::kNone; ///< of a cut-out, to test its texel; else kNone
    };
    struct Body {
        Sphere bounds;
        std::size_t firstTriangle = 0, triangleCount = 0;
        bool filling = false;
        Vec3 origin{0.0}; ///< its instance's, global
        world::LevelRange levelRange;
    };
    /// Neighbouring bodies of one space, so that a ray need not ask each of thousands.
    struct Cluster {
        Sphere bounds;
        std::vector<world::InstanceIndex> bodies;
    };
    void addTriangles(const world::Instance& instance);
    void addClusters(world::SpaceIndex index);
    /// Whether it is drawn for an eye there: both in sixteenths of a metre, rounded down.
    [[nodiscard]] static bool isInLevelRange(const Body& body, const Vec3& eye);
    [[nodiscard]] static bool mayMeet(const Sphere& bounds, const Ray& ray);
    /// Where the ray meets a triangle's front; infinite if it does not.
    [[nodiscard]] static double meets(const Triangle& triangle, const Ray& ray, double& v, double& w);
    /// Adds the translucent polygons of a space that the ray meets from `after` to `until`.
    void addLayers(world::SpaceIndex space, const Ray& ray, double after, double until,
                   std::vector<std::uint32_t>& layers) const;
    void nearestIn(const Body& body, const Ray& ray, double after, Answer& best) const;
    [[nodiscard]] bool isHole(const Triangle& triangle, double v, double w) const;
    [[nodiscard]] world::PortalIndex nearestPortal(world::SpaceIndex space, const Ray& ray, double after,
                                                   world::PortalIndex cameBy, double& t) const;

    /// An inexact pair is open where both polygons are; through one of them alone a ray meets a hole.
    [[nodiscard]] bool passesReciprocal(world::PortalIndex portal, const Ray& ray) const;

    const world::World& world_;
    world::DynamicState dynamics_;
    std::vector<Triangle> triangles_;
    std::vector<Body> bodies_;                   ///< by instance, the moment's numbered on
    std::vector<std::vector<Cluster>> clusters_; ///< by space
};

} // namespace limen::test
