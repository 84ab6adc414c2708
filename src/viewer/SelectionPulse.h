#pragma once

#include "frame/FrameView.h"

namespace limen::viewer {

/// The highlight of a selected object: yellow, in pulses of 1.2 s. `seconds`: age of the world.
[[nodiscard]] frame::Highlight selectionPulse(std::uint64_t object, double seconds);

} // namespace limen::viewer
