#include "play/Play.h"

#include "core/Assert.h"
#include "engine/Quality.h"
#include "engine/map/MapCoordinates.h"
#include "motion/TravelReach.h"
#include "play/FlyCamera.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace limen::play {
namespace {

/// Whether a destination is far enough inside the shown part to go there while the rest of its surroundings
/// loads.
bool isWithin(const engine::LoadedPart& shown, const engine::ViewRequest& view) {
    const dat::BlockCoord at = engine::centreOf(view), centre = shown.target.centre;
    const int away = std::max(std::abs(at.x - centre.x), std::abs(at.y - centre.y));
    const world::Block* block = world::findBlock(shown.world, at);
    return block != nullptr && !block->isFar && away <= shown.target.options.radius / 2 &&
           (!view.root || view.root->rule != engine::RootChoice::Rule::Cell ||
            world::findCell(shown.world, view.root->cell) != world::kNone);
}

} // namespace

Play::Play(engine::Session& session, engine::FrameRequest start, engine::Residency* residency)
    : session_(session), residency_(residency != nullptr ? *residency : session), request_(std::move(start)),
      tracker_(request_.root) {
    const std::vector<world::Door>& doors = session_.part().world.doors;
    for (std::size_t i = 0; i < std::min(doors.size(), request_.scene.eachDoor.size()); ++i)
        if (request_.scene.eachDoor[i] != doors[i].open)
            doors_.put(doors[i], request_.scene.eachDoor[i]);
}

Result<void> Play::step(const PlayInput& input) {
    LIMEN_ASSERT(steps_ == 0 || session_.frames() != framesAtStep_, "draw each frame before the next step");
    ++steps_;
    framesAtStep_ = session_.frames();
    for (const PlayAct& act : input.acts)
        this->act(act);
    const double seconds = input.isFrozen ? 0.0 : input.seconds;
    moveDoors(seconds); // first, so that the frame shows a pushed body at its new position
    if (Result<void> moved = moveEye(input); !moved)
        return moved;
    findDoor();
    request_.scene.seconds += seconds;
    request_.size = input.size;
    return {};
}

void Play::act(const PlayAct& act) {
    switch (act.kind) {
    case PlayActKind::Walk:
        walk_.isOn() ? walk_.end(request_) : beginToWalk();
        tracker_.place(request_.root);
        return;
    case PlayActKind::Chase:
        walk_.chase(!walk_.isChased());
        return;
    case PlayActKind::Doors:
        swingDoors();
        return;
    case PlayActKind::Use:
        useDoor();
        return;
    case PlayActKind::Weather:
        request_.scene.weather =
            request_.scene.weather == engine::Weather::Rain ? engine::Weather::Clear : engine::Weather::Rain;
        return;
    case PlayActKind::Look:
        request_.scene.look = act.value > 0.0 ? engine::Look::Enhanced : engine::Look::Retail;
        return;
    case PlayActKind::Day:
        if (act.value >= 0.0 &&
            act.value < static_cast<double>(session_.part().world.sky.desc.dayGroups.size()))
            request_.scene.dayGroup = static_cast<std::uint32_t>(act.value);
        return;
    case PlayActKind::Fov:
        request_.camera.fovDegrees = std::clamp(act.value, 1.0, 170.0);
        return;
    case PlayActKind::Place:
        goTo(static_cast<std::size_t>(std::max(act.value, 0.0)));
        return;
    case PlayActKind::Go:
        goTo(Vec2(act.value, act.north));
        return;
    case PlayActKind::Object:
        goToObject(act.value);
        return;
    case PlayActKind::Time:
        request_.scene.time = std::clamp(act.value, 0.0, 1.0);
        return;
    case PlayActKind::AllDoors:
        standDoors(act.value);
        return;
    case PlayActKind::Distance:
        walk_.keepDistance(act.value);
        return;
    case PlayActKind::Quality:
        if (act.value >= 0.0 && act.value < static_cast<double>(engine::kQualities.size()))
            session_.setQuality(static_cast<std::size_t>(act.value));
        return;
    }
}

