#pragma once

#include "viewer/KeyBindings.h"

#include <string>
#include <vector>

namespace limen::viewer {

inline constexpr double kHintSeconds = 10.0;
inline constexpr double kHintFade = 1.0; ///< seconds, at the end

/// The opacity of the hint bar `seconds` after the world was first shown: 1, then a fade, then 0.
[[nodiscard]] double hintOpacity(double seconds);

/// A key with its effect, in the hint bar.
struct Hint {
    std::string keys, does;
};
/// The keys to begin with. `capturesMouse`: a click captures the mouse.
[[nodiscard]] std::vector<Hint> hints(const KeyBindings& bindings, bool capturesMouse);

/// Draws the hints at the lower edge of the window, in as many lines as needed.
void drawHintBar(const std::vector<Hint>& hints, double opacity);

} // namespace limen::viewer
