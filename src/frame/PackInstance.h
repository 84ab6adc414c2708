#pragma once

#include "frame/GpuLayout.h"
#include "world/World.h"

#include <span>
#include <vector>

// Device records of the world's instances, static and dynamic alike.
namespace limen::frame {

/// One member record per space, by its number: its zone and its light set. Every scene's members begin with
/// these. An instance whose spaces are all in one zone, as nearly all are, refers to one of them and has no
/// records of its own.
[[nodiscard]] std::vector<gpu::Member> membersOfSpaces(const world::World& world);

/// Receives the member records of instances that are members of several zones.
struct OwnMembers {
    std::vector<gpu::Member>& members; ///< appended to
    std::uint32_t first = 0;           ///< number of the first of `members` among all member records
};

/// The device record of an instance, without a highlight. Its members are the zones of its spaces, each once,
/// the zone of the first space first, each with the light set of the first of its spaces in that zone.
/// `members`: the array that the instance's member run is in.
[[nodiscard]] gpu::Instance packInstance(const world::World& world, const world::Instance& in,
                                         std::span<const world::SpaceIndex> members, const OwnMembers& own);

} // namespace limen::frame
