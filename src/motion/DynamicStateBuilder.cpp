#include "motion/DynamicStateBuilder.h"

#include "geometry/Compass.h"
#include "motion/Locate.h"
#include "motion/Sprites.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::motion {
namespace {

using world::kNone;

double compass(const Vec3& direction) {
    return std::atan2(direction.x, direction.y) * 180.0 / std::numbers::pi;
}

} // namespace

DynamicStateBuilder::DynamicStateBuilder(const world::World& world) : world_(world), membership_(world) {}

std::uint32_t DynamicStateBuilder::blockFor(const Vec3& position) const {
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

double DynamicStateBuilder::openness(const DynamicStateInput& input, std::size_t door) const {
    if (input.allDoors)
        return *input.allDoors;
    return door < input.doors.size() ? input.doors[door] : world_.doors[door].open;
}

void DynamicStateBuilder::at(const DynamicStateInput& input, world::DynamicState& out) {
    out.instances.clear();
    out.members.clear();
    sprites_ = 0;
    shut(input, out);
    addDoors(input, out);
    addVillagers(input.seconds, out);
    if (input.player)
        addPlayer(*input.player, input.seconds, out);
    addIdle(input.seconds, out);
    addLoose(out);
    for (const world::Emitter& emitter : world_.emitters)
        addSprites(input, emitter, out);
    for (const world::ParticleSource& source : world_.particleSources)
        addParticles(input, source, out);
    if (input.rain && world_.rainDrop != kNone)
        addRain(input, out);
    if (input.weather)
        addWeather(input, out);
    world::listBySpace(world_.spaces.size(), out);
}

void DynamicStateBuilder::shut(const DynamicStateInput& input, world::DynamicState& out) {
    out.closed.assign(world_.doors.empty() ? 0 : world_.portals.size(), 0);
    out.fillings.assign(out.closed.size(), kNone);
    for (std::size_t i = 0; i < world_.doors.size(); ++i) {
        const world::Door& door = world_.doors[i];
        if (!door.opaque || openness(input, i) > 0.0)
            continue;
        out.closed[door.portal] = 1;
        if (door.reciprocal != kNone)
            out.closed[door.reciprocal] = 1;
    }
}

void DynamicStateBuilder::giveMembers(std::size_t firstInstance, world::DynamicState& out) const {
    const auto first = static_cast<std::uint32_t>(out.members.size());
    out.members.insert(out.members.end(), reached_.begin(), reached_.end());
    for (std::size_t i = firstInstance; i < out.instances.size(); ++i) {
        out.instances[i].placedIn = reached_.front();
        out.instances[i].setMembers(first, reached_.size());
    }
}

void DynamicStateBuilder::addBody(const world::MovingBody& body, const Pose& pose, const CyclePoint& point,
                                  world::SpaceIndex placedIn, world::DynamicState& out) {
    const PartPoses poses(world_, body, point);
    for (std::uint32_t p = 0; p < body.partCount; ++p) {
        world::Instance part = world_.movingParts[body.firstPart + p];
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
        out.instances.push_back(part);
    }
}

void DynamicStateBuilder::addInPlace(const world::MovingBody& body, world::DynamicState& out) const {
    for (std::uint32_t p = body.firstPart; p < body.firstPart + body.partCount; ++p) {
        world::Instance part = world_.movingParts[p];
        part.bounds.centre += world_.blocks[part.block].origin();
        out.instances.push_back(part);
    }
}

void DynamicStateBuilder::addDoors(const DynamicStateInput& input, world::DynamicState& out) {
    for (std::size_t i = 0; i < world_.doors.size(); ++i) {
        const world::Door& door = world_.doors[i];
        const world::Portal& portal = world_.portals[door.portal];
        const double open = openness(input, i);
        // A filling belongs to both spaces it lies between, shut or not, and to what its leaves reach from there.
        const auto bothSides = [&] {
            reached_.assign(1, portal.space);
            if (portal.destination != kNone && portal.destination != portal.space)
                reached_.push_back(portal.destination);
        };
        for (std::uint32_t l = door.firstLeaf; l < door.firstLeaf + door.leafCount; ++l) {
            const world::Leaf& leaf = world_.leaves[l];
            const Pose pose{turnedTo(leaf.yaw + leaf.swing * open), leaf.hinge};
            const std::size_t first = out.instances.size();
            if (open == 0.0 && leaf.shut.partCount > 0)
                addInPlace(leaf.shut, out);
            else
                addBody(leaf.body, pose, {}, portal.space, out);
            bothSides();
            membership_.extend({pose.origin + pose.linear * leaf.body.bounds.centre, leaf.body.bounds.radius},
                               out.closed, reached_);
            giveMembers(first, out);
        }
        if (out.closed[door.portal] == 0 || door.filling == kNone)
            continue;
        out.fillings[door.portal] = static_cast<world::InstanceIndex>(out.instances.size());
        if (door.reciprocal != kNone)
            out.fillings[door.reciprocal] = out.fillings[door.portal];
        addInPlace({door.filling, 1, {}}, out);
        bothSides();
        giveMembers(out.instances.size() - 1, out);
    }
}

DynamicStateBuilder::Standing DynamicStateBuilder::standing(const world::Villager& villager,
                                                            double seconds) const {
    const world::Route& route = world_.routes[villager.route];
    const auto points = std::span(world_.routePoints).subspan(route.firstPoint, route.pointCount);
    double along = std::fmod(villager.start + villager.speed * seconds, route.length);
    along += along < 0.0 ? route.length : 0.0;
    const std::size_t count = points.size();
    // There and back again is a loop of the points and, in reverse, all but the two ends.
    const std::size_t legs = route.loop ? count : 2 * count - 2;
    const auto point = [&](std::size_t i) { return i < count ? points[i] : points[2 * count - 2 - i]; };
    for (std::size_t leg = 0;; ++leg) {
        const world::RoutePoint from = point(leg);
        const Vec3 way = point((leg + 1) % legs).position - from.position;
        const double length = glm::length(way);
        if (along <= length || leg + 1 == legs) {
            const Vec3 at = from.position + way * (length > 0.0 ? std::min(along / length, 1.0) : 0.0);
            return {at, compass(way), sweep(world_, from.space, from.position, at)};
        }
        along -= length;
    }
}

void DynamicStateBuilder::addVillagers(double seconds, world::DynamicState& out) {
    for (const world::Villager& villager : world_.villagers) {
        const Standing standing = this->standing(villager, seconds);
        const Pose pose{turnedTo(standing.yaw), standing.position};
        const world::Gait gait = gaitAt(world_, villager.body, villager.speed);
        const double metres = villager.start + villager.speed * seconds;
        const std::size_t first = out.instances.size();
        addBody(villager.body, pose, cyclePoint(world_, villager.body, gait, metres, seconds), standing.space,
                out);
        membership_.reach(
            standing.space,
            {pose.origin + pose.linear * villager.body.bounds.centre, villager.body.bounds.radius},
            out.closed, reached_);
        giveMembers(first, out);
    }
}

void DynamicStateBuilder::addPlayer(const PlayerBody& player, double seconds, world::DynamicState& out) {
    if (!(player.opacity > 0.0))
        return;
    const bool isSolid = player.opacity >= 1.0;
    const world::MovingBody& body = isSolid ? world_.player.solid : world_.player.ghost;
    const Pose pose{turnedTo(player.yaw), player.feet};
    const world::Gait gait = gaitAt(world_, body, player.speed);
    const std::size_t first = out.instances.size();
    addBody(body, pose, cyclePoint(world_, body, gait, player.metres, seconds), player.space, out);
    for (std::size_t i = first; i < out.instances.size() && !isSolid; ++i)
        out.instances[i].opacity = static_cast<float>(player.opacity);
    membership_.reach(player.space, {pose.origin + pose.linear * body.bounds.centre, body.bounds.radius},
                      out.closed, reached_);
    giveMembers(first, out);
}

void DynamicStateBuilder::addLoose(world::DynamicState& out) {
    for (const world::LooseObject& object : world_.looseObjects) {
        const std::size_t first = out.instances.size();
        const auto begin = world_.instances.begin() + object.firstInstance;
        out.instances.insert(out.instances.end(), begin, begin + object.instanceCount);
        membership_.reach(begin->placedIn, object.bounds, out.closed, reached_);
        giveMembers(first, out);
    }
}

void DynamicStateBuilder::addSprite(const DynamicStateInput& input, std::uint32_t part, const Vec3& at,
                                    Vec2 size, double opacity, world::DynamicState& out) {
    world::Instance sprite = world_.movingParts[part];
    sprite.block = blockFor(at);
    sprite.linear =
        glm::mat3(Mat3(input.right * size.x, input.forward * std::max(size.x, size.y), input.up * size.y));
    sprite.origin = Vec3f(at - world_.blocks[sprite.block].origin());
    sprite.bounds = {at, 0.5 * glm::length(size)};
    sprite.opacity = static_cast<float>(opacity);
    sprite.idBase = world_.spriteIds + sprites_++;
    out.instances.push_back(sprite);
}

void DynamicStateBuilder::addSprites(const DynamicStateInput& input, const world::Emitter& emitter,
                                     world::DynamicState& out) {
    Pose pose{Mat3(1.0), emitter.position};
    world::SpaceIndex space = emitter.space;
    if (emitter.villager != kNone) {
        const Standing carrier = standing(world_.villagers[emitter.villager], input.seconds);
        pose = {turnedTo(carrier.yaw), carrier.position + turnedTo(carrier.yaw) * emitter.position};
        space = sweep(world_, carrier.space, carrier.position, pose.origin);
    }
    membership_.reach(space, {pose.origin, emitter.reach}, out.closed, reached_);
    const bool alone = reached_.size() == 1; // then no sprite can be anywhere else
    const SpriteRange living = livingAt(emitter, input.seconds);
    for (std::int64_t n = living.first; n <= living.last && sprites_ < world::kMostSprites; ++n) {
        const SpriteState state = spriteAt(emitter, n, input.seconds);
        if (!(state.size > 0.0))
            continue;
        const Vec3 at = pose.origin + pose.linear * state.offset;
        addSprite(input, emitter.sprite, at, Vec2(state.size), state.opacity, out);
        if (!alone)
            membership_.reach(sweep(world_, space, pose.origin, at), out.instances.back().bounds, out.closed,
                              reached_);
        giveMembers(out.instances.size() - 1, out);
    }
}

} // namespace limen::motion
