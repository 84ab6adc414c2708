#pragma once

namespace limen::viewer {

/// Stick positions of a gamepad: -1..1, right and down positive.
struct Sticks {
    float leftX = 0.0f, leftY = 0.0f, rightX = 0.0f, rightY = 0.0f;
};

/// The sticks' input to walking or flying.
struct StickInput {
    double forward = 0.0, right = 0.0;    ///< -1..1 each
    double turnRight = 0.0, turnUp = 0.0; ///< degrees
    bool fast = false;                    ///< full deflection
};

/// The input of a frame of `seconds`. A released stick is never exactly centred, so deflections in the dead
/// zone count as 0. The turning speed grows with the square of the deflection, for fine control.
[[nodiscard]] StickInput inputOf(const Sticks& sticks, double seconds);

} // namespace limen::viewer
