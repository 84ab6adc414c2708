#pragma once

#include <cstdint>

namespace limen::viewer {

/// The user's choice of scale and frame rate.
struct ScaleWish {
    std::uint32_t percent = 0; ///< 50..100; 0: automatic
    double frameRate =
        0.0; ///< frames a second that the automatic scale keeps; 0: kSoftwareRate or the display's
    friend bool operator==(const ScaleWish&, const ScaleWish&) = default;
};
inline constexpr std::uint32_t kLeastScale = 50, kFullScale = 100;
inline constexpr double kLeastRate = 5.0, kMostRate = 1000.0;
inline constexpr double kSoftwareRate = 30.0; ///< frames a second without a graphics card

} // namespace limen::viewer
