#pragma once

#include "geometry/Tolerances.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <cstdint>
#include <memory>

// The ray rule of docs/ray-rule.md, independent of everything that draws: no zones, no flood, no regions, no
// GL. All arithmetic in double.
namespace limen::reference {

/// A ray through a picture: points are eye + t · direction.
struct Ray {
    Vec3 eye{0.0}; ///< global
    /// Scaled so that its component along the view's axis is 1: then t is the view depth in metres.
    Vec3 direction{0.0, 1.0, 0.0};
    double nearPlane = kDefaultNearPlane; ///< surfaces with t below are not met; portals are met at any t
};

/// The set of translucent polygons that a ray meets: each counts once, at any alpha and in any order.
/// Comparable with the counting pass of gpu (frame/FramePlan.h).
struct Layers {
    std::uint32_t count = 0;
    std::uint32_t hash = 0; ///< sum of layerHash(id) over the polygons
    friend bool operator==(const Layers&, const Layers&) = default;
};

/// The share of one translucent polygon in Layers::hash: 1..0xFFFF, so that sums of 256 are exact in a float.
/// The same computation as in shaders/include/layers.glsl.
[[nodiscard]] constexpr std::uint32_t layerHash(std::uint32_t id) {
    return ((id * 2654435761u) >> 16) | 1u;
}

/// The right result for one ray.
struct Answer {
    std::uint32_t id = 0;                      ///< 0 void, 1 sky, else Instance::idBase + polygon
    double t = 0.0;                            ///< view depth in metres; +infinity for sky, NaN for void
    world::SpaceIndex space = world::kOutside; ///< where the ray ended
    bool reachedOutside = false;               ///< the ray passed through the outside
    std::uint32_t spacesVisited = 0;
    Layers layers;
};

/// Options where the rule leaves a choice.
struct RuleOptions {
    /// "An object that pokes through a wall ... within one zone may be seen": objects (never shells, terrain
    /// or exteriors) are met in every space of the zones they are members of. Off: only in the spaces
    /// themselves.
    bool objectsByZone = false;
};

struct SceneData;

/// A world and one dynamic state of it, prepared for rays. Threads may share it while none calls
/// setDynamics().
class Scene {
public:
    /// Builds a bounding volume hierarchy over the instances of each space. Their triangles follow when rays
    /// come near them. `world` must outlive the scene.
    explicit Scene(const world::World& world, const RuleOptions& options = {});
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;

    /// Replaces the dynamic state; rebuilds the hierarchies over moving instances, without their triangles.
    /// `dynamics` must be of the same world; it is copied. Before the first call nothing moves and all
    /// openings are open.
    void setDynamics(const world::DynamicState& dynamics);

    /// The space in which the rays of an eye (global) begin: the root, or the space behind a portal that the eye
    /// has just passed.
    [[nodiscard]] world::SpaceIndex spaceOfEye(world::SpaceIndex root, const Vec3& eye) const;
    /// Follows one ray from the root space. A pure function.
    [[nodiscard]] Answer trace(world::SpaceIndex root, const Ray& ray) const;

    /// For other files of this room.
    [[nodiscard]] const SceneData& data() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace limen::reference
