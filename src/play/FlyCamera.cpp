#include "play/FlyCamera.h"

#include <algorithm>

namespace limen::play {

engine::Camera fly(const engine::Camera& camera, const FlyInput& input) {
    constexpr double kMaxPitch = 89.0;
    engine::Camera result = camera;
    const double yaw = std::fmod(camera.heading.yaw + input.turnRight, 360.0);
    result.heading.yaw = yaw < 0.0 ? yaw + 360.0 : yaw;
    result.heading.pitch = std::clamp(camera.heading.pitch + input.turnUp, -kMaxPitch, kMaxPitch);
    const engine::CameraBasis basis = engine::basisOf(result.heading);
    const Vec3 direction =
        basis.forward * input.forward + basis.right * input.right + Vec3(0.0, 0.0, 1.0) * input.up;
    const double length = glm::length(direction);
    if (length > 0.0) {
        const double speed = kFlySpeed * (input.fast ? kFlyFastFactor : 1.0) * std::min(1.0, length);
        const double seconds = std::clamp(input.seconds, 0.0, kMaxFrameSeconds);
        result.eye += direction * (speed * seconds / length);
    }
    return result;
}

} // namespace limen::play
