#include "reference/SceneData.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::reference {
namespace {

Vec3 originOf(const world::World& world) {
    return world.blocks.empty() ? Vec3(0.0) : world.blocks.front().origin();
}

} // namespace

SceneData::SceneData(const world::World& of, const RuleOptions& with)
    : world(of), options(with), origin(originOf(of)), openings(of, origin), fixed(of, origin),
      moving(of, origin) {
    LIMEN_ASSERT(!world.spaces.empty(), "a world has at least the outside");
    for (BodyLists* bySpace : {&fixedBySpace, &movingBySpace})
        bySpace->resize(world.spaces.size());
    for (BodyLists* byZone : {&fixedByZone, &movingByZone})
        byZone->resize(options.objectsByZone ? world.zones.size() : 0);
    listFixed();
}

void SceneData::listFixed() {
    fixed.assign(world.instances);
    std::vector<std::uint8_t> isListed(world.instances.size(), 0);
    for (world::SpaceIndex s = 0; s < world.spaces.size(); ++s) {
        const world::Space& space = world.spaces[s];
        for (std::uint32_t i = space.firstInstance; i < space.firstInstance + space.instanceCount; ++i) {
            const world::InstanceIndex instance = world.spaceInstances[i];
            isListed[instance] = 1;
            addBySpace(fixed, world.instances[instance], instance, s, fixedBySpace);
        }
    }
    for (world::InstanceIndex i = 0; i < world.instances.size(); ++i)
        if (isListed[i] != 0) // else it is listed in the dynamic state
            addByZone(fixed, world.instances[i], i, world.members, fixedByZone);
    fixedBySpace.build(fixed);
    fixedByZone.build(fixed);
}

bool SceneData::goesByZone(const world::Instance& instance) const {
    const bool ofOneSpace = instance.kind == world::InstanceKind::Shell ||
                            instance.kind == world::InstanceKind::Terrain ||
                            instance.kind == world::InstanceKind::Exterior;
    return options.objectsByZone && !ofOneSpace;
}

void SceneData::addBySpace(const Bodies& bodies, const world::Instance& instance, std::uint32_t body,
                           world::SpaceIndex space, BodyLists& bySpace) const {
    if (!goesByZone(instance))
        bySpace.add(bodies, space, body);
}

void SceneData::addByZone(const Bodies& bodies, const world::Instance& instance, std::uint32_t body,
                          std::span<const world::SpaceIndex> members, BodyLists& byZone) const {
    if (!goesByZone(instance))
        return;
    std::vector<world::ZoneIndex> zones;
    for (const world::SpaceIndex s : members.subspan(instance.firstMember, instance.memberCount))
        zones.push_back(world.spaces[s].zone);
    std::sort(zones.begin(), zones.end());
    zones.erase(std::unique(zones.begin(), zones.end()), zones.end());
    for (const world::ZoneIndex zone : zones)
        byZone.add(bodies, zone, body);
}

void SceneData::takeDynamics(const world::DynamicState& dynamics) {
    LIMEN_ASSERT(dynamics.firstInSpace.empty() || dynamics.firstInSpace.size() == world.spaces.size() + 1,
                 "a dynamic state is of the scene's world");
    LIMEN_ASSERT(dynamics.closed.empty() || dynamics.closed.size() == world.portals.size(),
                 "a dynamic state is of the scene's world");
    movingInstances_.assign(dynamics.instances.begin(), dynamics.instances.end());
    moving.assign(movingInstances_);
    movingBySpace.clear();
    movingByZone.clear();
    if (!dynamics.firstInSpace.empty()) {
        for (world::SpaceIndex s = 0; s < world.spaces.size(); ++s)
            for (const world::InstanceIndex i : dynamics.instancesIn(s))
                addBySpace(moving, dynamics.instances[i], i, s, movingBySpace);
    }
    for (world::InstanceIndex i = 0; i < dynamics.instances.size(); ++i)
        addByZone(moving, dynamics.instances[i], i, dynamics.members, movingByZone);
    movingBySpace.build(moving);
    movingByZone.build(moving);
    shut = dynamics.closed;
    fillings = dynamics.fillings;
    for (const world::InstanceIndex filling : fillings)
        LIMEN_ASSERT(filling == world::kNone || filling < dynamics.instances.size(),
                     "a filling is an instance of the dynamic state");
}

} // namespace limen::reference
