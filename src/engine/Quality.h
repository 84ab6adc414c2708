#pragma once

#include "world/Loader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace limen::engine {

/// A quality level: the size of the loaded part, sampling, and the scale of pictures in the window. The ray rule
/// holds at every level; levels differ only in distance and smoothness.
struct Quality {
    const char* name;
    int radius, farRadius; ///< in blocks: the near tier, and the far tier (ground only)
    double detail;         ///< as world::LoadOptions::detail
    std::uint32_t samples; ///< samples a pixel, with a graphics card
    float anisotropy;      ///< upper bound of anisotropic filtering, with a graphics card
    /// Limits of the window's automatic scale, per cent each way (viewer/scale/FrameScale.h).
    std::uint32_t leastScale, mostScale;
};

inline constexpr std::array kQualities{
    Quality{"low", 1, 6, 0.5, 1, 1.0f, 50, 60}, Quality{"medium", 2, 9, 0.75, 1, 2.0f, 50, 80},
    Quality{"high", 4, 12, 1.0, 1, 4.0f, 50, 100}, Quality{"ultra", 6, 16, 2.0, 4, 16.0f, 75, 100}};

/// The index in kQualities of the level with this name.
[[nodiscard]] inline std::optional<std::size_t> qualityNamed(std::string_view name) {
    for (std::size_t i = 0; i < kQualities.size(); ++i)
        if (kQualities[i].name == name)
            return i;
    return std::nullopt;
}

/// `load` with the options of a quality level; the other options stay.
[[nodiscard]] inline world::LoadOptions loadBy(const Quality& quality, world::LoadOptions load) {
    load.radius = quality.radius;
    load.farRadius = quality.farRadius;
    load.detail = quality.detail;
    return load;
}

} // namespace limen::engine
