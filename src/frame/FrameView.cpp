#include "frame/FrameView.h"

#include "core/Assert.h"

#include <numbers>

namespace limen::frame {

FrameView makeView(const Vec3& eye, double yaw, double pitch, double fovY, std::uint32_t width,
                   std::uint32_t height, std::uint32_t root) {
    LIMEN_ASSERT(width > 0 && height > 0, "a picture needs at least one pixel in each direction");
    LIMEN_ASSERT(fovY > 0.0 && fovY < 180.0, "the field of view must be between 0 and 180 degrees");
    constexpr double kRadians = std::numbers::pi / 180.0;
    const double a = yaw * kRadians;
    const double b = pitch * kRadians;
    FrameView frame;
    frame.view.eye = eye;
    frame.view.forward = {std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b)};
    frame.view.right = {std::cos(a), -std::sin(a), 0.0};
    frame.view.up = glm::cross(frame.view.right, frame.view.forward);
    frame.view.tanHalfY = std::tan(fovY * kRadians / 2.0);
    frame.view.tanHalfX = frame.view.tanHalfY * width / height;
    frame.view.root = root;
    frame.width = width;
    frame.height = height;
    return frame;
}

} // namespace limen::frame
