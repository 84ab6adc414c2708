#pragma once

#include "play/PlayInput.h"
#include "viewer/Gamepad.h"

#include <optional>
#include <vector>

namespace limen::viewer {

/// The keys, mouse and sticks as the player holds them now.
struct HeldInput {
    bool forward = false, back = false, left = false, right = false, up = false, down = false, fast = false;
    bool jump = false;
    double lookX = 0.0, lookY = 0.0; ///< pixels dragged since the last poll, y down
    double wheel = 0.0;              ///< notches turned away from the user since the last poll
    std::optional<Sticks> sticks;    ///< of the first gamepad; none without a gamepad
};

/// Applies the user's mouse settings. `speed`: factor on mouse turns. `inverts`: pushing the mouse or the right
/// stick away looks down.
void applyLookSettings(HeldInput& held, double speed, bool inverts);

/// The held input as a play input for a frame of `seconds`. Size, acts and isFrozen stay at their defaults.
[[nodiscard]] play::PlayInput inputOf(const HeldInput& held, double seconds);

/// The camera state that the mouse wheel changes.
struct WheelEye {
    bool isWalking = false;
    bool isChased = false; ///< third person
    double distance = 0.0; ///< third-person distance from the head, metres; kept in first person
    double nearest = 1.0;  ///< smallest third-person distance, metres
};

/// The acts of a wheel turn. Towards the user: switch to third person, then increase the distance. Away from
/// the user: decrease the distance, at the smallest one switch to first person. None while flying.
[[nodiscard]] std::vector<play::PlayAct> wheelActs(double notches, const WheelEye& eye);

} // namespace limen::viewer
