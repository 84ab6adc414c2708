#include "engine/Camera.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::engine {
namespace {

struct SinCos {
    double sin = 0.0, cos = 1.0;
};

/// Sine and cosine of an angle in degrees, exact at multiples of 90. Otherwise the rounding of pi could move
/// the ray of a camera that looks along an axis to the wrong side of a portal's plane.
SinCos sinCosDegrees(double degrees) {
    const double turned = std::remainder(degrees, 360.0); // -180..180, exact
    const double quarter = std::nearbyint(turned / 90.0);
    const double rest = (turned - quarter * 90.0) * (std::numbers::pi / 180.0);
    const double s = std::sin(rest), c = std::cos(rest);
    switch (static_cast<int>(quarter) & 3) {
    case 0:
        return {s, c};
    case 1:
        return {c, -s};
    case 2:
        return {-s, -c};
    default:
        return {-c, s};
    }
}

} // namespace

CameraBasis basisOf(const Heading& heading) {
    const SinCos yaw = sinCosDegrees(heading.yaw), pitch = sinCosDegrees(heading.pitch);
    return {Vec3(yaw.cos, -yaw.sin, 0.0), Vec3(-yaw.sin * pitch.sin, -yaw.cos * pitch.sin, pitch.cos),
            Vec3(yaw.sin * pitch.cos, yaw.cos * pitch.cos, pitch.sin)};
}

Heading headingOf(const Vec3& direction) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const double flat = std::hypot(direction.x, direction.y);
    const double yaw =
        flat > 1e-9 * std::abs(direction.z) ? std::atan2(direction.x, direction.y) * kDegrees : 0.0;
    return {yaw < 0.0 ? yaw + 360.0 : yaw, std::atan2(direction.z, flat) * kDegrees};
}

PixelSize scaledSize(PixelSize size, std::uint32_t percent) {
    LIMEN_ASSERT(percent > 0 && percent <= 100, "a picture is drawn at full size or smaller");
    const auto scaled = [percent](std::uint32_t side) { return std::max((side * percent + 50) / 100, 1u); };
    return {scaled(size.width), scaled(size.height)};
}

visibility::View viewOf(const Camera& camera, PixelSize size, std::uint32_t root) {
    const CameraBasis basis = basisOf(camera.heading);
    LIMEN_ASSERT(size.width > 0 && size.height > 0, "a picture has pixels");
    LIMEN_ASSERT(camera.fovDegrees > 0.0 && camera.fovDegrees < 180.0,
                 "a perspective has a finite image plane");
    visibility::View view;
    view.eye = camera.eye;
    view.right = basis.right;
    view.up = basis.up;
    view.forward = basis.forward;
    view.tanHalfY = std::tan(camera.fovDegrees * (std::numbers::pi / 360.0));
    const PixelSize shape = camera.shape.width > 0 ? camera.shape : size;
    view.tanHalfX = view.tanHalfY * static_cast<double>(shape.width) / static_cast<double>(shape.height);
    view.root = root;
    return view;
}

} // namespace limen::engine
