#include "world/DynamicState.h"

namespace limen::world {

void ListedInstances::resize(std::size_t count, const Vec3& around) {
    origin = glm::floor(around); // so that what is subtracted from it loses little
    areFar = false;
    instance.resize(count);
    isListedAgain.resize(count);
    mesh.resize(count);
    anyListedAgain = false;
    for (std::vector<float>* const values : {&x, &y, &z, &radius}) {
        values->resize(count); // what is left over from more is not a moment's
        values->resize(count + kSpare);
    }
}

void listBySpace(std::size_t spaceCount, DynamicState& dynamics) {
    std::vector<std::uint32_t>& ends = dynamics.firstInSpace;
    ends.assign(dynamics.instances.empty() ? 0 : spaceCount + 1, 0);
    const auto membersOf = [&](const Instance& instance) {
        return std::span(dynamics.members).subspan(instance.firstMember, instance.memberCount);
    };
    for (const Instance& instance : dynamics.instances)
        for (const SpaceIndex space : membersOf(instance))
            ++ends[space + 1];
    // From here on behind each space its run's end so far, which is the next one's begin when all are listed.
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
