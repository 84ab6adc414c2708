#include "app/Walk.h"

#include "motion/Locate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace limen::app {
namespace {

constexpr int kRadius = 1; // landblocks around the body's whose solids are known

} // namespace

Walk::Reading Walk::read(const std::shared_ptr<const WorldSource>& source,
                         std::shared_ptr<const LoadedWorld> loaded, dat::BlockCoord centre) {
    Result<world::Solids> solids = world::loadSolids(source->archive, loaded->world, centre, kRadius);
    if (!solids)
        return tl::unexpected(solids.error());
    motion::Collisions collisions(loaded->world, std::move(*solids));
    return std::make_shared<const Surroundings>(Surroundings{std::move(loaded), std::move(collisions)});
}

Result<void> Walk::begin(const Session& session, const FrameEye& eye) {
    const world::World& world = session.loaded().world;
    const Vec3 feet = eye.camera.eye - Vec3(0.0, 0.0, shape_.eyeHeight);
    const Vec3 middle = shape_.capsule.middle(feet);
    body_ = motion::bodyAt({feet, motion::sweep(world, eye.root, eye.camera.eye, middle)});
    lag_ = 0.0;
    end(); // what was coming is of elsewhere
    Reading around = read(session.shareSource(), session.shareLoaded(), blockOfBody(session.loaded()));
    if (!around)
        return tl::unexpected(around.error());
    around_ = std::move(*around);
    isOn_ = true;
    return {};
}

void Walk::end() {
    isOn_ = false;
    coming_ = {}; // waits for its thread
    around_.reset();
}

dat::BlockCoord Walk::blockOfBody(const LoadedWorld& loaded) const {
    const motion::Standing& here = body_.standing;
    return here.space == world::kOutside ? world::blockAt(here.feet)
                                         : dat::blockOf(loaded.world.spaces[here.space].cellId);
}

void Walk::follow(const LoadedWorld& before, const LoadedWorld& now) {
    for (motion::Standing* standing : {&body_.standing, &body_.safe}) {
        if (standing->space == world::kOutside)
            continue;
        standing->space = world::findCell(now.world, before.world.spaces[standing->space].cellId);
        if (standing->space == world::kNone) // its block is damaged or was left out: look again
            standing->space = motion::locate(now.world, shape_.capsule.middle(standing->feet)).space;
    }
}

Result<void> Walk::keepSurroundings(const Session& session) {
    if (around_->loaded != session.shareLoaded()) {
        follow(*around_->loaded, session.loaded());
        coming_ = {};
        Reading around = read(session.shareSource(), session.shareLoaded(), blockOfBody(session.loaded()));
        if (!around)
            return tl::unexpected(around.error());
        around_ = std::move(*around);
        return {};
    }
    if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        if (Reading arrived = coming_.get())
            around_ = std::move(*arrived);
    }
    const dat::BlockCoord here = blockOfBody(session.loaded());
    const bool isComing = coming_.valid() && comingCentre_ == here;
    if (!isComing && !(around_->collisions.centre() == here)) {
        comingCentre_ = here;
        coming_ = std::async(std::launch::async, read, session.shareSource(), session.shareLoaded(), here);
    }
    return {};
}

void Walk::carryEye(const LoadedWorld& loaded, double fellOrRose, double seconds, FrameEye& eye) {
    constexpr double kQuick = 10.0;   // a second: how fast the eye comes after
    constexpr double kLeast = 0.0005; // metres, and it is there
    constexpr double kMost = 0.6;
    lag_ = std::clamp((lag_ - fellOrRose) * std::exp(-kQuick * seconds), -kMost, kMost);
    if (std::abs(lag_) < kLeast)
        lag_ = 0.0;
    motion::BodyShape smooth = shape_;
    smooth.eyeHeight += lag_;
    const motion::BodyEye at = motion::eyeOf(body_, loaded.world, smooth);
    eye.camera.eye = at.position;
    eye.root = at.space;
    eye.rootAmbiguous = false;
    eye.player = shape_.capsule.middle(body_.standing.feet);
}

Result<void> Walk::step(const Session& session, const WalkInput& input, FrameEye& eye) {
    if (Result<void> kept = keepSurroundings(session); !kept)
        return kept;
    motion::BodyInput asked;
    asked.forward = input.forward;
    asked.right = input.right;
    asked.yaw = eye.camera.heading.yaw;
    asked.run = input.run;
    asked.jump = input.jump;
    constexpr double kLongest = 0.25; // after a stall it does not leap; on a slow machine it still gets on
    const double seconds = std::clamp(input.seconds, 0.0, kLongest);
    const motion::BodyState before = body_;
    body_ = motion::moved(body_, asked, seconds, around_->collisions, session.moment().closed, shape_);
    const bool isOnFoot = before.isOnGround && body_.isOnGround;
    carryEye(session.loaded(), isOnFoot ? body_.standing.feet.z - before.standing.feet.z : 0.0, seconds, eye);
    return {};
}

} // namespace limen::app
