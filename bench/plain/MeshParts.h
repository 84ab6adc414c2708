#pragma once

#include "frame/FrameView.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// A vertex as plain renderers take it, 32 bytes.
struct PlainVertex {
    Vec3f position{0.0f}; ///< in the space of the mesh
    Vec3f normal{0.0f};
    Vec2f uv{0.0f}; ///< v grows downwards
    friend bool operator==(const PlainVertex&, const PlainVertex&) = default;
};

/// The surface of a part. Of terrain: the base texture alone.
struct PlainSurface {
    std::uint32_t texture = world::kNone; ///< index into World::textures; kNone: the colour alone
    world::SurfaceClass surfaceClass = world::SurfaceClass::Opaque;
    Vec4f colour{1.0f};      ///< alpha includes the instance's opacity
    float luminosity = 0.0f; ///< added to the light
    bool isClamped = false;  ///< the texture is not repeated
    bool isAdditive = false; ///< blended surfaces are added
    bool isInvAlpha = false; ///< blended by one minus the texture's alpha
    friend bool operator==(const PlainSurface&, const PlainSurface&) = default;
};

/// The triangles of a mesh that have one surface. Equal corners are one vertex.
struct MeshPart {
    PlainSurface surface;
    std::vector<PlainVertex> vertices;
    std::vector<std::uint32_t> indices; ///< three for each triangle
};

/// Instances with equal keys have the same parts.
struct PartsKey {
    std::uint32_t mesh = world::kNone, firstMaterial = 0;
    float opacity = 1.0f;
    friend auto operator<=>(const PartsKey&, const PartsKey&) = default;
};
[[nodiscard]] inline PartsKey partsKeyOf(const world::Instance& instance) {
    return {instance.mesh, instance.firstMaterial, instance.opacity};
}

/// The parts of an instance that has a mesh, all levels of detail being instances of their own.
[[nodiscard]] std::vector<MeshPart> partsOf(const world::World& world, const world::Instance& instance);

/// The corner of the landblock below a position: floats about it are exact enough to draw.
[[nodiscard]] Vec3 originNear(const Vec3& eye);
/// From the mesh to metres about `origin` (global), x east, y north, z up.
[[nodiscard]] glm::mat4 placementOf(const world::World& world, const world::Instance& instance,
                                    const Vec3& origin);

/// The one light of plain renderers: the sun and the sky's ambient of a frame's time.
struct PlainLight {
    Vec3f towards{0.0f, 0.0f, 1.0f}; ///< unit length
    Vec3f sun{0.0f}, ambient{0.4f};
};
[[nodiscard]] PlainLight plainLightOf(const world::World& world, const frame::FrameView& view);

/// Triangles that an eye's levels of detail have, without any culling: those of static and dynamic instances.
[[nodiscard]] std::size_t trianglesFrom(const world::World& world, const world::DynamicState& dynamics,
                                        const Vec3& eye);

} // namespace limen::bench
