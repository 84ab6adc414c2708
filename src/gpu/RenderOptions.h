#pragma once

#include <cstdint>

namespace limen::gpu {

/// How solid surfaces and the plain sky are coloured. Flat frames read no texture but for the alpha of cut-outs, have no
/// light, and leave out what has no id: sky objects and translucent surfaces. Of frames with ids, ids and depth are the same with
/// all, bit for bit; lit ones without have the depth of nearly opaque texels, too (shaders/include/surface.glsl).
enum class Shading : std::uint8_t {
    Lit,
    FlatIds, ///< every surface in the colour of its id (frame/IdColour.h), void in that of kVoidId
    IdsOnly  ///< no colour is written: what it was stays
};

/// What is asked of one frame.
struct RenderOptions {
    bool wantIds = true; ///< write the id image; not on multisampled targets
    Shading shading = Shading::Lit;
    /// Count the layers of translucent surfaces per pixel; the late stage then does that instead of painting, and sky
    /// objects are left out. The target must be made for it.
    bool wantLayers = false;
    /// Leave out what walls and the ground hide, if the renderer can (Culling::Hidden). The picture is the same.
    bool occlusion = true;
};

} // namespace limen::gpu
