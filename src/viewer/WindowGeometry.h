#pragma once

#include "cli/Parse.h"

#include <optional>

namespace limen::viewer {

/// How large a window is. A screen with small pixels may show its unit as several of them, or ask for larger letters.
struct WindowSizes {
    int width = 0, height = 0; ///< in the units of cursors; 0 when it is made as small as an icon
    engine::PixelSize pixels;  ///< of what is drawn, at least 1 each
    double contentScale = 1.0; ///< what people want things to be larger than on a screen of 96 pixels an inch
};

/// A pixel, from the window's upper left corner.
struct PixelPlace {
    std::uint32_t x = 0, y = 0;
    friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

/// The pixel under a cursor; none: it is not over the window.
[[nodiscard]] std::optional<PixelPlace> pixelAt(const WindowSizes& sizes, double x, double y);

/// By how much letters and boxes are larger than drawn for 96 pixels an inch: in the window's units, and in pixels.
struct UiScale {
    double units = 1.0, pixels = 1.0;
    friend bool operator==(const UiScale&, const UiScale&) = default;
};
/// Within 0.5 and 8: what a desktop says may be nonsense.
[[nodiscard]] UiScale uiScaleOf(const WindowSizes& sizes);

} // namespace limen::viewer
