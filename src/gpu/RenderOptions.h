#pragma once

#include <cstdint>

namespace limen::gpu {

/// Colouring of solid surfaces and of the plain sky. Flat frames are unlit, read textures only for the alpha
/// of cut-outs, and skip surfaces without an id: sky objects and transparent surfaces. Ids and depth of
/// frames with ids are equal in all modes, to the bit. Lit frames without ids also have the depth of nearly
/// opaque texels (shaders/include/surface.glsl).
enum class Shading : std::uint8_t {
    Lit,
    FlatIds, ///< colour of the surface's id (frame/IdColour.h); void has that of kVoidId
    IdsOnly  ///< the colour image stays unchanged
};

/// Options of one frame.
struct RenderOptions {
    bool wantIds = true; ///< write the id image; not on multisampled targets
    Shading shading = Shading::Lit;
    /// Count the layers of transparent surfaces per pixel. The transparent stage then paints nothing, and sky
    /// objects are skipped. The target must have a layers image.
    bool wantLayers = false;
    /// Cull triangles behind walls and ground, if the renderer can (Culling::Hidden; not on tiles). The
    /// picture is the same.
    bool occlusion = true;
};

} // namespace limen::gpu
