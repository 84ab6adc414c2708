#pragma once

#include "gpu/RendererOptions.h"
#include "world/Loader.h"

#include <optional>
#include <string>

namespace limen::engine {

/// Options of loading and drawing a world, for all verbs.
struct SessionOptions {
    std::string dat; ///< directory; empty: the built-in world
    world::LoadOptions load;
    gpu::Drawing drawing = gpu::Drawing::Exact;
    gpu::TextureMode textures = gpu::TextureMode::Auto;
    gpu::Culling culling = gpu::Culling::Hidden;
    std::uint32_t samples =
        0;                   ///< samples a pixel in frames without ids and layers; 0 and 1: no multisampling
    float anisotropy = 4.0f; ///< upper bound of anisotropic filtering
    std::optional<std::size_t> quality{}; ///< index in kQualities; none: options were set one by one
};

/// Sets the loading and drawing options of a quality level. Requires an index into kQualities.
void applyQuality(std::size_t quality, SessionOptions& options);

} // namespace limen::engine
