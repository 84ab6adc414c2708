#pragma once

#include "frame/FramePlan.h"
#include "world/World.h"

#include <span>
#include <vector>

// Device records of the world's instances, static and dynamic alike.
namespace limen::frame {

/// One member record per space, by its number: its zone and its light set. Every scene's members begin with
/// these. An instance whose spaces are all in one zone refers to one of them and has no records of its own,
/// unless it has a light set of its own.
[[nodiscard]] std::vector<gpu::Member> membersOfSpaces(const world::World& world);

/// Receives the member records of instances that are members of several zones.
struct OwnMembers {
    std::vector<gpu::Member>& members; ///< appended to
    std::uint32_t first = 0;           ///< number of the first of `members` among all member records
};

/// Numbers of an instance's member records.
struct MemberRun {
    std::uint32_t first = 0, count = 0;
};
/// The member records of an instance in these spaces: their zones, each once, that of the first space first,
/// each with the light set of the first space in that zone, or in cells with `lightSet`.
[[nodiscard]] MemberRun packMembers(const world::World& world, std::span<const world::SpaceIndex> spaces,
                                    const OwnMembers& own, std::uint32_t lightSet = world::kNone);

/// gpu::Instance::membersAndKind.
[[nodiscard]] inline std::uint32_t membersAndKind(std::uint32_t members, world::InstanceKind kind) {
    return members | static_cast<std::uint32_t>(kind) << 16;
}

[[nodiscard]] gpu::Level packLevel(const world::Level& level);

/// The device record of an instance, without a highlight.
[[nodiscard]] gpu::Instance packInstance(const world::Instance& in, const MemberRun& members);

/// Makes records of the instances of a dynamic state, each as a member of the space that it is placed in.
[[nodiscard]] DynamicRecords recordsOf(std::span<const world::Instance> instances);

} // namespace limen::frame
