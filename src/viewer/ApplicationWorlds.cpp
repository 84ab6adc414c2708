#include "viewer/Application.h"

#include "engine/Quality.h"
#include "viewer/open/PathCompletion.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::viewer {

void Application::open(const std::string& typed) {
    dropOpening();
    const std::string directory = absoluteDirectory(typed);
    OpenRequest request{directory, options_.session, {}};
    request.options.dat = directory;
    const auto quality = engine::qualityNamed(settings_.quality);
    if (!options_.isQualityFixed && quality)
        engine::applyQuality(*quality, request.options);
    const auto last = settings_.lastPlaces.find(directory);
    const std::optional<LastPlace> place =
        last == settings_.lastPlaces.end() ? std::nullopt : std::make_optional(last->second);
    if (isFirstWorld_ && options_.start)
        request.start = options_.start;
    else
        request.start = [this, place](const engine::WorldSource& source) { return startIn(source, place); };
    opening_ = std::make_unique<WorldOpening>(device_, std::move(request));
    go({PageEvent::Kind::Begin, Page::Loading, nameOfWorld(directory)});
}

/// Called on another thread: uses constant members only.
Result<engine::ViewRequest> Application::startIn(const engine::WorldSource& source,
                                                 const std::optional<LastPlace>& last) const {
    std::optional<engine::RememberedPlace> remembered;
    if (last)
        remembered = {last->eye, last->yaw, last->pitch, last->cell};
    const std::optional<engine::ViewRequest> at = engine::firstView(source, remembered);
    if (!at)
        return limen::fail(ErrorCode::NotFound, source.archive.directory().string(),
                           "the world has no place to start at; name one with --eye X,Y,Z");
    engine::ViewRequest view = options_.view;
    view.place.clear();
    view.eye = at->eye;
    view.isOnGround = at->isOnGround;
    // A heading of the command line applies to the first world.
    view.yaw = isFirstWorld_ && view.yaw ? view.yaw : at->yaw;
    view.pitch = isFirstWorld_ && view.pitch ? view.pitch : at->pitch;
    view.root = at->root;
    view.player.reset();
    return view;
}

Result<void> Application::finishOpening() {
    while (opening_) {
        const Result<bool> ready = opening_->step();
        if (!ready) {
            fail(ready.error().message());
            return Failure(ready.error());
        }
        if (*ready)
            show(opening_->take());
        else
            opening_->wait(0.05);
    }
    return {};
}

void Application::stepOpening() {
    const Result<bool> ready = opening_->step();
    device_.restoreState();
    if (!ready)
        return fail(ready.error().message());
    if (*ready)
        show(opening_->take());
}

void Application::fail(const std::string& reason) {
    opening_.reset();
    notes_.push_back(reason);
    go({PageEvent::Kind::Failed, Page::Open, reason});
}

void Application::dropOpening() {
    if (!opening_)
        return;
    opening_->cancel();
    cancelled_.push_back(std::move(opening_));
}

void Application::show(OpenedWorld opened) {
    const std::string directory = opening_->directory();
    opening_.reset();
    noteLastPlace();
    endRecording();
    photo_.reset();
    world_.reset(); // before the new one: frees its memory and ends its threads
    world_ = std::make_unique<WorldView>(device_, std::move(opened));
    directory_ = directory;
    if (!options_.flies)
        world_->act({play::PlayActKind::Walk});
    if (options_.isChased)
        world_->act({play::PlayActKind::Chase});
    if (settings_.fieldOfView != world_->request().camera.fovDegrees && !isFovFixed())
        world_->act({play::PlayActKind::Fov, settings_.fieldOfView});
    if (!options_.isLookFixed && settings_.look != world_->request().scene.look)
        showLook();
    if (isFirstWorld_ && !options_.record.empty())
        beginRecording();
    isFirstWorld_ = false;
    hintSeconds_ = 0.0;
    addRecent(settings_, directory);
    keepSettings();
    window_.setTitle("Limen: " + nameOfWorld(directory));
    go({PageEvent::Kind::Loaded, Page::World, {}});
}

void Application::noteLastPlace() {
    if (!world_)
        return;
    const engine::FrameRequest& request = world_->request();
    LastPlace& place = settings_.lastPlaces[directory_];
    const motion::PlayerBody* body = request.scene.body ? &*request.scene.body : nullptr;
    place = {.name = {},
             .eye = request.camera.eye,
             .yaw = request.camera.heading.yaw,
             .pitch = request.camera.heading.pitch,
             .cell = engine::cellOf(world_->session().part().world, request.root)};
    if (body != nullptr && world_->walk().isChased()) { // the head, not the camera behind it
        place.eye = body->feet + Vec3(0.0, 0.0, engine::kEyeHeight);
        place.cell = engine::cellOf(world_->session().part().world, body->space);
    }
    double nearest = 200.0; // metres; farther places do not name it
    for (const world::Place& named : world_->session().source().file.places)
        if (const double away = glm::length(named.eye - place.eye); away < nearest) {
            nearest = away;
            place.name = named.name;
        }
}

} // namespace limen::viewer
