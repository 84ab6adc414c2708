#pragma once

#include "frame/Gate.h"
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
    frame::Gate gate = frame::Gate::Ownership;
    gpu::TextureMode textures = gpu::TextureMode::Auto;
    gpu::Culling culling = gpu::Culling::Hidden;
    /// Samples a pixel in frames without ids and layers, on any driver; 1: no multisampling; 0: presetSamples.
    std::uint32_t samples = 0;
    std::uint32_t presetSamples = 0; ///< the same of a quality level, with a graphics card only
    float anisotropy = 4.0f;         ///< upper bound of anisotropic filtering
    /// Give free memory back to the system after a part is loaded or released (HeapTuning.h).
    bool givesMemoryBack = false;
    std::optional<std::size_t> quality{}; ///< index in kQualities; none: options were set one by one
};

/// The samples a pixel that a driver draws.
[[nodiscard]] std::uint32_t samplesOn(const gpu::Capabilities& driver, const SessionOptions& options);

/// Sets the loading and drawing options of a quality level. Requires an index into kQualities.
void applyQuality(std::size_t quality, SessionOptions& options);

} // namespace limen::engine
