#include "world/assemble/Members.h"

#include "core/Assert.h"
#include "world/Membership.h"
#include "world/OpeningParts.h"

#include <algorithm>

namespace limen::world {
namespace {

/// By portal: 1 if it is shut while every opaque door is closed.
std::vector<std::uint8_t> allDoorsShut(const World& world) {
    std::vector<std::uint8_t> shut(world.portals.size(), 0);
    for (const Door& door : world.doors) {
        if (!door.opaque)
            continue;
        forParts(world, door.portal, [&](PortalIndex p) { shut[p] = 1; });
        if (door.reciprocal != kNone)
            forParts(world, door.reciprocal, [&](PortalIndex p) { shut[p] = 1; });
    }
    return shut;
}

void addBillboards(const ObjectGroup& group, World& world) {
    for (InstanceIndex i = group.firstInstance; i < group.firstInstance + group.instanceCount; ++i)
        if (world.instances[i].facing != Facing::Fixed)
            world.billboards.push_back({i, group.origin});
}

} // namespace

void findMembers(std::span<const ObjectGroup> objects, World& world) {
    LIMEN_ASSERT(world.members.empty(), "members are found once");
    const Membership membership(world);
    std::vector<SpaceIndex> reached, reachedShut;
    for (Instance& instance : world.instances) {
        LIMEN_ASSERT(instance.placedIn < world.spaces.size(), "an instance is placed in a space");
        instance.firstMember = static_cast<std::uint32_t>(world.members.size());
        instance.memberCount = 1;
        world.members.push_back(instance.placedIn);
    }
    const std::vector<std::uint8_t> shut = allDoorsShut(world);
    for (const ObjectGroup& group : objects) {
        LIMEN_ASSERT(group.instanceCount > 0 &&
                         group.firstInstance + group.instanceCount <= world.instances.size(),
                     "a group is a run of instances");
        const SpaceIndex placedIn = world.instances[group.firstInstance].placedIn;
        membership.reach(placedIn, group.bounds, {}, reached);
        if (reached.size() == 1) {
            addBillboards(group, world);
            continue;
        }
        // Shutting doors only takes spaces away. An object with the same spaces when all are shut has them
        // always.
        membership.reach(placedIn, group.bounds, shut, reachedShut);
        if (reachedShut.size() != reached.size())
            world.looseObjects.push_back(
                {group.firstInstance, group.instanceCount, group.bounds, group.origin});
        else
            addBillboards(group, world);
        const auto first = static_cast<std::uint32_t>(world.members.size());
        world.members.insert(world.members.end(), reached.begin(), reached.end());
        for (InstanceIndex i = group.firstInstance; i < group.firstInstance + group.instanceCount; ++i)
            world.instances[i].setMembers(first, reached.size());
    }
}

void findAlone(World& world) {
    const Membership membership(world);
    std::vector<SpaceIndex> reached;
    const auto isAlone = [&](SpaceIndex space, const Sphere& sphere) {
        membership.reach(space, sphere, {}, reached);
        return reached.size() == 1;
    };
    for (IdleObject& idle : world.idleObjects) {
        const Sphere& sphere = idle.body.bounds;
        const Vec3 centre = idle.origin + idle.orientation * sphere.centre * idle.scale;
        idle.isAlone = isAlone(idle.space, {centre, sphere.radius * idle.scale});
    }
    for (ParticleSource& source : world.particleSources)
        if (source.villager == kNone && source.idle == kNone)
            source.isAlone = isAlone(source.space, {source.at.origin, source.reach});
}

void listInstances(World& world) {
    LIMEN_ASSERT(world.spaceInstances.empty(), "instances are listed once");
    std::vector<std::vector<InstanceIndex>> bySpace(world.spaces.size());
    std::vector<std::uint8_t> loose(world.instances.size(), 0);
    for (const LooseObject& object : world.looseObjects)
        std::fill_n(loose.begin() + object.firstInstance, object.instanceCount, std::uint8_t{1});
    for (InstanceIndex i = 0; i < world.instances.size(); ++i) {
        const Instance& instance = world.instances[i];
        if (loose[i] != 0 || instance.facing != Facing::Fixed)
            continue;
        for (std::uint32_t m = 0; m < instance.memberCount; ++m) {
            std::vector<InstanceIndex>& list = bySpace[world.members[instance.firstMember + m]];
            if (instance.kind == InstanceKind::Shell)
                list.insert(list.begin(), i);
            else
                list.push_back(i);
        }
    }
    for (std::size_t i = 0; i < world.spaces.size(); ++i) {
        const InstanceIndex shell = world.spaces[i].shell;
        LIMEN_ASSERT(shell == kNone || bySpace[i].front() == shell, "a cell's shell is listed first");
        world.spaces[i].firstInstance = static_cast<std::uint32_t>(world.spaceInstances.size());
        world.spaces[i].instanceCount = static_cast<std::uint32_t>(bySpace[i].size());
        world.spaceInstances.insert(world.spaceInstances.end(), bySpace[i].begin(), bySpace[i].end());
    }
}

void numberPolygons(World& world) {
    LIMEN_ASSERT(world.idEnd == 2, "ids 0 and 1 are the void and the sky");
    const auto number = [&world](Instance& instance) {
        LIMEN_ASSERT(instance.mesh < world.meshes.size(), "an instance has a mesh");
        instance.idBase = world.idEnd;
        world.idEnd += world.meshes[instance.mesh].polygonCount;
    };
    std::for_each(world.instances.begin(), world.instances.end(), number);
    std::for_each(world.movingParts.begin(), world.movingParts.end(), number);
    world.spriteIds = world.idEnd;
    world.idEnd += kMostSprites;
}

} // namespace limen::world
