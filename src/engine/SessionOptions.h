#pragma once

#include "gpu/RendererOptions.h"
#include "world/Loader.h"

#include <optional>
#include <string>

namespace limen::engine {

/// How a world is loaded and drawn, whatever the verb.
struct SessionOptions {
    std::string dat; ///< directory; empty: the built-in world
    world::LoadOptions load;
    gpu::TextureMode textures = gpu::TextureMode::Auto;
    gpu::Culling culling = gpu::Culling::Hidden;
    std::uint32_t samples = 0; ///< a pixel, of frames without ids and layers; 0 and 1: no multisampling
    float anisotropy = 4.0f;   ///< upper bound of anisotropic filtering
    std::optional<std::size_t> quality{}; ///< the index of kQualities that was chosen last
};

/// Takes the loading and drawing options of a quality level. Requires an index into kQualities.
void applyQuality(std::size_t quality, SessionOptions& options);

} // namespace limen::engine
