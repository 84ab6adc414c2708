#pragma once

#include <cstdint>

namespace limen::world {

/// A way of drawing where the original's way costs smoothness (docs/retail.md). Ids are the same in both at any
/// time at which the frames of animations are the same.
enum class Look : std::uint8_t {
    Retail,  ///< the original's: lamps light walls at vertices, frames of animations are held, the ground has no grain
    Enhanced ///< lamps light walls per pixel, frames are interpolated, the ground has its detail picture
};

} // namespace limen::world
