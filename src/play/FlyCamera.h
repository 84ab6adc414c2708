#pragma once

#include "engine/Camera.h"

namespace limen::play {

/// What the hands ask of a flying camera during one frame.
struct FlyInput {
    double forward = 0.0, right = 0.0, up = 0.0; ///< -1..1 each
    double turnRight = 0.0, turnUp = 0.0;        ///< degrees
    bool fast = false;
    double seconds = 0.0; ///< since the last frame
};

inline constexpr double kFlySpeed = 4.0; ///< metres a second
inline constexpr double kFlyFastFactor = 6.0;
inline constexpr double kMaxFrameSeconds = 0.1; ///< after a stall the eye does not leap

/// The camera after one frame: forward along the line of sight, right level, up along the world's z. Moving
/// slantwise is no faster. Pitch stays within 89 degrees of level; yaw within 0..360.
[[nodiscard]] engine::Camera fly(const engine::Camera& camera, const FlyInput& input);

} // namespace limen::play
