#pragma once

#include "frame/FramePlan.h"
#include "world/World.h"

#include <span>
#include <vector>

namespace limen::frame {

/// What every scene's members begin with: one for each space, by number, its zone and its light. An instance whose spaces all lie in one
/// zone, as nearly all do, names one of these, and has none of its own.
[[nodiscard]] std::vector<gpu::Member> membersOfSpaces(const world::World& world);

/// Where the zones of instances that are members of several zones go.
struct OwnMembers {
    std::vector<gpu::Member>& zones; ///< appended to
    std::uint32_t first = 0;         ///< number of the first of `zones` among all members
};

/// Number of the first member of an instance of these spaces, and how many there are: the zones of its spaces, each once, that of the first
/// space first, with the light of the first of its spaces that lies in that zone.
struct MemberRun {
    std::uint32_t first = 0, count = 0;
};
[[nodiscard]] MemberRun packMembers(const world::World& world, std::span<const world::SpaceIndex> members,
                                    const OwnMembers& own);

/// As the device has it: its members, and in the high half its kind.
[[nodiscard]] inline std::uint32_t membersAndKind(std::uint32_t members, world::InstanceKind kind) {
    return members | static_cast<std::uint32_t>(kind) << 16;
}

/// What of a moment's instances is drawn is copied from them.
[[nodiscard]] RecordArray recordsOf(std::span<const world::Instance> instances);

/// `members` is the array that the instance's member run is in (the world's or a moment's).
[[nodiscard]] gpu::Instance packInstance(const world::World& world, const world::Instance& in,
                                         std::span<const world::SpaceIndex> members, const OwnMembers& own);

} // namespace limen::frame