/// Puts the body under the eye; it falls to the ground. If the solids cannot be read, the eye keeps flying.
void Play::beginToWalk() {
    if (!walk_.begin(session_, request_))
        walk_.end(request_);
}

/// Opens all doors, or closes them if they are open or opening. The swing takes one second.
void Play::swingDoors() {
    const double towards = doorsTowards_.value_or(request_.scene.doors.value_or(0.0));
    doorsTowards_ = towards < 0.5 ? 1.0 : 0.0;
    if (!request_.scene.doors)
        request_.scene.doors = 1.0 - *doorsTowards_;
}

void Play::standDoors(double open) {
    doorsTowards_.reset(); // the caller sets them directly
    if (open >= 0.0 && request_.scene.doors)
        swingAllTo(std::min(open, 1.0));
    else
        request_.scene.doors = open < 0.0 ? std::nullopt : std::make_optional(std::min(open, 1.0));
}

/// Ends the state that all doors share: from now on each door keeps its own openness. Without a door, a travel portal is
/// used.
void Play::useDoor() {
    if (!door_)
        return useTravel();
    const world::World& world = session_.part().world;
    if (request_.scene.doors)
        doors_.putAll(world, *request_.scene.doors);
    request_.scene.doors.reset();
    doorsTowards_.reset();
    if (!doors_.use(world.doors[*door_]))
        refusal_ = Refusal{*door_, request_.scene.seconds};
}

bool Play::isRefused() const {
    constexpr double kShown = 2.0; // seconds
    const double since = refusal_ ? request_.scene.seconds - refusal_->seconds : kShown;
    return since >= 0.0 && since < kShown && door_ == refusal_->door;
}

void Play::useTravel() {
    const world::World& world = session_.part().world;
    const std::optional<std::size_t> portal =
        motion::travelInReach(world, request_.camera.eye, engine::basisOf(request_.camera.heading).forward);
    if (!portal)
        return;
    const world::TravelEntry& to = *world.placed[*portal].travel;
    engine::ViewRequest view;
    view.eye = to.feet + Vec3(0.0, 0.0, engine::kEyeHeight);
    view.yaw = to.yaw;
    view.pitch = 0.0;
    view.root = to.cell != 0 ? engine::RootChoice{engine::RootChoice::Rule::Cell, to.cell}
                             : engine::RootChoice{engine::RootChoice::Rule::Auto, 0};
    going_ = {std::move(view), world.placed[*portal].name};
}

void Play::goTo(std::size_t place) {
    const std::vector<world::Place>& places = session_.source().file.places;
    if (place < places.size())
        going_ = {engine::requestAt(places[place]), places[place].name};
}

/// Objects that do not exist or are not visible are ignored.
void Play::goToObject(double guid) {
    const engine::PlacedObjects* placed = session_.source().placed.get();
    if (placed == nullptr || !(guid >= 0.0 && guid <= std::numeric_limits<std::uint32_t>::max()))
        return;
    const Result<std::optional<world::Place>> view = placed->viewOf(static_cast<std::uint32_t>(guid));
    if (view && *view)
        going_ = {engine::requestAt(**view), engine::nameWithoutGuid((*view)->name)};
}

/// The heading stays. Points beyond the map are ignored.
void Play::goTo(const Vec2& point) {
    constexpr double kEnd = world::kMapSize * world::kBlockSize;
    if (!(point.x >= 0.0 && point.y >= 0.0 && point.x < kEnd && point.y < kEnd))
        return;
    engine::ViewRequest view;
    view.eye = Vec3(point, request_.camera.eye.z); // the height applies where there is no ground
    view.isOnGround = true;
    view.yaw = request_.camera.heading.yaw;
    going_ = {std::move(view), engine::mapText(point)};
}

/// Goes to the destination once its part is shown. Until then the eye moves in the old part.
Result<void> Play::travel() {
    const engine::Passage passage = isWithin(session_.part(), going_->view)
                                        ? engine::Passage::Open
                                        : residency_.open(engine::centreOf(going_->view));
    if (passage == engine::Passage::Refused)
        going_.reset();
    if (passage != engine::Passage::Open)
        return {};
    standAt(std::exchange(going_, std::nullopt)->view);
    return walk_.isOn() ? walk_.step(session_, {}, request_) : Result<void>{};
}

