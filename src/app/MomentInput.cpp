#include "app/MomentInput.h"

#include "motion/Locate.h"

namespace limen::app {

motion::MomentInput momentInput(const world::World& world, const FrameEye& eye) {
    const visibility::View view = viewOf(eye.camera, eye.size, eye.root);
    motion::MomentInput input;
    input.seconds = eye.seconds;
    input.allDoors = eye.doors;
    input.doors = eye.eachDoor;
    input.eye = view.eye;
    input.right = view.right;
    input.up = view.up;
    input.forward = view.forward;
    const world::SpaceIndex player =
        eye.player == eye.camera.eye ? eye.root : motion::locate(world, eye.player).space;
    input.rain = eye.weather == Weather::Rain && player == world::kOutside;
    return input;
}

} // namespace limen::app
