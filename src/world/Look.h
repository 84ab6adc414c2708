#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace limen::world {

/// A way of drawing where the original's way costs smoothness (docs/retail.md). Ids are the same in both at any
/// time at which the frames of animations are the same.
enum class Look : std::uint8_t {
    Retail, ///< the original's: lamps light walls at vertices, frames of animations are held, the ground has no grain
    Enhanced ///< lamps light walls per pixel, frames are interpolated, the ground has its detail picture
};

[[nodiscard]] constexpr std::string_view nameOf(Look look) {
    return look == Look::Retail ? "retail" : "enhanced";
}
[[nodiscard]] constexpr std::optional<Look> lookNamed(std::string_view name) {
    for (const Look look : {Look::Retail, Look::Enhanced})
        if (name == nameOf(look))
            return look;
    return std::nullopt;
}

} // namespace limen::world
