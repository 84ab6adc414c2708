#pragma once

#include "gpu/texture/TextureStaging.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::gpu {

/// Which triangles are left out before they are drawn. Pictures are the same, bit for bit. Only with exact outlines, and one
/// sample a pixel; else none are.
enum class Culling : std::uint8_t {
    None,
    Unseen, ///< those that cover no pixel's centre or face away
    Hidden  ///< also those that lie behind walls or the ground, as far as whole tiles of pixels tell
};

/// How a renderer is made.
struct RendererOptions {
    TextureStoreOptions textures{};
    /// What a pixel shows is decided by the ray through its centre and not by corners that the rasteriser has snapped
    /// (shaders/include/outline.glsl).
    bool exactOutlines = true;
    Culling culling = Culling::Hidden;
    /// Macros for every shader: tests leave parts of the method out with them (shaders/include/gate.glsl).
    std::vector<std::string> shaderDefines{};
};

} // namespace limen::gpu
