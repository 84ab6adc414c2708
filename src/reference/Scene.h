#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

#include <cstdint>
#include <memory>

// The ray rule of docs/ray-rule.md, independently of everything that draws: no zones, no flood, no regions, no GL.
// All arithmetic in double.
namespace limen::reference {

/// A ray through a picture: points are eye + t · direction.
struct Ray {
    Vec3 eye{0.0}; ///< global
    Vec3 direction{0.0, 1.0,
                   0.0}; ///< scaled so that its component along the view's axis is 1: t is view depth, metres
    double nearPlane = 0.02; ///< surfaces with t below are not met; portals are met at any t
};

/// The translucent surfaces met on the way, as a set: each polygon once, whatever its alpha, order left out.
/// Comparable with the counting pass of gpu (frame/FramePlan.h).
struct Layers {
    std::uint32_t count = 0;
    std::uint32_t hash = 0; ///< sum of layerHash(id) over the polygons
    friend bool operator==(const Layers&, const Layers&) = default;
};

/// What one translucent polygon adds to Layers::hash: 1..0xFFFF, so that sums of 256 are exact in a float. The shader
/// shaders/include/layers.glsl computes the same.
[[nodiscard]] constexpr std::uint32_t layerHash(std::uint32_t id) {
    return ((id * 2654435761u) >> 16) | 1u;
}

/// What a pixel must show.
struct Answer {
    std::uint32_t id = 0;                      ///< 0 void, 1 sky, else Instance::idBase + polygon
    double t = 0.0;                            ///< view depth in metres; +infinity for sky, NaN for void
    world::SpaceIndex space = world::kOutside; ///< the space the ray ended in
    bool reachedOutside = false;               ///< the ray was outside at some point
    std::uint32_t spacesVisited = 0;
    Layers layers;
};

/// Choices where the rule leaves one.
struct RuleOptions {
    /// "An object that pokes through a wall ... within one zone may be seen": objects (never shells, terrain or
    /// exteriors) are met in every space of the zones they are members of. Off: only in the spaces themselves.
    bool objectsByZone = false;
};

struct SceneData;

/// A world and one of its moments, ready for rays. May be shared by threads while nobody calls setMoment.
class Scene {
public:
    /// Builds a bounding volume hierarchy of the instances of each space; their triangles follow when rays come near
    /// them. `world` must outlive it.
    explicit Scene(const world::World& world, const RuleOptions& options = {});
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;

    /// Takes over what moves; costs a build of the hierarchies of what moves, triangles apart. `moment` must be of the
    /// same world; it is copied. Without a call nothing moves and all openings are open.
    void setDynamics(const world::DynamicState& dynamics);

    /// Follows one ray from the root space. Pure.
    [[nodiscard]] Answer trace(world::SpaceIndex root, const Ray& ray) const;

    /// For this room.
    [[nodiscard]] const SceneData& data() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace limen::reference
