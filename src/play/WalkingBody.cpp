#include "play/WalkingBody.h"

#include "motion/Locate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limen::play {
namespace {

constexpr int kRadius = 1;     // landblocks of solids on each side of the body's landblock
constexpr double kHeld = 0.01; // metres short of the wanted distance: the third-person eye is blocked

/// The body fades as the eye comes near its head and is invisible before the eye is inside.
double opacityAt(double metres) {
    constexpr double kGone = 0.6, kSolid = 1.2;
    return std::clamp((metres - kGone) / (kSolid - kGone), 0.0, 1.0);
}

} // namespace

WalkingBody::Reading WalkingBody::read(const std::shared_ptr<const engine::WorldSource>& source,
                                       std::shared_ptr<const engine::LoadedPart> loaded,
                                       dat::BlockCoord centre) {
    Result<world::Solids> solids = world::loadSolids(source->archive, loaded->world, centre, kRadius);
    if (!solids)
        return Failure(solids.error());
    motion::Collisions collisions(loaded->world, std::move(*solids));
    return std::make_shared<const Surroundings>(Surroundings{std::move(loaded), std::move(collisions)});
}

Result<void> WalkingBody::begin(const engine::Session& session, const engine::FrameRequest& request) {
    const world::World& world = session.part().world;
    const Vec3 feet = request.camera.eye - Vec3(0.0, 0.0, shape_.eyeHeight);
    const Vec3 middle = shape_.capsule.middle(feet);
    body_ = motion::bodyAt({feet, motion::sweep(world, request.root, request.camera.eye, middle)});
    // The first step settles the feet on ground within stepDown; a fall would end at a height that depends on
    // the frame times.
    body_.isOnGround = true;
    lag_ = 0.0;
    yaw_ = request.camera.heading.yaw;
    speed_ = metres_ = 0.0;
    chase_ = {};
    drop(); // pending reads are for another position
    Reading around = read(session.shareSource(), session.sharePart(), blockOfBody(session.part()));
    if (!around)
        return Failure(around.error());
    around_ = std::move(*around);
    isOn_ = true;
    return {};
}

void WalkingBody::end(engine::FrameRequest& request) {
    drop();
    request.scene.body.reset();
    request.isHeld = false;
}

void WalkingBody::drop() {
    isOn_ = false;
    coming_ = {};
    next_ = {};
    background_.discard(std::move(around_));
    around_.reset();
}

dat::BlockCoord WalkingBody::blockOfBody(const engine::LoadedPart& loaded) const {
    const motion::Standing& here = body_.standing;
    return here.space == world::kOutside ? world::blockAt(here.feet)
                                         : dat::blockOf(loaded.world.spaces[here.space].cellId);
}

void WalkingBody::follow(const engine::LoadedPart& before, const engine::LoadedPart& now) {
    for (motion::Standing* standing : {&body_.standing, &body_.safe}) {
        if (standing->space == world::kOutside)
            continue;
        standing->space = world::findCell(now.world, before.world.spaces[standing->space].cellId);
        if (standing->space == world::kNone) // its block is damaged or absent: locate it by position
            standing->space = motion::locate(now.world, shape_.capsule.middle(standing->feet)).space;
    }
}

WalkingBody::Coming WalkingBody::beginToRead(const engine::Session& session,
                                             std::shared_ptr<const engine::LoadedPart> loaded,
                                             dat::BlockCoord centre) {
    Coming coming{loaded, centre, {}};
    coming.reading = background_.run([source = session.shareSource(), loaded = std::move(loaded), centre] {
        return read(source, loaded, centre);
    });
    return coming;
}

Result<void> WalkingBody::takeSurroundings(const engine::Session& session, dat::BlockCoord centre) {
    Coming& coming = next_.isOf(session.sharePart(), centre) ? next_ : coming_;
    Reading around = coming.isOf(session.sharePart(), centre)
                         ? coming.reading.get()
                         : read(session.shareSource(), session.sharePart(), centre);
    coming_ = {};
    next_ = {};
    if (!around)
        return Failure(around.error());
    background_.discard(std::exchange(around_, std::move(*around)));
    return {};
}

bool WalkingBody::prepare(const engine::Session& session,
                          const std::shared_ptr<const engine::LoadedPart>& next) {
    const dat::BlockCoord here = blockOfBody(session.part());
    if (!next_.isOf(next, here))
        next_ = beginToRead(session, next, here);
    return engine::Background::isReady(next_.reading);
}

Result<void> WalkingBody::keepSurroundings(const engine::Session& session) {
    const bool isOfAnother = around_->loaded != session.sharePart();
    if (isOfAnother) {
        follow(*around_->loaded, session.part());
        coming_ = {};
    }
    const dat::BlockCoord here = blockOfBody(session.part());
    if (isOfAnother)
        return takeSurroundings(session, here);
    if (around_->collisions.centre() == here)
        return {};
    if (!coming_.isOf(session.sharePart(), here))
        coming_ = beginToRead(session, session.sharePart(), here);
    // Within this distance the old solids still cover the surroundings. Swapping when the read finishes would
    // make a walk depend on the speed of the disk.
    constexpr double kTaken = 24.0; // metres
    return world::metresBeside(around_->collisions.centre(), body_.standing.feet) > kTaken
               ? takeSurroundings(session, here)
               : Result<void>{};
}

