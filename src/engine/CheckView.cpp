#include "engine/CheckView.h"

#include "check/views/Viewpoints.h"
#include "core/Assert.h"
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
    LIMEN_ASSERT(root < world.spaces.size(), "the root is a space of this world");
    FrameRequest request;
    request.camera = {view.eye, {view.yaw, view.pitch}, view.fov};
    request.size = {view.width, view.height};
    request.root = root;
    request.scene.player = view.player.value_or(view.eye);
    if (view.body) {
        const check::View::Body& body = *view.body;
        const world::SpaceIndex space = body.root == 0 ? world::kOutside : world::findCell(world, body.root);
        if (space != world::kNone)
            request.scene.body =
                motion::PlayerBody{body.feet, body.yaw, space, body.opacity, body.speed, body.metres};
    }
    request.scene.time = view.time;
    request.scene.seconds = view.seconds;
    request.scene.doors = view.doors;
    request.scene.eachDoor = eachDoor(view.eachDoor, world);
    request.scene.dayGroup = view.dayGroup;
    request.scene.weather = view.rain ? Weather::Rain : Weather::Clear;
    request.scene.look = view.look;
    return request;
}

check::View viewOf(const FrameRequest& request, const world::World& world) {
    LIMEN_ASSERT(request.root < world.spaces.size(), "the request is of this world");
    check::View view;
    view.eye = request.camera.eye;
    view.yaw = request.camera.heading.yaw;
    view.pitch = request.camera.heading.pitch;
    view.fov = request.camera.fovDegrees;
    view.width = request.size.width;
    view.height = request.size.height;
    view.root = check::cellIdOf(world, request.root);
    if (request.scene.body)
        view.body = check::View::Body{request.scene.body->feet,
                                      request.scene.body->yaw,
                                      check::cellIdOf(world, request.scene.body->space),
                                      request.scene.body->opacity,
                                      request.scene.body->speed,
                                      request.scene.body->metres};
    else if (request.scene.player != request.camera.eye)
        view.player = request.scene.player;
    view.time = request.scene.time;
    view.seconds = request.scene.seconds;
    view.doors = request.scene.doors;
    for (std::size_t i = 0;
         i < std::min(request.scene.eachDoor.size(), world.doors.size()) && !request.scene.doors; ++i)
        if (request.scene.eachDoor[i] != world.doors[i].open)
            view.eachDoor.push_back({world.doors[i].name, request.scene.eachDoor[i]});
    view.dayGroup = request.scene.dayGroup;
    view.rain = request.scene.weather == Weather::Rain;
    view.look = request.scene.look;
    return view;
}

std::string readingsOption(const world::Readings& readings) {
    const std::string text = world::textOf(readings);
    return text.empty() ? "" : " --readings=" + text;
}

std::string reproduction(const world::World& world, const FrameRequest& request,
                         const std::string& datOption) {
    return "limen shot" + datOption + readingsOption(world.readings) + " " +
           check::shotOptions(viewOf(request, world));
}

} // namespace limen::engine
