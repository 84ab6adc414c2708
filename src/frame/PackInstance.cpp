#include "frame/PackInstance.h"

#include <algorithm>

namespace limen::frame {

static_assert(static_cast<std::uint32_t>(world::Kind::Shell) == gpu::kKindShell &&
              static_cast<std::uint32_t>(world::Kind::Filling) == gpu::kKindFilling);
static_assert(world::kReachSteps == static_cast<std::int32_t>(gpu::kReachSteps) &&
              world::kMostReachSteps == static_cast<std::int32_t>(gpu::kMostReachSteps) &&
              world::kMostLocalSteps == static_cast<std::int32_t>(gpu::kMostLocalSteps) &&
              std::uint32_t{world::Reach::kEndless} == gpu::kEndlessReach);

void addZones(const world::World& world, std::span<const world::SpaceIndex> members,
              std::vector<gpu::Member>& zones) {
    const std::size_t first = zones.size();
    for (const world::SpaceIndex member : members) {
        const world::Space& space = world.spaces[member];
        const bool known = std::any_of(zones.begin() + static_cast<std::ptrdiff_t>(first), zones.end(),
                                       [&](const gpu::Member& zone) { return zone.zone == space.zone; });
        if (!known) {
            zones.push_back({space.zone, space.lightSet});
        }
    }
}

} // namespace limen::frame
