#include "viewer/Gamepad.h"

#include "geometry/Vec.h"

#include <algorithm>
#include <cmath>

namespace limen::viewer {
namespace {

constexpr double kMiddle = 0.18;    // of the way out: nothing is asked within it
constexpr double kAllTheWay = 0.97; // from here on one runs
constexpr double kTurn = 180.0;     // degrees a second, at most
constexpr double kNod = 110.0;      // likewise

/// The stick's direction, as long as it is out of its middle, 0..1.
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
