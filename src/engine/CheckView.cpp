#include "engine/CheckView.h"

#include "check/Standing.h"
#include "world/Loader.h"

#include <algorithm>

namespace limen::engine {
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

FrameRequest requestOf(const check::View& view, const world::World& world, world::SpaceIndex root) {
    FrameRequest eye;
    eye.camera = {view.eye, {view.yaw, view.pitch}, view.fov};
    eye.size = {view.width, view.height};
    eye.root = root;
    eye.scene.player = view.player.value_or(view.eye);
    if (view.body) {
        const check::View::Body& body = *view.body;
        const world::SpaceIndex space = body.root == 0 ? world::kOutside : world::findCell(world, body.root);
        if (space != world::kNone)
            eye.scene.body =
                motion::PlayerBody{body.feet, body.yaw, space, body.opacity, body.speed, body.metres};
    }
    eye.scene.time = view.time;
    eye.scene.seconds = view.seconds;
    eye.scene.doors = view.doors;
    eye.scene.eachDoor = eachDoor(view.eachDoor, world);
    eye.scene.dayGroup = view.dayGroup;
    eye.scene.weather = view.rain ? Weather::Rain : Weather::Clear;
    return eye;
}

check::View viewOf(const FrameRequest& eye, const world::World& world) {
    check::View view;
    view.eye = eye.camera.eye;
    view.yaw = eye.camera.heading.yaw;
    view.pitch = eye.camera.heading.pitch;
    view.fov = eye.camera.fovDegrees;
    view.width = eye.size.width;
    view.height = eye.size.height;
    view.root = check::cellIdOf(world, eye.root);
    if (eye.scene.body)
        view.body = check::View::Body{
            eye.scene.body->feet,    eye.scene.body->yaw,   check::cellIdOf(world, eye.scene.body->space),
            eye.scene.body->opacity, eye.scene.body->speed, eye.scene.body->metres};
    else if (eye.scene.player != eye.camera.eye)
        view.player = eye.scene.player;
    view.time = eye.scene.time;
    view.seconds = eye.scene.seconds;
    view.doors = eye.scene.doors;
    for (std::size_t i = 0; i < std::min(eye.scene.eachDoor.size(), world.doors.size()) && !eye.scene.doors;
         ++i)
        if (eye.scene.eachDoor[i] != world.doors[i].open)
            view.eachDoor.push_back({world.doors[i].name, eye.scene.eachDoor[i]});
    view.dayGroup = eye.scene.dayGroup;
    view.rain = eye.scene.weather == Weather::Rain;
    return view;
}

std::string reproduction(const world::World& world, const FrameRequest& request,
                         const std::string& datOption) {
    return "limen shot" + datOption + " " + check::shotOptions(viewOf(request, world));
}

} // namespace limen::engine
