#pragma once

#include "gpu/TextureStore.h"

#include <string>
#include <vector>

namespace limen::gpu {

/// How a renderer is made.
struct RendererOptions {
    TextureStoreOptions textures{};
    /// What a pixel shows is decided by the ray through its centre and not by corners that the rasteriser has snapped
    /// (shaders/include/outline.glsl).
    bool exactOutlines = true;
    /// Triangles that cover no pixel's centre or face away are left out before they are drawn; pictures are the same, bit for
    /// bit. Only with exact outlines, and one sample a pixel.
    bool cullTriangles = true;
    /// Macros for every shader: tests leave parts of the method out with them (shaders/include/gate.glsl).
    std::vector<std::string> shaderDefines{};
};

} // namespace limen::gpu
