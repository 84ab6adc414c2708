#include "motion/PartPoses.h"

#include "core/Assert.h"
#include "geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

using world::Cycle;
using world::Gait;
using world::kNone;
using world::MovingBody;
using world::Stretch;
using world::World;

/// Metres a second: a slower cycle counts as one without velocity.
constexpr double kLeastVelocity = 0.01;

/// A part that moves farther, or turns more, from one frame to the next does not pass through the poses between
/// them. No part of a retail animation moves so far.
constexpr double kFarthestMove = 4.0, kGreatestTurn = 120.0 * kDegree;

bool isAJump(const world::PartFrame& from, const world::PartFrame& to) {
    const double half = std::min(std::abs(glm::dot(from.orientation, to.orientation)), 1.0);
    return glm::length(to.origin - from.origin) > kFarthestMove || 2.0 * std::acos(half) > kGreatestTurn;
}

std::uint32_t cycleOf(const MovingBody& body, Gait gait) {
    return body.cycles[static_cast<std::size_t>(gait)];
}

/// A cycle's speed in metres a second; 0: the cycle has no velocity.
double velocityOf(const World& world, std::uint32_t cycle) {
    const double velocity = cycle != kNone ? glm::length(world.cycles[cycle].velocity) : 0.0;
    return velocity >= kLeastVelocity && std::isfinite(velocity) ? velocity : 0.0;
}

/// The step within an endless stretch: 0 <= steps < frameCount.
double stepsAround(const Stretch& stretch, double steps) {
    const double count = stretch.frameCount;
    double around = std::fmod(steps, count);
    if (around < 0.0)
        around += count;
    return around >= 0.0 && around < count ? around
                                           : 0.0; // 0 after rounding up to a whole round, and for NaN
}

/// The current stretch of a cycle, and the steps since its first frame.
struct Played {
    std::uint32_t stretch = 0;
    double steps = 0.0;
};
Played playedAt(const World& world, const Cycle& cycle, double seconds) {
    LIMEN_ASSERT(cycle.stretchCount > 0, "a cycle has a stretch");
    const std::uint32_t last = cycle.stretchCount - 1;
    const auto stretches = std::span(world.stretches).subspan(cycle.firstStretch, cycle.stretchCount);
    // At negative times the cycle plays its last stretch, as it does after the others.
    for (std::uint32_t i = 0; i < last && seconds >= 0.0; ++i) {
        const double rate = std::abs(stretches[i].rate);
        if (seconds * rate < stretches[i].frameCount)
            return {i, seconds * rate};
        seconds = std::max(seconds - stretches[i].frameCount / rate, 0.0);
    }
    return {last, stepsAround(stretches[last], seconds * std::abs(stretches[last].rate))};
}

} // namespace

Gait gaitAt(const World& world, const MovingBody& body, double speed) {
    if (speed == 0.0)
        return Gait::Stand;
    const double walk = velocityOf(world, cycleOf(body, Gait::Walk));
    const double run = velocityOf(world, cycleOf(body, Gait::Run));
    return walk > 0.0 && run > walk && std::abs(speed) > (walk + run) / 2.0 ? Gait::Run : Gait::Walk;
}

CyclePoint cyclePoint(const World& world, const MovingBody& body, Gait gait, double metres, double seconds) {
    if (gait != Gait::Stand) {
        std::uint32_t cycle = cycleOf(body, gait);
        if (cycle == kNone)
            cycle = cycleOf(body, gait == Gait::Walk ? Gait::Run : Gait::Walk);
        if (cycle != kNone) {
            const double velocity = velocityOf(world, cycle);
            return {cycle, velocity > 0.0 ? metres / velocity : seconds};
        }
    }
    return {cycleOf(body, Gait::Stand), seconds};
}

PartPoses::PartPoses(const World& world, const MovingBody& body, const CyclePoint& at, BetweenFrames between)
    : world_(world), body_(body) {
    if (at.cycle == kNone || body.firstPosed == kNone)
        return;
    LIMEN_ASSERT(at.cycle < world.cycles.size(), "a body plays a cycle of the world");
    const Cycle& cycle = world.cycles[at.cycle];
    const Played played = playedAt(world, cycle, at.seconds);
    stretch_ = &world.stretches[cycle.firstStretch + played.stretch];
    step_ = static_cast<std::uint32_t>(played.steps);
    between_ = between == BetweenFrames::Interpolated ? played.steps - step_ : 0.0;
    const world::NextFrame next = world::nextFrame(cycle, *stretch_, played.stretch, step_);
    then_ = &world.stretches[cycle.firstStretch + next.stretch];
    thenStep_ = next.step;
}

const world::PartFrame* PartPoses::frame(const Stretch& stretch, std::uint32_t step,
                                         std::uint32_t part) const {
    if (part >= stretch.partCount)
        return nullptr;
    return &world_.partFrames[stretch.firstPartFrame + world::frameAt(stretch, step) * stretch.partCount +
                              part];
}

std::optional<world::PartFrame> PartPoses::frameOf(std::uint32_t part) const {
    const world::PartFrame* from = stretch_ != nullptr ? frame(*stretch_, step_, part) : nullptr;
    if (from == nullptr)
        return std::nullopt;
    world::PartFrame at = *from;
    const world::PartFrame* to = frame(*then_, thenStep_, part);
    if (to != nullptr && to != from && between_ > 0.0 && !isAJump(*from, *to)) {
        at.orientation = glm::slerp(at.orientation, to->orientation, between_); // the shorter way
        at.origin += (to->origin - at.origin) * between_;
    }
    return at;
}

PartPose PartPoses::of(std::uint32_t index) const {
    LIMEN_ASSERT(index < body_.partCount, "the part is one of the body");
    const world::Instance& resting = world_.movingParts[body_.firstPart + index];
    PartPose rest{Mat3(resting.linear), Vec3(resting.origin)};
    if (stretch_ == nullptr)
        return rest;
    const world::PosedPart& posed = world_.posedParts[body_.firstPosed + index];
    const std::optional<world::PartFrame> at = frameOf(posed.part);
    if (!at)
        return rest;
    const world::PartFrame placed = world::posedAt(*at, posed);
    PartPose pose{glm::mat3_cast(placed.orientation), placed.origin};
    for (int axis = 0; axis < 3; ++axis)
        pose.linear[axis] *= posed.scale[axis];
    return pose;
}

} // namespace limen::motion