void Play::standAt(engine::ViewRequest view) {
    const world::World& world = session_.part().world;
    view.size = request_.size;
    view.fov = request_.camera.fovDegrees;
    Result<engine::FrameRequest> request = engine::frameRequest(world, session_.source().file, view);
    if (!request) { // no ground, or a damaged cell; the old part is unloaded, so take the bare position
        view.isOnGround = false;
        view.root.reset();
        request = engine::frameRequest(world, session_.source().file, view);
    }
    if (!request)
        return;
    refusal_.reset();
    request->scene.time = request_.scene.time;
    request->scene.dayGroup = request_.scene.dayGroup;
    request->scene.weather = request_.scene.weather;
    request->scene.look = request_.scene.look;
    request->scene.seconds = request_.scene.seconds;
    request->scene.doors = request_.scene.doors;
    doors_.write(world, request->scene.eachDoor);
    request_ = std::move(*request);
    tracker_.place(request_.root);
    if (walk_.isOn())
        beginToWalk();
}

Result<void> Play::moveEye(const PlayInput& input) {
    FlyInput hands;
    hands.turnRight = input.turnRight;
    hands.turnUp = input.turnUp;
    if (walk_.isOn()) {
        request_.camera = fly(request_.camera, hands);
        if (Result<void> stepped = walk_.step(
                session_, {input.forward, input.right, input.fast, input.jump, input.seconds}, request_);
            !stepped)
            return stepped;
    } else {
        hands.forward = input.forward;
        hands.right = input.right;
        hands.up = input.up;
        hands.fast = input.fast;
        hands.seconds = input.seconds;
        const Vec3 from = request_.camera.eye;
        request_.camera = fly(request_.camera, hands);
        request_.scene.player = request_.camera.eye;
        request_.root = tracker_.move(session_.part().world, from, request_.camera.eye, input.seconds);
    }
    if (going_)
        return travel();
    return followEye();
}

/// Shows an offered part once its solids around the body have been read. Otherwise the next step would wait
/// for them.
Result<void> Play::followEye() {
    const Vec3 eye = request_.camera.eye;
    const dat::RecordId cell = engine::cellOf(session_.part().world, request_.root);
    const std::shared_ptr<const engine::LoadedPart> offered = residency_.follow(eye, request_.root);
    if (offered == nullptr || (walk_.isOn() && residency_.isPatient() && !walk_.prepare(session_, offered)) ||
        !residency_.show())
        return {};
    refusal_.reset();
    request_.root = engine::rootIn(session_.part(), cell, eye);
    tracker_.place(request_.root);
    doors_.write(session_.part().world, request_.scene.eachDoor);
    // A step of no time, because the index of the body's space has changed.
    return walk_.isOn() ? walk_.step(session_, {}, request_) : Result<void>{};
}

void Play::moveDoors(double seconds) {
    const bool areAllAlike = request_.scene.doors.has_value(); // the shared openness hides the doors' own
    walk_.isOn() && !areAllAlike ? walk_.passDoors(doors_, seconds) : doors_.pass(seconds);
    doors_.write(session_.part().world, request_.scene.eachDoor);
    if (!doorsTowards_ || !request_.scene.doors)
        return;
    const double way = *doorsTowards_ - *request_.scene.doors;
    swingAllTo(*request_.scene.doors + std::clamp(way, -seconds, seconds));
    if (*request_.scene.doors == *doorsTowards_)
        doorsTowards_.reset();
}

/// The body blocks leaves that swing against it.
void Play::swingAllTo(double open) {
    request_.scene.doors = walk_.isOn() ? walk_.swingAllDoors(*request_.scene.doors, open) : open;
}

void Play::findDoor() {
    door_.reset();
    if (!walk_.isOn())
        return;
    const world::World& world = session_.part().world;
    const motion::BodyEye head = walk_.head(world);
    door_ = motion::doorInReach(world, head.space, head.position,
                                engine::basisOf(request_.camera.heading).forward);
}

} // namespace limen::play
