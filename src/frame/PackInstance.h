#pragma once

#include "frame/GpuLayout.h"
#include "world/World.h"

#include <span>
#include <vector>

namespace limen::frame {

/// Appends the zones of an instance's spaces, each once, the zone it is placed in first, with the light of the first of its spaces
/// that lies in that zone.
void addZones(const world::World& world, std::span<const world::SpaceIndex> members,
              std::vector<gpu::Member>& zones);

/// Writes an instance in the GPU's layout; here, for all that moves is packed in every frame. Its zones are appended to `zones`.
/// `members` is the array that the instance's member run is in (the world's or a moment's); `firstMember` is set relative to the start
/// of `zones`.
inline void packInto(gpu::Instance& out, const world::World& world, const world::Instance& in,
                     std::span<const world::SpaceIndex> members, std::vector<gpu::Member>& zones) {
    // glm matrices are indexed by column first.
    out.row0 = {in.linear[0][0], in.linear[1][0], in.linear[2][0], in.origin.x};
    out.row1 = {in.linear[0][1], in.linear[1][1], in.linear[2][1], in.origin.y};
    out.row2 = {in.linear[0][2], in.linear[1][2], in.linear[2][2], in.origin.z};
    out.block = in.block;
    out.idBase = in.idBase;
    out.firstMaterial = in.firstMaterial;
    out.reach = in.reach.beyond | (gpu::kEndlessReach - in.reach.upTo) << 16;
    out.opacity = in.opacity;
    const auto first = static_cast<std::uint32_t>(zones.size());
    out.firstMember = first;
    if (in.memberCount == 1) {
        const world::Space& space = world.spaces[members[in.firstMember]];
        zones.push_back({space.zone, space.lightSet});
    } else {
        addZones(world, members.subspan(in.firstMember, in.memberCount), zones);
    }
    const std::size_t count = zones.size() - first;
    out.membersAndKind = (count < gpu::kMostMembers ? static_cast<std::uint32_t>(count) : gpu::kMostMembers) |
                         static_cast<std::uint32_t>(in.kind) << 16;
}

[[nodiscard]] inline gpu::Instance packInstance(const world::World& world, const world::Instance& in,
                                                std::span<const world::SpaceIndex> members,
                                                std::vector<gpu::Member>& zones) {
    gpu::Instance out;
    packInto(out, world, in, members, zones);
    return out;
}

} // namespace limen::frame
