#pragma once

#include "gpu/texture/TextureStaging.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::gpu {

/// Triangles culled before drawing. Pictures are the same to the bit. Only with exact outlines and one sample
/// per pixel; otherwise no triangle is culled.
enum class Culling : std::uint8_t {
    None,
    Unseen, ///< back-facing triangles, and those that cover no pixel centre
    Hidden  ///< also triangles behind walls and ground, by depth tiles
};

/// Options of a renderer.
struct RendererOptions {
    TextureStoreOptions textures{};
    /// The ray through a pixel's centre decides its colour, not corners snapped by the rasteriser
    /// (shaders/include/outline.glsl).
    bool exactOutlines = true;
    Culling culling = Culling::Hidden;
    /// Macros for every shader. Tests omit parts of the method with them (shaders/include/gate.glsl).
    std::vector<std::string> shaderDefines{};
};

} // namespace limen::gpu
