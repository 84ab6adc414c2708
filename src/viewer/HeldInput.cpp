#include "viewer/HeldInput.h"

#include <algorithm>

namespace limen::viewer {
namespace {

void addSticks(const StickInput& sticks, play::PlayInput& input) {
    input.forward = std::clamp(input.forward + sticks.forward, -1.0, 1.0);
    input.right = std::clamp(input.right + sticks.right, -1.0, 1.0);
    input.turnRight += sticks.turnRight;
    input.turnUp += sticks.turnUp;
    input.fast = input.fast || sticks.fast;
}

} // namespace

void applyLookSettings(HeldInput& held, double speed, bool inverts) {
    held.lookX *= speed;
    held.lookY *= inverts ? -speed : speed;
    if (held.sticks && inverts)
        held.sticks->rightY = -held.sticks->rightY;
}

play::PlayInput inputOf(const HeldInput& held, double seconds) {
    constexpr double kDegreesPerPixel = 0.15;
    const auto axis = [](bool plus, bool minus) { return (plus ? 1.0 : 0.0) - (minus ? 1.0 : 0.0); };
    play::PlayInput input;
    input.seconds = seconds;
    input.forward = axis(held.forward, held.back);
    input.right = axis(held.right, held.left);
    input.up = axis(held.up, held.down);
    input.turnRight = held.lookX * kDegreesPerPixel;
    input.turnUp = -held.lookY * kDegreesPerPixel;
    input.fast = held.fast;
    input.jump = held.jump;
    if (held.sticks)
        addSticks(inputOf(*held.sticks, seconds), input);
    return input;
}

std::vector<play::PlayAct> wheelActs(double notches, const WheelEye& eye) {
    constexpr double kStep = 0.5; // metres a notch
    if (!eye.isWalking || notches == 0.0)
        return {};
    const double farther = -notches * kStep;
    if (!eye.isChased) // the first notch only switches to third person
        return farther < 0.0 ? std::vector<play::PlayAct>{}
                             : std::vector<play::PlayAct>{{play::PlayActKind::Chase},
                                                          {play::PlayActKind::Distance,
                                                           eye.nearest + std::max(farther - kStep, 0.0)}};
    if (farther < 0.0 && eye.distance <= eye.nearest)
        return {{play::PlayActKind::Chase}};
    return {{play::PlayActKind::Distance, std::max(eye.distance + farther, eye.nearest)}};
}

} // namespace limen::viewer
