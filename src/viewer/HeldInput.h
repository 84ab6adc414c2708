#pragma once

#include "play/PlayInput.h"
#include "viewer/Gamepad.h"

#include <optional>
#include <vector>

namespace limen::viewer {

/// What hands hold down just now.
struct HeldInput {
    bool forward = false, back = false, left = false, right = false, up = false, down = false, fast = false;
    bool jump = false;
    double lookX = 0.0, lookY = 0.0; ///< pixels dragged since the last poll, y down
    double wheel = 0.0;              ///< notches turned since the last poll, away from the hand
    std::optional<Sticks> sticks;    ///< of the first gamepad, if there is one
};

/// What they ask of a frame of so many seconds. Without size, acts and what is frozen.
[[nodiscard]] play::PlayInput inputOf(const HeldInput& held, double seconds);

/// Where the eye is that a wheel moves.
struct WheelEye {
    bool isWalking = false;
    bool isChased = false; ///< it is behind the body
    double distance = 0.0; ///< from the head, metres, or what it would be
    double nearest = 1.0;  ///< that may be
};

/// What turning the wheel does: towards the hand the eye leaves the head and goes away from it; away from the hand it comes nearer, and
/// once it is as near as may be, into the head. Nothing when one flies.
[[nodiscard]] std::vector<play::PlayAct> wheelActs(double notches, const WheelEye& eye);

} // namespace limen::viewer
