#include "motion/DynamicInstances.h"

#include "core/Assert.h"
#include "motion/Billboards.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limen::motion {

using world::kNone;

DynamicInstances::DynamicInstances(const world::World& world) : world_(world), membership_(world) {}

void DynamicInstances::begin(const Vec3& eye, const world::LevelShare& levels, BetweenFrames between,
                             world::DynamicState& out) {
    between_ = between;
    LIMEN_ASSERT(out.closed.empty() || out.closed.size() == world_.portals.size(),
                 "portals are shut by portal, or none is");
    out.instances.clear();
    out.members.clear();
    eye_ = eye;
    levels_ = levels;
    out_ = &out;
    spriteIds_ = 0;
}

std::uint32_t DynamicInstances::blockFor(const Vec3& position) const {
    std::uint32_t best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t b = 0; b < world_.blocks.size(); ++b) {
        const Vec3 offset = position - world_.blocks[b].origin() - Vec3(world::kBlockSize / 2);
        const double distance = std::max(std::abs(offset.x), std::abs(offset.y));
        if (distance < nearest) {
            nearest = distance;
            best = b;
        }
    }
    return best;
}

std::size_t DynamicInstances::addBody(const world::MovingBody& body, const BodyPose& pose,
                                      const CyclePoint& point, world::SpaceIndex placedIn) {
    LIMEN_ASSERT(std::size_t{body.firstPart} + body.partCount <= world_.movingParts.size(),
                 "a body's parts are moving parts of the world");
    LIMEN_ASSERT(placedIn < world_.spaces.size(), "a body is placed in a space of the world");
    const std::size_t first = count();
    const PartPoses poses(world_, body, point, between_);
    const ObjectView view(eye_, pose.origin, placedIn == world::kOutside, levels_);
    for (std::uint32_t p = 0; p < body.partCount; ++p) {
        world::Instance part = world_.movingParts[body.firstPart + p];
        if (part.level != kNone && !view.isIn(world_.levels[part.level].range))
            continue;
        part.level = kNone;
        const PartPose within = poses.of(p);
        const Mat3 linear = pose.linear * within.linear;
        const Vec3 origin = pose.origin + pose.linear * within.origin;
        part.block = blockFor(origin);
        part.linear = glm::mat3(linear);
        part.origin = Vec3f(origin - world_.blocks[part.block].origin());
        part.bounds.centre = origin + linear * part.bounds.centre;
        part.bounds.radius *=
            std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
        part.placedIn = placedIn;
        turnToEye(view, world_, part);
        out_->instances.push_back(part);
    }
    return first;
}

std::size_t DynamicInstances::addInPlace(const world::MovingBody& body) {
    LIMEN_ASSERT(std::size_t{body.firstPart} + body.partCount <= world_.movingParts.size(),
                 "a body's parts are moving parts of the world");
    const std::size_t first = count();
    for (std::uint32_t p = body.firstPart; p < body.firstPart + body.partCount; ++p) {
        world::Instance part = world_.movingParts[p];
        part.bounds.centre += world_.blocks[part.block].origin();
        out_->instances.push_back(part);
    }
    return first;
}

std::size_t DynamicInstances::addCopies(std::span<const world::Instance> instances,
                                        const Vec3& objectOrigin) {
    const std::size_t first = count();
    const world::RangeSteps eye = world::rangeStepsOf(eye_);
    for (const world::Instance& instance : instances) {
        if (!world::isInLevelRange(world_, instance, eye, levels_))
            continue;
        world::Instance copy = instance;
        copy.level = kNone;
        if (copy.facing != world::Facing::Fixed)
            turnToEye({eye_, objectOrigin, copy.placedIn == world::kOutside, levels_}, world_, copy);
        out_->instances.push_back(copy);
    }
    return first;
}

std::uint32_t DynamicInstances::takeSpriteIds(std::uint32_t count) {
    LIMEN_ASSERT(hasSpriteIds(count), "ids are taken while there are some left");
    const std::uint32_t first = world_.spriteIds + spriteIds_;
    spriteIds_ += count;
    return first;
}

DynamicInstances::Spaces DynamicInstances::only(world::SpaceIndex space) {
    spaces_.assign(1, space);
    return spaces_;
}

DynamicInstances::Spaces DynamicInstances::reachedFrom(world::SpaceIndex space, const Sphere& sphere) {
    LIMEN_ASSERT(space < world_.spaces.size(), "membership begins in a space of the world");
    membership_.reach(space, sphere, out_->closed, spaces_);
    return spaces_;
}

void DynamicInstances::fillSidesOf(const world::Portal& portal) {
    spaces_.assign(1, portal.space);
    if (portal.destination != kNone && portal.destination != portal.space)
        spaces_.push_back(portal.destination);
}

DynamicInstances::Spaces DynamicInstances::sidesOf(const world::Portal& portal) {
    fillSidesOf(portal);
    return spaces_;
}

DynamicInstances::Spaces DynamicInstances::reachedFromSidesOf(const world::Portal& portal,
                                                              const Sphere& sphere) {
    fillSidesOf(portal);
    membership_.extend(sphere, out_->closed, spaces_);
    return spaces_;
}

void DynamicInstances::setSpaces(std::size_t first, Spaces spaces) {
    LIMEN_ASSERT(!spaces.empty(), "an instance belongs to the space that it is placed in");
    LIMEN_ASSERT(first <= count(), "spaces are set for instances that were appended");
    const auto firstMember = static_cast<std::uint32_t>(out_->members.size());
    out_->members.insert(out_->members.end(), spaces.begin(), spaces.end());
    for (std::size_t i = first; i < count(); ++i) {
        out_->instances[i].placedIn = spaces.front();
        out_->instances[i].setMembers(firstMember, spaces.size());
    }
}

} // namespace limen::motion
