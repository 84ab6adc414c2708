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

/// Way of drawing a plan. Both draw the same surfaces in the same order of transparency.
enum class Drawing : std::uint8_t {
    Exact, ///< for proofs: the ray through a pixel's centre decides
    /// For people: hardware outlines, depth tests before shading, fog at the vertices. Outlines differ from
    /// the exact ones by less than a pixel.
    Fast
};

/// Options of a renderer.
struct RendererOptions {
    TextureStoreOptions textures{};
    Drawing drawing = Drawing::Exact;
    /// The ray through a pixel's centre decides its colour, not corners snapped by the rasteriser
    /// (shaders/include/outline.glsl). Without effect on Drawing::Fast.
    bool exactOutlines = true;
    Culling culling = Culling::Hidden; ///< without effect on Drawing::Fast
    /// Without a card, an eye outside: surfaces of the root visit are drawn without the ownership test, and the openings are cleared
    /// after it (decision 216). Without effect on Drawing::Exact. Off: tests compare.
    bool rootFirst = true;
    /// Macros for every shader. Tests omit parts of the method with them (shaders/include/gate.glsl).
    std::vector<std::string> shaderDefines{};
};

} // namespace limen::gpu
