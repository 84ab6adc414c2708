#include "viewer/photo/PhotoMode.h"

#include "engine/picture/LargePicture.h"
#include "play/FlyCamera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::viewer {
namespace {

double aspectOf(engine::PixelSize size) {
    return static_cast<double>(size.width) / static_cast<double>(size.height);
}

} // namespace

PhotoMode::PhotoMode(const engine::FrameRequest& world) : request_(world), tracker_(world.root) {
    settings_.time = world.scene.time;
    settings_.dayGroup = world.scene.dayGroup;
    settings_.weather = world.scene.weather;
    settings_.fov = std::clamp(world.camera.fovDegrees, PhotoSettings::kLeastFov, PhotoSettings::kMostFov);
    settings_.showsBody = world.scene.body && world.scene.body->opacity > 0.0;
}

void PhotoMode::set(const PhotoSettings& settings) {
    settings_ = settings;
    settings_.time = std::clamp(settings.time, 0.0, 1.0);
    settings_.fov = std::clamp(settings.fov, PhotoSettings::kLeastFov, PhotoSettings::kMostFov);
    settings_.size = std::min(settings.size, kPhotoSizes.size() - 1);
    settings_.supersample = std::clamp(settings.supersample, 1u, engine::kMostSupersampling);
}

void PhotoMode::move(const world::World& world, const play::PlayInput& input) {
    play::FlyInput hands;
    hands.turnRight = input.turnRight;
    hands.turnUp = input.turnUp;
    hands.forward = input.forward;
    hands.right = input.right;
    hands.up = input.up;
    hands.fast = input.fast;
    hands.seconds = input.seconds;
    const Vec3 from = request_.camera.eye;
    request_.camera = play::fly(request_.camera, hands);
    request_.root = tracker_.move(world, from, request_.camera.eye, input.seconds);
}

engine::PixelSize PhotoMode::sizeIn(engine::PixelSize window) const {
    const engine::PixelSize chosen = kPhotoSizes[settings_.size].pixels;
    return chosen.width > 0 ? chosen : window;
}

engine::FrameRequest PhotoMode::picture(engine::PixelSize window) const {
    engine::FrameRequest frame = request_;
    frame.size = sizeIn(window);
    frame.camera.fovDegrees = settings_.fov;
    frame.scene.time = settings_.time;
    frame.scene.dayGroup = settings_.dayGroup;
    frame.scene.weather = settings_.weather;
    if (frame.scene.body)
        frame.scene.body->opacity = settings_.showsBody ? 1.0 : 0.0;
    return frame;
}

engine::FrameRequest PhotoMode::preview(engine::PixelSize window) const {
    constexpr double kRadians = std::numbers::pi / 360.0; // of half an angle in degrees
    engine::FrameRequest frame = picture(window);
    const double wider = std::max(1.0, aspectOf(frame.size) / aspectOf(window));
    if (wider > 1.0)
        frame.camera.fovDegrees = std::atan(std::tan(settings_.fov * kRadians) * wider) / kRadians;
    frame.size = window;
    return frame;
}

Vec2 shownShare(engine::PixelSize picture, engine::PixelSize window) {
    const double wider = aspectOf(picture) / aspectOf(window);
    return {std::min(1.0, wider), std::min(1.0, 1.0 / wider)};
}

} // namespace limen::viewer
