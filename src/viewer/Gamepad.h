#pragma once

namespace limen::viewer {

/// Where the sticks of a gamepad are: -1..1, right and down positive.
struct Sticks {
    float leftX = 0.0f, leftY = 0.0f, rightX = 0.0f, rightY = 0.0f;
};

/// What sticks ask of one who walks or flies.
struct StickInput {
    double forward = 0.0, right = 0.0;    ///< -1..1 each
    double turnRight = 0.0, turnUp = 0.0; ///< degrees
    bool fast = false;                    ///< pushed all the way
};

/// For so many seconds. A stick that is let go is never quite in its middle: near it nothing is asked. Looking grows with the square
/// of the way, so that small turns are small.
[[nodiscard]] StickInput inputOf(const Sticks& sticks, double seconds);

} // namespace limen::viewer
