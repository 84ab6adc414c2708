#pragma once

#include "engine/Camera.h"

#include <optional>

namespace limen::viewer {

/// Sizes of a window. On screens of high density a screen unit can span several pixels, or the desktop asks
/// for a larger content scale.
struct WindowSizes {
    int width = 0, height = 0; ///< in screen units, as cursor positions; 0 when minimised
    engine::PixelSize pixels;  ///< framebuffer size, at least 1x1
    double contentScale = 1.0; ///< desktop scale relative to 96 pixels an inch
};

/// A pixel; the origin is the window's upper left corner.
struct PixelPlace {
    std::uint32_t x = 0, y = 0;
    friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

/// The pixel under a cursor position; nullopt outside the window.
[[nodiscard]] std::optional<PixelPlace> pixelAt(const WindowSizes& sizes, double x, double y);

/// Scale of fonts and boxes relative to 96 pixels an inch, in screen units and in pixels.
struct UiScale {
    double units = 1.0, pixels = 1.0;
    friend bool operator==(const UiScale&, const UiScale&) = default;
};
/// Clamped to 0.5..8, because a desktop can report nonsense.
[[nodiscard]] UiScale uiScaleOf(const WindowSizes& sizes);

} // namespace limen::viewer
