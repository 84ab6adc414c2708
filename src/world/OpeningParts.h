#pragma once

#include "core/Assert.h"
#include "world/World.h"

namespace limen::world {

/// The polygon of an opening: that of the portal, or the whole of which the portal is a part. It is up to 4 mm off its plane.
[[nodiscard]] inline const Portal& openingOf(const World& world, PortalIndex portal) {
    const Portal& part = world.portals[portal];
    return part.whole == kNone ? part : world.wholes[part.whole];
}

/// Calls act(portal) for all parts of an opening. `first`: its only portal, or its first part.
template <class Act>
void forParts(const World& world, PortalIndex first, Act&& act) {
    LIMEN_ASSERT(world.portals[first].part == 0, "an opening is named by its first part");
    for (PortalIndex p = first; p < first + world.portals[first].partCount; ++p)
        act(p);
}

} // namespace limen::world
