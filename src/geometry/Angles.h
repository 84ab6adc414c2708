#pragma once

#include <numbers>

namespace limen {

// Radians.
inline constexpr double kTurn = 2.0 * std::numbers::pi;
inline constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace limen
