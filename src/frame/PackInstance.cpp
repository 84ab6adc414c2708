#include "frame/PackInstance.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace limen::frame {

static_assert(static_cast<std::uint32_t>(world::InstanceKind::Shell) == gpu::kKindShell &&
              static_cast<std::uint32_t>(world::InstanceKind::Filling) == gpu::kKindFilling);
static_assert(world::kRangeSteps == static_cast<std::int32_t>(gpu::kRangeSteps) &&
              world::kMostRangeSteps == static_cast<std::int32_t>(gpu::kMostRangeSteps) &&
              world::kMostLocalSteps == static_cast<std::int32_t>(gpu::kMostLocalSteps) &&
              std::uint32_t{world::LevelRange::kEndless} == gpu::kEndlessRange);

// An instance begins as its record (RecordArray).
static_assert(offsetof(world::Instance, linear) == offsetof(gpu::Instance, pose0) &&
              offsetof(world::Instance, origin) == 9 * sizeof(float) &&
              offsetof(world::Instance, block) == offsetof(gpu::Instance, block) &&
              offsetof(world::Instance, idBase) == offsetof(gpu::Instance, idBase) &&
              offsetof(world::Instance, firstMaterial) == offsetof(gpu::Instance, firstMaterial) &&
              offsetof(world::Instance, placedIn) == offsetof(gpu::Instance, firstMember) &&
              offsetof(world::Instance, memberCount) == offsetof(gpu::Instance, membersAndKind) &&
              offsetof(world::Instance, kind) == offsetof(gpu::Instance, membersAndKind) + 2 &&
              sizeof(world::InstanceKind) == 2 && world::Instance::kMostMembers == gpu::kMostMembers &&
              offsetof(world::Instance, reach) == offsetof(gpu::Instance, reach) &&
              offsetof(world::Instance, opacity) == offsetof(gpu::Instance, opacity));
static_assert(sizeof(world::LevelRange) == sizeof(gpu::Instance::reach) &&
              offsetof(world::LevelRange, beyond) == 0 && std::endian::native == std::endian::little);

std::vector<gpu::Member> membersOfSpaces(const world::World& world) {
    std::vector<gpu::Member> members;
    members.reserve(world.spaces.size());
    for (const world::Space& space : world.spaces)
        members.push_back({space.zone, space.lightSet});
    return members;
}

MemberRun packMembers(const world::World& world, std::span<const world::SpaceIndex> members,
                      const OwnMembers& own) {
    if (members.size() == 1)
        return {members.front(), 1};
    const std::size_t first = own.zones.size();
    for (const world::SpaceIndex member : members) {
        const world::Space& space = world.spaces[member];
        const bool known =
            std::any_of(own.zones.begin() + static_cast<std::ptrdiff_t>(first), own.zones.end(),
                        [&](const gpu::Member& zone) { return zone.zone == space.zone; });
        if (!known)
            own.zones.push_back({space.zone, space.lightSet});
    }
    const std::size_t count = own.zones.size() - first;
    if (count == 1) {
        own.zones.pop_back();
        return {members.front(), 1};
    }
    return {own.first + static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(std::min<std::size_t>(count, gpu::kMostMembers))};
}

RecordArray recordsOf(std::span<const world::Instance> instances) {
    return {reinterpret_cast<const std::byte*>(instances.data()), sizeof(world::Instance)};
}

gpu::Instance packInstance(const world::World& world, const world::Instance& in,
                           std::span<const world::SpaceIndex> members, const OwnMembers& own) {
    const MemberRun run = packMembers(world, members.subspan(in.firstMember, in.memberCount), own);
    gpu::Instance out;
    recordsOf({&in, 1}).copyTo(out, 0);
    MoverChange{0, run.first, membersAndKind(run.count, in.kind), 0}.applyTo(out);
    return out;
}

} // namespace limen::frame
