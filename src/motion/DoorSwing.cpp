#include "motion/DoorSwing.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::motion {
namespace {

constexpr double kLeafStep = 0.01; // metres that no place of a leaf moves farther at once
constexpr double kClear = 0.001;   // metres that a body may be deep in a leaf
constexpr double kBeside = 0.005;  // metres that it is pushed clear of it
constexpr double kMostDeep = 0.08; // metres: what is deeper was not pushed there by a leaf
constexpr int kMostPushes = 8;     // each along what the last one met

/// Metres around the axis of a leaf that swings all the way; the farthest of those of a door.
double wayOfLeaves(const world::World& world, const world::Door& door) {
    double way = 0.0;
    for (std::uint32_t l = door.firstLeaf; l < door.firstLeaf + door.leafCount; ++l) {
        const world::Leaf& leaf = world.leaves[l];
        const double reach =
            std::hypot(leaf.body.bounds.centre.x, leaf.body.bounds.centre.y) + leaf.body.bounds.radius;
        way = std::max(way, reach * std::abs(leaf.swing) * std::numbers::pi / 180.0);
    }
    return way;
}

/// Whether a door can touch a body, however far it is open.
bool isNear(const world::World& world, const world::Door& door, const Vec3& middle, const Capsule& capsule) {
    const auto leaves = std::span(world.leaves).subspan(door.firstLeaf, door.leafCount);
    const bool isNearLeaf = std::any_of(leaves.begin(), leaves.end(), [&](const world::Leaf& leaf) {
        const Sphere& bounds = leaf.body.bounds;
        return glm::length(leaf.hinge - middle) < glm::length(bounds.centre) + bounds.radius + capsule.height;
    });
    const world::Portal& portal = world.portals[door.portal];
    return isNearLeaf ||
           (std::abs(portal.plane.signedDistance(middle)) < capsule.height &&
            containsProjection(world::cornersOf(world, portal), portal.plane.n, middle, capsule.height));
}

/// Out of the door's way as it stands now. False, and some way gone, where that cannot be.
bool giveWay(std::uint32_t door, std::span<const double> doors, BodyState& body, const Collisions& around,
             const BodyShape& shape) {
    for (int i = 0; i <= kMostPushes; ++i) {
        Vec3 out = around.wayOutOf(door, shape.capsule, body.standing, doors);
        out.z = 0.0; // leaves move on the level
        const double depth = glm::length(out);
        if (depth <= kClear)
            return true;
        if (depth > kMostDeep || i == kMostPushes)
            return false;
        body = shoved(body, out * ((depth + kBeside) / depth), around, doors, shape);
    }
    return false;
}

} // namespace

void swing(std::uint32_t door, double to, std::span<double> doors, BodyState& body, const Collisions& around,
           const BodyShape& shape) {
    const world::World& world = around.world();
    const double from = doors[door];
    const Vec3 middle = shape.capsule.middle(body.standing.feet);
    if (from == to || !isNear(world, world.doors[door], middle, shape.capsule)) {
        doors[door] = to;
        return;
    }
    const double way = wayOfLeaves(world, world.doors[door]) * std::abs(to - from);
    const int steps = std::max(static_cast<int>(std::ceil(way / kLeafStep)), 1);
    for (int i = 1; i <= steps; ++i) {
        const double before = doors[door];
        BodyState pushed = body;
        doors[door] = i == steps ? to : from + (to - from) * i / steps;
        if (!giveWay(door, doors, pushed, around, shape)) {
            doors[door] = before;
            return;
        }
        body = pushed;
    }
}

double swingAll(double from, double to, BodyState& body, const Collisions& around, std::vector<double>& doors,
                const BodyShape& shape) {
    doors.assign(around.world().doors.size(), from);
    double reached = to;
    for (std::uint32_t i = 0; i < doors.size(); ++i) {
        swing(i, to, doors, body, around, shape);
        reached = to > from ? std::min(reached, doors[i]) : std::max(reached, doors[i]);
    }
    return reached;
}

} // namespace limen::motion
