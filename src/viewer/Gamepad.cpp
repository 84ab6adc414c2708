#include "viewer/Gamepad.h"

#include "geometry/Vec.h"

#include <algorithm>
#include <cmath>

namespace limen::viewer {
namespace {

constexpr double kMiddle = 0.18;    // dead zone, share of the full deflection
constexpr double kAllTheWay = 0.97; // deflection from which the body runs
constexpr double kTurn = 180.0;     // yaw at full deflection, degrees a second
constexpr double kNod = 110.0;      // pitch at full deflection, degrees a second

/// The stick's direction with a length of 0..1 beyond the dead zone.
Vec2 outOfTheMiddle(float x, float y) {
    const double length = std::hypot(double{x}, double{y});
    if (!(length > kMiddle))
        return Vec2(0.0);
    const double share = std::min((length - kMiddle) / (1.0 - kMiddle), 1.0);
    return Vec2(x, y) * (share / length);
}

} // namespace

StickInput inputOf(const Sticks& sticks, double seconds) {
    const Vec2 go = outOfTheMiddle(sticks.leftX, sticks.leftY),
               look = outOfTheMiddle(sticks.rightX, sticks.rightY);
    const double speed = glm::length(look) * std::max(seconds, 0.0);
    return {.forward = -go.y,
            .right = go.x,
            .turnRight = look.x * speed * kTurn,
            .turnUp = -look.y * speed * kNod,
            .fast = glm::length(go) >= kAllTheWay};
}

} // namespace limen::viewer
