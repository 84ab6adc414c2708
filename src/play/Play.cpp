#include "play/Play.h"

#include "play/FlyCamera.h"

#include <algorithm>
#include <cstdlib>

namespace limen::play {
namespace {

/// Whether a place lies so far within what is shown that one may stand there while the rest of its surroundings comes.
bool isWithin(const engine::LoadedWorld& shown, const engine::Viewpoint& stand) {
    const int away =
        std::max(std::abs(stand.centre.x - shown.centre.x), std::abs(stand.centre.y - shown.centre.y));
    const world::Block* block = world::findBlock(shown.world, stand.centre);
    return block != nullptr && !block->isFar && away <= shown.target.options.radius / 2 &&
           (stand.root.kind != cli::RootChoice::Kind::Cell ||
            world::findCell(shown.world, stand.root.cell) != world::kNone);
}

} // namespace

Play::Play(engine::Session& session, engine::FrameEye start, engine::Residency* residency)
    : session_(session), residency_(residency != nullptr ? *residency : session), eye_(std::move(start)),
      tracker_(eye_.root) {
    const std::vector<world::Door>& doors = session_.loaded().world.doors;
    for (std::size_t i = 0; i < std::min(doors.size(), eye_.eachDoor.size()); ++i)
        if (eye_.eachDoor[i] != doors[i].open)
            doors_.put(doors[i], eye_.eachDoor[i]);
}

Result<void> Play::step(const PlayInput& input) {
    for (const PlayAct& act : input.acts)
        this->act(act);
    const double seconds = input.isFrozen ? 0.0 : input.seconds;
    moveDoors(seconds); // first: who is pushed is seen where that is
    if (Result<void> moved = moveEye(input); !moved)
        return moved;
    findDoor();
    eye_.seconds += seconds;
    eye_.size = input.size;
    return {};
}

void Play::act(const PlayAct& act) {
    switch (act.kind) {
    case PlayAct::Kind::Walk:
        walk_.isOn() ? walk_.end(eye_) : beginToWalk();
        tracker_.place(eye_.root);
        return;
    case PlayAct::Kind::Chase:
        walk_.chase(!walk_.isChased());
        return;
    case PlayAct::Kind::Doors:
        swingDoors();
        return;
    case PlayAct::Kind::Use:
        useDoor();
        return;
    case PlayAct::Kind::Weather:
        eye_.weather = eye_.weather == Weather::Rain ? Weather::Clear : Weather::Rain;
        return;
    case PlayAct::Kind::Day:
        if (act.value >= 0.0 &&
            act.value < static_cast<double>(session_.loaded().world.sky.desc.dayGroups.size()))
            eye_.dayGroup = static_cast<std::uint32_t>(act.value);
        return;
    case PlayAct::Kind::Place:
        goTo(static_cast<std::size_t>(std::max(act.value, 0.0)));
        return;
    case PlayAct::Kind::Time:
        eye_.time = std::clamp(act.value, 0.0, 1.0);
        return;
    case PlayAct::Kind::AllDoors:
        standDoors(act.value);
        return;
    case PlayAct::Kind::Distance:
        walk_.keepDistance(act.value);
        return;
    case PlayAct::Kind::Quality:
        if (act.value >= 0.0 && act.value < static_cast<double>(engine::kQualities.size()))
            session_.drawBy(static_cast<std::size_t>(act.value));
        return;
    }
}

/// Stands where the eye is, and falls to the ground. What cannot be walked on is flown over.
void Play::beginToWalk() {
    if (!walk_.begin(session_, eye_))
        walk_.end(eye_);
}

/// All doors open, or shut if they are open or opening. They take a second.
void Play::swingDoors() {
    const double towards = doorsTowards_.value_or(eye_.doors.value_or(0.0));
    doorsTowards_ = towards < 0.5 ? 1.0 : 0.0;
    if (!eye_.doors)
        eye_.doors = 1.0 - *doorsTowards_;
}

void Play::standDoors(double open) {
    doorsTowards_.reset(); // a hand is on them
    if (open >= 0.0 && eye_.doors)
        swingAllTo(std::min(open, 1.0));
    else
        eye_.doors = open < 0.0 ? std::nullopt : std::make_optional(std::min(open, 1.0));
}

/// From here on doors stand each as it was left.
void Play::useDoor() {
    if (!door_)
        return;
    const world::World& world = session_.loaded().world;
    if (eye_.doors)
        doors_.putAll(world, *eye_.doors);
    eye_.doors.reset();
    doorsTowards_.reset();
    doors_.use(world.doors[*door_]);
}

void Play::goTo(std::size_t place) {
    const std::vector<world::Place>& places = session_.source().file.places;
    if (place < places.size())
        going_ = {engine::viewpointAt(places[place]), places[place].name};
}

/// Until it is there the eye goes on where it is.
Result<void> Play::goOn() {
    const engine::Passage passage =
        isWithin(session_.loaded(), going_->stand) ? engine::Passage::Open : residency_.open(going_->stand.centre);
    if (passage == engine::Passage::Refused)
        going_.reset();
    if (passage != engine::Passage::Open)
        return {};
    standAt(std::exchange(going_, std::nullopt)->stand);
    return walk_.isOn() ? walk_.step(session_, {}, eye_) : Result<void>{};
}

void Play::standAt(engine::Viewpoint stand) {
    Result<engine::FrameEye> eye = engine::placeEye(session_.loaded(), stand, eye_.size);
    if (!eye) { // it has no ground, or its cell is damaged; what was shown before has gone
        stand.onGround = false;
        stand.root = {};
        eye = engine::placeEye(session_.loaded(), stand, eye_.size);
    }
    if (!eye)
        return;
    eye->camera.fovDegrees = eye_.camera.fovDegrees;
    eye->time = eye_.time;
    eye->dayGroup = eye_.dayGroup;
    eye->weather = eye_.weather;
    eye->seconds = eye_.seconds;
    eye->doors = eye_.doors;
    doors_.write(session_.loaded().world, eye->eachDoor);
    eye_ = std::move(*eye);
    tracker_.place(eye_.root);
    if (walk_.isOn())
        beginToWalk();
}

Result<void> Play::moveEye(const PlayInput& input) {
    FlyInput hands;
    hands.turnRight = input.turnRight;
    hands.turnUp = input.turnUp;
    if (walk_.isOn()) {
        eye_.camera = fly(eye_.camera, hands);
        if (Result<void> stepped = walk_.step(
                session_, {input.forward, input.right, input.fast, input.jump, input.seconds}, eye_);
            !stepped)
            return stepped;
    } else {
        hands.forward = input.forward;
        hands.right = input.right;
        hands.up = input.up;
        hands.fast = input.fast;
        hands.seconds = input.seconds;
        const Vec3 from = eye_.camera.eye;
        eye_.camera = fly(eye_.camera, hands);
        eye_.player = eye_.camera.eye;
        eye_.root = tracker_.move(session_.loaded().world, from, eye_.camera.eye, input.seconds);
    }
    if (going_)
        return goOn();
    if (!residency_.follow(eye_.camera.eye, eye_.root, walk_.isOn() ? &walk_ : nullptr))
        return {};
    tracker_.place(eye_.root);
    doors_.write(session_.loaded().world, eye_.eachDoor);
    return walk_.isOn() ? walk_.step(session_, {}, eye_) : Result<void>{}; // its space has another number now
}

void Play::moveDoors(double seconds) {
    const bool areAllAlike = eye_.doors.has_value(); // nobody sees how each would stand
    walk_.isOn() && !areAllAlike ? walk_.passDoors(doors_, seconds) : doors_.pass(seconds);
    doors_.write(session_.loaded().world, eye_.eachDoor);
    if (!doorsTowards_ || !eye_.doors)
        return;
    const double way = *doorsTowards_ - *eye_.doors;
    swingAllTo(*eye_.doors + std::clamp(way, -seconds, seconds));
    if (*eye_.doors == *doorsTowards_)
        doorsTowards_.reset();
}

/// As far as a body lets them.
void Play::swingAllTo(double open) {
    eye_.doors = walk_.isOn() ? walk_.swingAllDoors(*eye_.doors, open) : open;
}

void Play::findDoor() {
    door_.reset();
    if (!walk_.isOn())
        return;
    const world::World& world = session_.loaded().world;
    const motion::BodyEye head = walk_.head(world);
    door_ = motion::doorInReach(world, head.space, head.position, engine::basisOf(eye_.camera.heading).forward);
}

} // namespace limen::play
