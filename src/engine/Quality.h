#pragma once

#include "world/Loader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace limen::engine {

/// How much of a world is loaded, and how finely it is drawn. None of it changes what is right, only how far and how smooth.
struct Quality {
    const char* name;
    int radius, farRadius; ///< blocks with everything, and with their ground alone
    double detail;         ///< as LoadOptions::detail
    std::uint32_t samples; ///< a pixel
    float anisotropy;      ///< at most
};

inline constexpr std::array kQualities{
    Quality{"low", 2, 6, 0.5, 1, 1.0f}, Quality{"medium", 3, 9, 0.75, 1, 2.0f},
    Quality{"high", 4, 12, 1.0, 1, 4.0f}, Quality{"ultra", 6, 16, 2.0, 4, 16.0f}};

/// Index into kQualities.
[[nodiscard]] inline std::optional<std::size_t> qualityNamed(std::string_view name) {
    for (std::size_t i = 0; i < kQualities.size(); ++i)
        if (kQualities[i].name == name)
            return i;
    return std::nullopt;
}

/// What a quality says of loading; the rest stays.
[[nodiscard]] inline world::LoadOptions loadBy(const Quality& quality, world::LoadOptions load) {
    load.radius = quality.radius;
    load.farRadius = quality.farRadius;
    load.detail = quality.detail;
    return load;
}

} // namespace limen::engine
