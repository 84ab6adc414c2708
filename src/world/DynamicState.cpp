#include "world/DynamicState.h"

#include "core/Assert.h"

namespace limen::world {

void ListedInstances::resize(std::size_t count, const Vec3& around) {
    origin = glm::floor(around); // whole metres: subtracting them rounds little
    areFar = false;
    instance.resize(count);
    isListedAgain.resize(count);
    mesh.resize(count);
    anyListedAgain = false;
    for (std::vector<float>* const values : {&x, &y, &z, &radius}) {
        values->resize(count); // drops old entries, so that the spare ones are zero
        values->resize(count + kSpare);
    }
}

void listBySpace(std::size_t spaceCount, DynamicState& dynamics) {
    std::vector<std::uint32_t>& ends = dynamics.firstInSpace;
    ends.assign(dynamics.instances.empty() ? 0 : spaceCount + 1, 0);
    const auto membersOf = [&](const Instance& instance) {
        LIMEN_ASSERT(instance.firstMember + instance.memberCount <= dynamics.members.size(),
                     "a run of members");
        return std::span(dynamics.members).subspan(instance.firstMember, instance.memberCount);
    };
    for (const Instance& instance : dynamics.instances)
        for (const SpaceIndex space : membersOf(instance))
            ++ends[space + 1];
    // From here on, ends[space + 1] is the end of the space's run so far. When all instances are listed, it
    // is the first of the next space's run.
    std::uint32_t total = 0;
    for (std::size_t space = 1; space < ends.size(); ++space) {
        const std::uint32_t count = ends[space];
        ends[space] = total;
        total += count;
    }
    dynamics.listed.resize(total,
                           dynamics.instances.empty() ? Vec3(0.0) : dynamics.instances.front().bounds.centre);
    for (InstanceIndex i = 0; i < dynamics.instances.size(); ++i)
        for (const SpaceIndex space : membersOf(dynamics.instances[i]))
            dynamics.listed.set(ends[space + 1]++, dynamics.instances[i], i);
}

} // namespace limen::world
