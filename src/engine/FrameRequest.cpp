#include "engine/FrameRequest.h"

#include "core/Assert.h"
#include "core/Nearest.h"
#include "engine/DayGroup.h"
#include "frame/GpuLayout.h"
#include "motion/Collisions.h"
#include "motion/Locate.h"
#include "world/Loader.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::engine {
namespace {

Result<world::SpaceIndex> findRoot(const world::World& world, const RootChoice& root, const Vec3& eye,
                                   bool& ambiguous) {
    if (root.rule == RootChoice::Rule::Outside)
        return world::kOutside;
    if (root.rule == RootChoice::Rule::Auto) {
        const motion::Located located = motion::locate(world, eye);
        ambiguous = located.ambiguous;
        return located.space;
    }
    const world::SpaceIndex cell = world::findCell(world, root.cell);
    if (cell == world::kNone)
        return fail(ErrorCode::NotFound, "--root",
                    fmt::format("there is no cell {} in this part of the world; use --root auto",
                                dat::idText(root.cell)));
    return cell;
}

Result<Vec3> placedEye(const world::World& world, const ViewRequest& request) {
    Vec3 eye = request.eye;
    if (!request.isOnGround)
        return eye;
    const double ground = world::terrainHeight(world, eye.x, eye.y);
    if (!std::isfinite(ground))
        return fail(ErrorCode::NotFound, "--at",
                    "there is no ground at these map coordinates; give --eye X,Y,Z instead");
    eye.z = ground + kEyeHeight;
    return eye;
}

Error unknownDoor(const std::string& name, const world::WorldFile& file) {
    std::vector<std::string> names;
    for (const auto& door : file.moving.doors)
        names.push_back(door.name);
    const std::vector<std::string> similar = nearest(name, names, 1);
    return {ErrorCode::NotFound, "--door",
            names.empty() ? fmt::format("unknown door '{}': this world names no doors; use --doors", name)
            : similar.empty()
                ? fmt::format("unknown door '{}'; this world has {}", name, fmt::join(names, ", "))
                : fmt::format("unknown door '{}'.{}", name, didYouMean(similar))};
}

/// Openness by World::doors. Doors that the file names but that are not loaded are left out.
Result<std::vector<double>> eachDoor(const world::World& world, const world::WorldFile& file,
                                     std::span<const check::View::DoorState> states) {
    std::vector<double> open;
    for (const world::Door& door : world.doors)
        open.push_back(door.open);
    for (const check::View::DoorState& state : states) {
        const auto isIt = [&](const auto& door) { return door.name == state.name; };
        const auto found = std::find_if(world.doors.begin(), world.doors.end(), isIt);
        if (found == world.doors.end() &&
            std::none_of(file.moving.doors.begin(), file.moving.doors.end(), isIt))
            return Failure(unknownDoor(state.name, file));
        if (found != world.doors.end())
            open[static_cast<std::size_t>(found - world.doors.begin())] = state.open;
    }
    return open;
}

Result<motion::PlayerBody> placedBody(const world::World& world, const BodyRequest& body) {
    bool ambiguous = false;
    const Result<world::SpaceIndex> space =
        findRoot(world, body.root, motion::Capsule().middle(body.feet), ambiguous);
    if (!space)
        return Failure(space.error());
    return motion::PlayerBody{body.feet, body.yaw, *space, body.opacity, body.speed, body.metres};
}

Result<SceneState> sceneState(const world::World& world, const world::WorldFile& file,
                              const SceneRequest& request) {
    SceneState scene;
    scene.time = request.time;
    const Result<std::uint32_t> day = dayGroupOf(world.sky.desc, world.sky.time, request.day);
    if (!day)
        return Failure(day.error());
    scene.dayGroup = *day;
    scene.weather = request.weather;
    scene.look = request.look;
    scene.seconds = request.seconds;
    scene.doors = request.doors;
    if (!request.eachDoor.empty()) {
        Result<std::vector<double>> doors = eachDoor(world, file, request.eachDoor);
        if (!doors)
            return Failure(doors.error());
        scene.eachDoor = std::move(*doors);
    }
    if (request.body) {
        const Result<motion::PlayerBody> body = placedBody(world, *request.body);
        if (!body)
            return Failure(body.error());
        scene.body = *body;
    }
    return scene;
}

/// Rain needs a day with rain, if the world has one.
std::uint32_t shownDayGroup(const world::World& world, const SceneState& scene) {
    return scene.weather == Weather::Rain ? world::rainyDayGroup(world.sky.desc, scene.dayGroup)
                                          : scene.dayGroup;
}

/// The light that the player carries in cells; without a body it is at the eye.
std::optional<Vec3> viewerLight(const FrameRequest& request, world::SpaceIndex player) {
    constexpr double kAbove = 2.0; // metres above a body's feet
    if (player == world::kOutside)
        return std::nullopt;
    return request.scene.body ? request.scene.body->feet + Vec3(0.0, 0.0, kAbove) : request.scene.player;
}

world::SpaceIndex playerSpace(const world::World& world, const FrameRequest& request) {
    if (request.scene.body)
        return request.scene.body->space;
    return request.scene.player == request.camera.eye ? request.root
                                                      : motion::locate(world, request.scene.player).space;
}

motion::DynamicStateInput dynamicsInputOf(const world::World& world, const FrameRequest& request,
                                          const visibility::View& view) {
    motion::DynamicStateInput input;
    input.seconds = request.scene.seconds;
    input.allDoors = request.scene.doors;
    input.doors = request.scene.eachDoor;
    input.eye = view.eye;
    input.right = view.right;
    input.up = view.up;
    input.forward = view.forward;
    input.player = request.scene.body;
    input.between = request.scene.look == Look::Retail ? motion::BetweenFrames::Held
                                                       : motion::BetweenFrames::Interpolated;
    const bool isOutside = playerSpace(world, request) == world::kOutside;
    input.rain = isOutside && request.scene.weather == Weather::Rain;
    if (isOutside && !world.sky.weather.empty())
        input.weather = world::SkyHour{shownDayGroup(world, request.scene), request.scene.time};
    return input;
}

} // namespace

