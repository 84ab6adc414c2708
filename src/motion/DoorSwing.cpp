#include "motion/DoorSwing.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "world/LeafPose.h"
#include "world/OpeningParts.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

constexpr double kLeafStep = 0.01; // metres that any point of a leaf moves at most in one step
constexpr double kClear = 0.001;   // metres of overlap of body and leaf that are tolerated
constexpr double kBeside = 0.005;  // metres between leaf and body after a push
constexpr double kMostDeep = 0.08; // metres: a deeper overlap was not caused by a step of a leaf
constexpr int kMostPushes = 8;     // each along the obstacle that the last one met

/// Metres that the farthest point of a door's leaves moves in a full swing.
double wayOfLeaves(const world::World& world, const world::Door& door) {
    double way = 0.0;
    for (std::uint32_t l = door.firstLeaf; l < door.firstLeaf + door.leafCount; ++l)
        way = std::max(way, world::leafWay(world, world.leaves[l]));
    return way;
}

/// Whether a door can touch a body at any openness.
bool isNear(const world::World& world, const world::Door& door, const Vec3& middle, const Capsule& capsule) {
    if (door.portal == world::kNone)
        return false; // a thing that opens stops no body
    const auto leaves = std::span(world.leaves).subspan(door.firstLeaf, door.leafCount);
    const bool isNearLeaf = std::any_of(leaves.begin(), leaves.end(), [&](const world::Leaf& leaf) {
        const Sphere reach = world::leafReach(world, leaf);
        return glm::length(reach.centre - middle) < reach.radius + capsule.height;
    });
    const world::Portal& portal = world::openingOf(world, door.portal);
    return isNearLeaf ||
           (std::abs(portal.plane.signedDistance(middle)) < capsule.height &&
            containsProjection(world::cornersOf(world, portal), portal.plane.n, middle, capsule.height));
}

/// Moves the body out of the door's way. False if it cannot; the body may then have moved in part.
bool giveWay(std::uint32_t door, std::span<const double> doors, BodyState& body, const Collisions& around,
             const BodyShape& shape) {
    for (int i = 0; i <= kMostPushes; ++i) {
        Vec3 out = around.wayOutOf(door, shape.capsule, body.standing, doors);
        out.z = 0.0; // leaves move horizontally
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
    LIMEN_ASSERT(doors.size() == world.doors.size(), "an openness for each door of the world");
    LIMEN_ASSERT(door < doors.size(), "the door that swings is one of the world");
    LIMEN_ASSERT(to >= 0.0 && to <= 1.0, "openness is 0..1");
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