void WalkingBody::chase(bool isChased) {
    isChased_ = isChased;
    chase_ = {}; // the camera starts in the head
}

void WalkingBody::keepDistance(double metres) {
    chaseShape_.distance = std::clamp(metres, kNearest, kFarthest);
}

motion::BodyEye WalkingBody::head(const world::World& world) const {
    motion::BodyShape smooth = shape_;
    smooth.eyeHeight += lag_;
    return motion::eyeOf(body_, world, smooth);
}

void WalkingBody::smooth(double fellOrRose, double seconds) {
    constexpr double kQuick = 10.0;   // decay rate of the lag, 1/s
    constexpr double kLeast = 0.0005; // metres: a smaller lag is set to zero
    constexpr double kMost = 0.6;     // metres
    lag_ = std::clamp((lag_ - fellOrRose) * std::exp(-kQuick * seconds), -kMost, kMost);
    if (std::abs(lag_) < kLeast)
        lag_ = 0.0;
}

/// First person: the body faces the view direction. Third person: it turns towards its direction of movement.
void WalkingBody::face(const WalkInput& input, double seconds, double yaw) {
    constexpr double kBodyTurn = 540.0; // degrees a second
    if (!isChased_) {
        yaw_ = yaw;
        return;
    }
    if (input.forward == 0.0 && input.right == 0.0)
        return;
    const double towards = yaw + glm::degrees(std::atan2(input.right, input.forward));
    const double turn = std::remainder(towards - yaw_, 360.0);
    yaw_ = std::remainder(yaw_ + std::clamp(turn, -kBodyTurn * seconds, kBodyTurn * seconds), 360.0);
}

/// Sets the speed and distance of the walk animation: the gait's full speed if the body advances, else 0.
void WalkingBody::stride(const WalkInput& input, const Vec3& from) {
    constexpr double kStill = 1e-4; // metres in a frame: a shorter move counts as standing
    const double way = std::hypot(body_.standing.feet.x - from.x, body_.standing.feet.y - from.y);
    const bool goes = body_.isOnGround && way > kStill && (input.forward != 0.0 || input.right != 0.0);
    speed_ = !goes ? 0.0 : input.run ? shape_.runSpeed : shape_.walkSpeed;
    metres_ += goes ? way : 0.0;
}

void WalkingBody::carryEye(const engine::Session& session, double seconds, engine::FrameRequest& request) {
    const world::World& world = session.part().world;
    motion::BodyEye at = head(world);
    double opacity = 0.0;
    if (isChased_) {
        chase_ = motion::chased(chase_, body_, engine::basisOf(request.camera.heading).forward, seconds,
                                around_->collisions, doors_, lag_, shape_, chaseShape_);
        opacity = opacityAt(glm::length(chase_.eye.position - at.position));
        at = chase_.eye;
    }
    request.camera.eye = at.position;
    request.root = at.space;
    request.isRootAmbiguous = false;
    request.isHeld = isChased_ && chase_.arm < chaseShape_.distance - kHeld;
    request.scene.player = shape_.capsule.middle(body_.standing.feet);
    request.scene.body =
        motion::PlayerBody{body_.standing.feet, yaw_, body_.standing.space, opacity, speed_, metres_};
}

void WalkingBody::readDoors(const world::World& world, const engine::FrameRequest& request) {
    doors_.clear();
    for (std::size_t i = 0; i < world.doors.size(); ++i) {
        const double open =
            i < request.scene.eachDoor.size() ? request.scene.eachDoor[i] : world.doors[i].open;
        doors_.push_back(request.scene.doors.value_or(open));
    }
}

void WalkingBody::passDoors(motion::DoorUse& doors, double seconds) {
    doors.pass(seconds, around_->collisions, body_, shape_);
}

double WalkingBody::swingAllDoors(double from, double to) {
    return motion::swingAll(from, to, body_, around_->collisions, doors_, shape_);
}

motion::Detour WalkingBody::wayAround(const Vec3& feet, double square) const {
    return motion::wayAround(body_, feet, square, around_->collisions, doors_, shape_);
}

Result<void> WalkingBody::step(const engine::Session& session, const WalkInput& input,
                               engine::FrameRequest& request) {
    if (Result<void> kept = keepSurroundings(session); !kept)
        return kept;
    readDoors(session.part().world, request);
    motion::BodyInput bodyInput;
    bodyInput.forward = input.forward;
    bodyInput.right = input.right;
    bodyInput.yaw = request.camera.heading.yaw;
    bodyInput.run = input.run;
    bodyInput.jump = input.jump;
    constexpr double kLongest = 0.25; // seconds: a stall causes no jump, and a slow machine still advances
    const double seconds = std::clamp(input.seconds, 0.0, kLongest);
    const motion::BodyState before = body_;
    body_ = motion::moved(body_, bodyInput, seconds, around_->collisions, doors_, shape_);
    const bool isOnFoot = before.isOnGround && body_.isOnGround;
    smooth(isOnFoot ? body_.standing.feet.z - before.standing.feet.z : 0.0, seconds);
    face(input, seconds, request.camera.heading.yaw);
    if (seconds > 0.0) // a step of no time only updates the index of the space
        stride(input, before.standing.feet);
    carryEye(session, seconds, request);
    return {};
}

} // namespace limen::play
