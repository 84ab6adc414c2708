#include "motion/DoorUse.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "world/LeafPose.h"
#include "world/OpeningParts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limen::motion {
namespace {

constexpr double kReach = 2.5;      // metres from the eye to the opening
constexpr double kLeastAhead = 0.5; // cosine of the angle between gaze and opening
constexpr double kUnitGaze = 1e-6;  // the square of a unit vector's length is off 1 by less

bool canSwing(const world::World& world, const world::Door& door) {
    const auto leaves = std::span(world.leaves).subspan(door.firstLeaf, door.leafCount);
    return std::any_of(leaves.begin(), leaves.end(),
                       [&](const world::Leaf& leaf) { return world::canMove(world, leaf); });
}

/// The cosine of the angle between the gaze and an opening: 1 if the gaze passes through, else that of the
/// nearest of its corners and its middle. -1 if the opening is out of reach.
double aheadOf(std::span<const Vec3> outline, const Plane& plane, const Vec3& eye, const Vec3& forward) {
    Vec3 middle(0.0);
    double nearest = std::numeric_limits<double>::infinity(), ahead = -1.0;
    const auto consider = [&](const Vec3& point) {
        const double distance = glm::length(point - eye);
        nearest = std::min(nearest, distance);
        ahead = std::max(ahead, distance > 0.0 ? glm::dot(point - eye, forward) / distance : 1.0);
    };
    for (const Vec3& corner : outline) {
        consider(corner);
        middle += corner / static_cast<double>(outline.size());
    }
    consider(middle);
    if (const double towards = glm::dot(plane.n, forward); towards != 0.0) {
        const double along = -plane.signedDistance(eye) / towards;
        const Vec3 hit = eye + forward * along;
        if (along > 0.0 && containsProjection(outline, plane.n, hit, 0.0)) {
            nearest = std::min(nearest, along);
            ahead = 1.0;
        }
    }
    return nearest <= kReach ? ahead : -1.0;
}

/// The same for a thing that opens, by the spheres around its parts at every openness.
double aheadOf(const world::World& world, const world::Door& thing, const Vec3& eye, const Vec3& forward) {
    double most = -1.0;
    for (std::uint32_t l = thing.firstLeaf; l < thing.firstLeaf + thing.leafCount; ++l) {
        const Sphere reach = world::leafReach(world, world.leaves[l]);
        const Vec3 way = reach.centre - eye;
        const double distance = glm::length(way);
        if (distance - reach.radius <= kReach)
            most = std::max(most, distance > 0.0 ? glm::dot(way, forward) / distance : 1.0);
    }
    return most;
}

/// The same for a door that a player in `space` can use; -1 for others.
double aheadOf(const world::World& world, const world::Door& door, world::SpaceIndex space, const Vec3& eye,
               const Vec3& forward) {
    if (!canSwing(world, door))
        return -1.0;
    if (door.portal == world::kNone)
        return door.space == space ? aheadOf(world, door, eye, forward) : -1.0;
    const world::Portal& portal = world::openingOf(world, door.portal);
    return portal.space == space || portal.destination == space
               ? aheadOf(world::cornersOf(world, portal), portal.plane, eye, forward)
               : -1.0;
}

} // namespace

bool DoorUse::use(const world::Door& door) {
    if (door.locked && isShut(door))
        return false;
    const auto swing = swings_.try_emplace(door.name, Swing{door.open, door.open > 0.0, door.seconds}).first;
    swing->second.opens = !swing->second.opens;
    return true;
}

bool DoorUse::isShut(const world::Door& door) const {
    const auto swing = swings_.find(door.name);
    return swing != swings_.end() ? swing->second.open == 0.0 && !swing->second.opens : door.open == 0.0;
}

void DoorUse::put(const world::Door& door, double open) {
    LIMEN_ASSERT(open >= 0.0 && open <= 1.0, "openness is 0..1");
    swings_[door.name] = {open, open > 0.0, door.seconds};
}

void DoorUse::putAll(const world::World& world, double open) {
    for (const world::Door& door : world.doors)
        put(door, open);
}

void DoorUse::swingFurther(Swing& swing, double seconds) {
    swing.open = std::clamp(swing.open + (swing.opens ? seconds : -seconds) / swing.length, 0.0, 1.0);
}

void DoorUse::pass(double seconds) {
    for (auto& [name, swing] : swings_)
        swingFurther(swing, seconds);
}

void DoorUse::pass(double seconds, const Collisions& around, BodyState& body, const BodyShape& shape) {
    const world::World& world = around.world();
    write(world, open_);
    for (auto& [name, swing] : swings_) {
        const double before = swing.open;
        swingFurther(swing, seconds);
        for (std::uint32_t i = 0; i < world.doors.size() && swing.open != before; ++i) {
            if (world.doors[i].name != name)
                continue;
            motion::swing(i, swing.open, open_, body, around, shape);
            swing.open = open_[i];
            break;
        }
    }
}

void DoorUse::write(const world::World& world, std::vector<double>& openness) const {
    openness.clear();
    for (const world::Door& door : world.doors) {
        const auto swing = swings_.find(door.name);
        openness.push_back(swing != swings_.end() ? swing->second.open : door.open);
    }
}

bool DoorUse::opens(const world::Door& door) const {
    const auto swing = swings_.find(door.name);
    return swing != swings_.end() ? swing->second.opens : door.open > 0.0;
}

std::optional<std::size_t> doorInReach(const world::World& world, world::SpaceIndex space, const Vec3& eye,
                                       const Vec3& forward) {
    LIMEN_ASSERT(std::abs(glm::dot(forward, forward) - 1.0) < kUnitGaze, "the gaze is a unit vector");
    std::optional<std::size_t> best;
    double most = kLeastAhead;
    for (std::size_t i = 0; i < world.doors.size(); ++i) {
        const double ahead = aheadOf(world, world.doors[i], space, eye, forward);
        if (ahead > most) {
            most = ahead;
            best = i;
        }
    }
    return best;
}

} // namespace limen::motion
