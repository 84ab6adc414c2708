#include "viewer/SelectionPulse.h"

#include <cmath>
#include <numbers>

namespace limen::viewer {

frame::Highlight selectionPulse(std::uint64_t object, double seconds) {
    constexpr double kPulse = 1.2; // seconds
    constexpr std::uint32_t kYellow = 0x0040D0FFu;
    const double wave = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * seconds / kPulse);
    const auto strength = static_cast<std::uint32_t>(std::lround(40.0 + 120.0 * wave));
    return {object, kYellow | strength << 24};
}

} // namespace limen::viewer
