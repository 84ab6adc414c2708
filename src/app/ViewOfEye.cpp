#include "app/ViewOfEye.h"

#include "check/views/Viewpoints.h"
#include "world/Loader.h"

#include <algorithm>

namespace limen::app {
namespace {

std::vector<double> eachDoor(const std::vector<check::View::DoorState>& states, const world::World& world) {
    std::vector<double> open;
    for (const world::Door& door : states.empty() ? std::vector<world::Door>{} : world.doors) {
        const auto found = std::find_if(states.begin(), states.end(),
                                        [&](const auto& state) { return state.name == door.name; });
        open.push_back(found != states.end() ? found->open : door.open);
    }
    return open;
}

} // namespace

FrameEye eyeOf(const check::View& view, const world::World& world, world::SpaceIndex root) {
    FrameEye eye;
    eye.camera = {view.eye, {view.yaw, view.pitch}, view.fov};
    eye.size = {view.width, view.height};
    eye.root = root;
    eye.player = view.player.value_or(view.eye);
    if (view.body) {
        const check::View::Body& body = *view.body;
        const world::SpaceIndex space = body.root == 0 ? world::kOutside : world::findCell(world, body.root);
        if (space != world::kNone)
            eye.body = motion::PlayerBody{body.feet, body.yaw, space, body.opacity, body.speed, body.metres};
    }
    eye.time = view.time;
    eye.seconds = view.seconds;
    eye.doors = view.doors;
    eye.eachDoor = eachDoor(view.eachDoor, world);
    eye.dayGroup = view.dayGroup;
    eye.weather = view.rain ? Weather::Rain : Weather::Clear;
    return eye;
}

check::View viewOf(const FrameEye& eye, const world::World& world) {
    check::View view;
    view.eye = eye.camera.eye;
    view.yaw = eye.camera.heading.yaw;
    view.pitch = eye.camera.heading.pitch;
    view.fov = eye.camera.fovDegrees;
    view.width = eye.size.width;
    view.height = eye.size.height;
    view.root = check::cellIdOf(world, eye.root);
    if (eye.body)
        view.body =
            check::View::Body{eye.body->feet,    eye.body->yaw,   check::cellIdOf(world, eye.body->space),
                              eye.body->opacity, eye.body->speed, eye.body->metres};
    else if (eye.player != eye.camera.eye)
        view.player = eye.player;
    view.time = eye.time;
    view.seconds = eye.seconds;
    view.doors = eye.doors;
    for (std::size_t i = 0; i < std::min(eye.eachDoor.size(), world.doors.size()) && !eye.doors; ++i)
        if (eye.eachDoor[i] != world.doors[i].open)
            view.eachDoor.push_back({world.doors[i].name, eye.eachDoor[i]});
    view.dayGroup = eye.dayGroup;
    view.rain = eye.weather == Weather::Rain;
    return view;
}

} // namespace limen::app