Result<FrameRequest> frameRequest(const world::World& world, const world::WorldFile& file,
                                  const ViewRequest& request) {
    LIMEN_ASSERT(request.place.empty() && !request.isAtStart, "resolvePlace has filled in the place");
    FrameRequest frame;
    const Result<Vec3> eye = placedEye(world, request);
    if (!eye)
        return Failure(eye.error());
    frame.camera = {*eye, {request.yaw.value_or(0.0), request.pitch.value_or(0.0)}, request.fov};
    frame.size = request.size;
    const Result<world::SpaceIndex> root =
        findRoot(world, request.root.value_or(RootChoice{}), frame.camera.eye, frame.isRootAmbiguous);
    if (!root)
        return Failure(root.error());
    frame.root = *root;
    Result<SceneState> scene = sceneState(world, file, request.scene);
    if (!scene)
        return Failure(scene.error());
    frame.scene = std::move(*scene);
    frame.scene.player = request.player.value_or(frame.camera.eye);
    return frame;
}

void scaleRequest(const FrameRequest& request, std::uint32_t percent, FrameRequest& out) {
    out = request;
    out.size = scaledSize(request.size, percent);
    out.levels = world::levelShareOf(percent);
    if (request.camera.shape.width == 0)
        out.camera.shape = request.size;
}

FrameInputs frameInputs(const world::World& world, const FrameRequest& request, const FrameOutputs& outputs) {
    LIMEN_ASSERT(request.size.width > 0 && request.size.height > 0, "a picture has pixels");
    LIMEN_ASSERT(request.root < world.spaces.size(), "the root is a space of this world");
    FrameInputs inputs;
    frame::FrameView& view = inputs.view;
    view.view = viewOf(request.camera, request.size, request.root);
    view.width = request.size.width;
    view.height = request.size.height;
    view.dayGroup = shownDayGroup(world, request.scene);
    view.timeOfDay = request.scene.time;
    view.seconds = request.scene.seconds;
    view.weather = request.scene.weather;
    view.look = request.scene.look;
    view.viewerLight = viewerLight(request, playerSpace(world, request));
    view.highlights = outputs.highlights;
    view.exactCutOuts = outputs.exactCutOuts;
    // Frames with ids are judged: each is planned in the same way, whatever was planned before.
    view.occlusion = outputs.exactCutOuts ? frame::Occlusion::Always : frame::Occlusion::IfWorthwhile;
    inputs.dynamics = dynamicsInputOf(world, request, view.view);
    if (!outputs.exactCutOuts)
        view.levels = inputs.dynamics.levels = request.levels;
    return inputs;
}

motion::DynamicStateInput dynamicsInput(const world::World& world, const FrameRequest& request) {
    LIMEN_ASSERT(request.root < world.spaces.size(), "the root is a space of this world");
    return dynamicsInputOf(world, request, viewOf(request.camera, request.size, request.root));
}

reference::Camera tracedCamera(const FrameRequest& request) {
    const visibility::View view = viewOf(request.camera, request.size, request.root);
    reference::Camera camera;
    camera.eye = view.eye;
    camera.right = view.right;
    camera.up = view.up;
    camera.forward = view.forward;
    camera.tanHalfX = view.tanHalfX;
    camera.tanHalfY = view.tanHalfY;
    camera.width = request.size.width;
    camera.height = request.size.height;
    camera.root = request.root;
    camera.place = frame::gpu::kPixelPlace;
    return camera;
}

} // namespace limen::engine
