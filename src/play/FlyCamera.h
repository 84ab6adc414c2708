#pragma once

#include "engine/Camera.h"

namespace limen::play {

/// The player's input to a flying camera for one frame.
struct FlyInput {
    double forward = 0.0, right = 0.0, up = 0.0; ///< -1..1 each
    double turnRight = 0.0, turnUp = 0.0;        ///< degrees
    bool fast = false;
    double seconds = 0.0; ///< since the last frame
};

inline constexpr double kFlySpeed = 4.0; ///< metres a second
inline constexpr double kFlyFastFactor = 6.0;
inline constexpr double kMaxFrameSeconds = 0.1; ///< limits the movement after a stall

/// The camera after one frame. `forward` moves along the line of sight, `right` horizontally, `up` along the
/// world's z; diagonal movement is no faster. Pitch is clamped to 89 degrees, yaw is wrapped to 0..360.
[[nodiscard]] engine::Camera fly(const engine::Camera& camera, const FlyInput& input);

} // namespace limen::play
