#include "picture/Omissions.h"

#include <algorithm>

namespace limen::test {
namespace {

/// Lists the instances by the spaces they are members of. Yields the beginning of each space's run, and the
/// end of all.
template <class IsListed>
std::vector<std::uint32_t> listBySpace(std::size_t spaceCount, const std::vector<world::Instance>& instances,
                                       const std::vector<world::SpaceIndex>& members, IsListed isListed,
                                       std::vector<world::InstanceIndex>& list) {
    list.clear();
    std::vector<std::uint32_t> first;
    for (world::SpaceIndex space = 0; space < spaceCount; ++space) {
        first.push_back(static_cast<std::uint32_t>(list.size()));
        for (world::InstanceIndex i = 0; i < instances.size(); ++i) {
            const auto own = std::span(members).subspan(instances[i].firstMember, instances[i].memberCount);
            if (isListed(i) && std::find(own.begin(), own.end(), space) != own.end())
                list.push_back(i);
        }
    }
    first.push_back(static_cast<std::uint32_t>(list.size()));
    return first;
}

void leaveOneMember(world::Instance& instance) {
    instance.memberCount = instance.memberCount > 0 ? 1 : 0;
}

} // namespace

world::World withoutMembership(const world::World& world) {
    world::World less = world;
    std::vector<bool> listed(world.instances.size(),
                             false); // instances that depend on a door are in no static list
    for (const world::InstanceIndex i : world.spaceInstances)
        listed[i] = true;
    for (world::Instance& instance : less.instances)
        leaveOneMember(instance);
    const auto first = listBySpace(
        less.spaces.size(), less.instances, less.members, [&](auto i) { return listed[i]; },
        less.spaceInstances);
    for (std::size_t s = 0; s < less.spaces.size(); ++s) {
        less.spaces[s].firstInstance = first[s];
        less.spaces[s].instanceCount = first[s + 1] - first[s];
    }
    return less;
}

world::DynamicState without(const Omissions& omissions, const world::World& world,
                            const world::DynamicState& dynamics) {
    world::DynamicState less = dynamics;
    if (omissions.membership)
        for (world::Instance& instance : less.instances)
            leaveOneMember(instance);
    if (omissions.fillings) {
        less.closed.clear();
        less.fillings.clear();
        for (world::Instance& instance : less.instances) // which then belong to no space
            if (instance.kind == world::InstanceKind::Filling)
                instance.memberCount = 0;
    }
    world::listBySpace(world.spaces.size(), less);
    return less;
}

} // namespace limen::test
