#include "engine/DynamicStateInput.h"

#include "motion/Locate.h"

namespace limen::engine {
namespace {

world::SpaceIndex playerSpace(const world::World& world, const FrameEye& eye) {
    if (eye.body)
        return eye.body->space;
    return eye.player == eye.camera.eye ? eye.root : motion::locate(world, eye.player).space;
}

} // namespace

motion::DynamicStateInput dynamicsInput(const world::World& world, const FrameEye& eye) {
    const visibility::View view = viewOf(eye.camera, eye.size, eye.root);
    motion::DynamicStateInput input;
    input.seconds = eye.seconds;
    input.allDoors = eye.doors;
    input.doors = eye.eachDoor;
    input.eye = view.eye;
    input.right = view.right;
    input.up = view.up;
    input.forward = view.forward;
    input.player = eye.body;
    const bool isOutside = playerSpace(world, eye) == world::kOutside;
    input.rain = isOutside && eye.weather == Weather::Rain;
    if (isOutside && !world.sky.weather.empty())
        input.weather = world::SkyHour{eye.dayGroup, eye.time};
    return input;
}

} // namespace limen::engine
