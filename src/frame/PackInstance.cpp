#include "frame/PackInstance.h"

#include <algorithm>

namespace limen::frame {

static_assert(static_cast<std::uint32_t>(world::Kind::Shell) == gpu::kKindShell &&
              static_cast<std::uint32_t>(world::Kind::Filling) == gpu::kKindFilling);
static_assert(world::kReachSteps == static_cast<std::int32_t>(gpu::kReachSteps) &&
              world::kMostReachSteps == static_cast<std::int32_t>(gpu::kMostReachSteps) &&
              world::kMostLocalSteps == static_cast<std::int32_t>(gpu::kMostLocalSteps) &&
              std::uint32_t{world::Reach::kEndless} == gpu::kEndlessReach);

gpu::Instance packInstance(const world::World& world, const world::Instance& in,
                           std::span<const world::SpaceIndex> members, std::vector<gpu::Member>& zones) {
    gpu::Instance out;
    // glm matrices are indexed by column first.
    out.row0 = {in.linear[0][0], in.linear[1][0], in.linear[2][0], in.origin.x};
    out.row1 = {in.linear[0][1], in.linear[1][1], in.linear[2][1], in.origin.y};
    out.row2 = {in.linear[0][2], in.linear[1][2], in.linear[2][2], in.origin.z};
    out.block = in.block;
    out.idBase = in.idBase;
    out.firstMaterial = in.firstMaterial;
    out.reach = in.reach.beyond | (gpu::kEndlessReach - in.reach.upTo) << 16;
    out.opacity = in.opacity;
    out.firstMember = static_cast<std::uint32_t>(zones.size());
    for (const world::SpaceIndex member : members.subspan(in.firstMember, in.memberCount)) {
        const world::Space& space = world.spaces[member];
        const bool known = std::any_of(zones.begin() + out.firstMember, zones.end(),
                                       [&](const gpu::Member& m) { return m.zone == space.zone; });
        if (!known) {
            zones.push_back({space.zone, space.lightSet});
        }
    }
    const auto count = static_cast<std::uint32_t>(zones.size()) - out.firstMember;
    out.membersAndKind =
        std::min<std::uint32_t>(count, gpu::kMostMembers) | static_cast<std::uint32_t>(in.kind) << 16;
    return out;
}

} // namespace limen::frame
