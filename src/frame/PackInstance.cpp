#include "frame/PackInstance.h"

#include <algorithm>

namespace limen::frame {

static_assert(static_cast<std::uint32_t>(world::InstanceKind::Shell) == gpu::kKindShell &&
              static_cast<std::uint32_t>(world::InstanceKind::Filling) == gpu::kKindFilling);
static_assert(world::kRangeSteps == static_cast<std::int32_t>(gpu::kRangeSteps) &&
              world::kMostRangeSteps == static_cast<std::int32_t>(gpu::kMostRangeSteps) &&
              world::kMostLocalSteps == static_cast<std::int32_t>(gpu::kMostLocalSteps) &&
              std::uint32_t{world::LevelRange::kEndless} == gpu::kEndlessRange);

namespace {

struct MemberRun {
    std::uint32_t first = 0, count = 0;
};

MemberRun packSeveralMembers(const world::World& world, std::span<const world::SpaceIndex> spaces,
                             const OwnMembers& own) {
    const std::size_t first = own.members.size();
    for (const world::SpaceIndex index : spaces) {
        const world::Space& space = world.spaces[index];
        const bool isKnown =
            std::any_of(own.members.begin() + static_cast<std::ptrdiff_t>(first), own.members.end(),
                        [&](const gpu::Member& member) { return member.zone == space.zone; });
        if (!isKnown)
            own.members.push_back({space.zone, space.lightSet});
    }
    const std::size_t count = own.members.size() - first;
    if (count == 1) {
        own.members.pop_back();
        return {spaces.front(), 1};
    }
    return {own.first + static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(std::min<std::size_t>(count, gpu::kMostMembers))};
}

} // namespace

std::vector<gpu::Member> membersOfSpaces(const world::World& world) {
    std::vector<gpu::Member> members;
    members.reserve(world.spaces.size());
    for (const world::Space& space : world.spaces)
        members.push_back({space.zone, space.lightSet});
    return members;
}

gpu::Instance packInstance(const world::World& world, const world::Instance& in,
                           std::span<const world::SpaceIndex> members, const OwnMembers& own) {
    const std::span<const world::SpaceIndex> spaces = members.subspan(in.firstMember, in.memberCount);
    const MemberRun run =
        spaces.size() == 1 ? MemberRun{spaces.front(), 1} : packSeveralMembers(world, spaces, own);
    const glm::mat3& m = in.linear;
    constexpr std::uint32_t kNoHighlight = 0;
    return {{m[0].x, m[0].y, m[0].z, m[1].x},
            {m[1].y, m[1].z, m[2].x, m[2].y},
            {m[2].z, in.origin.x, in.origin.y, in.origin.z},
            in.block,
            in.idBase,
            in.firstMaterial,
            run.first,
            run.count | static_cast<std::uint32_t>(in.kind) << 16,
            in.levelRange.beyond | std::uint32_t{in.levelRange.upTo} << 16,
            kNoHighlight,
            in.opacity};
}

} // namespace limen::frame
