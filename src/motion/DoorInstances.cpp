#include "motion/DoorInstances.h"

#include "core/Assert.h"
#include "world/LeafPose.h"
#include "world/OpeningParts.h"

namespace limen::motion {
namespace {

using world::kNone;

double opennessOf(const world::World& world, const DynamicStateInput& input, std::size_t door) {
    if (input.allDoors)
        return *input.allDoors;
    return door < input.doors.size() ? input.doors[door] : world.doors[door].open;
}

/// A pose with the scale of a mesh.
BodyPose scaled(BodyPose pose, const Vec3& scale) {
    for (int axis = 0; axis < 3; ++axis)
        pose.linear[axis] *= scale[axis];
    return pose;
}

/// The parts of a thing that opens.
void addParts(const world::Door& thing, double open, DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (std::uint32_t l = thing.firstLeaf; l < thing.firstLeaf + thing.leafCount; ++l) {
        const world::Leaf& leaf = world.leaves[l];
        const world::LeafPose at = world::leafPose(world, leaf, open);
        const BodyPose pose{at.turn, at.origin};
        const std::size_t first = instances.addBody(leaf.body, scaled(pose, leaf.scale), {}, thing.space);
        instances.setSpaces(first, instances.reachedFrom(thing.space, pose.placed(leaf.body.bounds)));
    }
}

/// Leaves belong to both sides of their portal, shut or not, and to the spaces that they reach from there.
void addLeaves(const world::Door& door, double open, DynamicInstances& instances) {
    const world::World& world = instances.world();
    const world::Portal& portal = world.portals[door.portal];
    for (std::uint32_t l = door.firstLeaf; l < door.firstLeaf + door.leafCount; ++l) {
        const world::Leaf& leaf = world.leaves[l];
        const world::LeafPose at = world::leafPose(world, leaf, open);
        const BodyPose pose{at.turn, at.origin};
        const bool isShut = open == 0.0 && leaf.shut.partCount > 0;
        const std::size_t first =
            isShut ? instances.addInPlace(leaf.shut)
                   : instances.addBody(leaf.body, scaled(pose, leaf.scale), {}, portal.space);
        instances.setSpaces(first, instances.reachedFromSidesOf(portal, pose.placed(leaf.body.bounds)));
    }
}

/// The filling belongs to both sides of its portal and, being in its plane, to no other space.
void addFilling(const world::Door& door, DynamicInstances& instances) {
    world::DynamicState& state = instances.state();
    const std::size_t first = instances.addInPlace({door.filling, 1, {}});
    const auto fill = [&](world::PortalIndex p) {
        state.fillings[p] = static_cast<world::InstanceIndex>(first);
    };
    forParts(instances.world(), door.portal, fill);
    if (door.reciprocal != kNone)
        forParts(instances.world(), door.reciprocal, fill);
    instances.setSpaces(first, instances.sidesOf(instances.world().portals[door.portal]));
}

} // namespace

void shutPortals(const world::World& world, const DynamicStateInput& input, world::DynamicState& out) {
    out.closed.assign(world.doors.empty() ? 0 : world.portals.size(), 0);
    out.fillings.assign(out.closed.size(), kNone);
    for (std::size_t i = 0; i < world.doors.size(); ++i) {
        const world::Door& door = world.doors[i];
        if (door.portal == kNone)
            continue;
        LIMEN_ASSERT(door.portal < world.portals.size(), "a door fills a portal of the world");
        LIMEN_ASSERT(door.reciprocal == kNone || door.reciprocal < world.portals.size(),
                     "a door's reciprocal is a portal of the world");
        if (!door.opaque || opennessOf(world, input, i) > 0.0)
            continue;
        const auto shut = [&](world::PortalIndex p) { out.closed[p] = 1; };
        forParts(world, door.portal, shut);
        if (door.reciprocal != kNone)
            forParts(world, door.reciprocal, shut);
    }
}

void addDoors(const DynamicStateInput& input, DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (std::size_t i = 0; i < world.doors.size(); ++i) {
        const world::Door& door = world.doors[i];
        if (door.portal == kNone) {
            addParts(door, opennessOf(world, input, i), instances);
            continue;
        }
        addLeaves(door, opennessOf(world, input, i), instances);
        if (instances.state().closed[door.portal] != 0 && door.filling != kNone)
            addFilling(door, instances);
    }
}

} // namespace limen::motion
