#pragma once

#include "world/World.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limen::world {

/// A moving instance as a space lists it. What is asked of all of them in every frame lies close together.
struct ListedInstance {
    Sphere bounds;              ///< its own, global
    InstanceIndex instance = 0; ///< of Moment::instances (not numbered on)
    bool isListedAgain = false; ///< it is a member of other spaces, too
    friend bool operator==(const ListedInstance&, const ListedInstance&) = default;
};

/// What of a world changes from moment to moment: where moving things stand, to which spaces they belong, which
/// openings are shut. Plain data laid over a World, made by motion/Moments.h; visibility, frame and reference read
/// the two side by side. A moment of a world in which nothing moves is empty.
///
/// Its instances are complete: a villager's parts, door leaves, the surfaces that fill shut openings, sprites, and
/// those statics whose membership depends on a door (World::looseInstances; they are in no space's static list).
/// They are numbered on from World::instances.size(). Reuse it: steady frames allocate nothing.
struct Moment {
    std::vector<Instance> instances; ///< firstMember: into `members` below; idBase as in the world: stable
    std::vector<SpaceIndex> members; ///< by instance a run, placedIn first
    std::vector<std::uint32_t> firstInSpace; ///< by space, and one more: runs of `listed`; empty: none
    std::vector<ListedInstance> listed;      ///< by space; made by listBySpace
    /// By portal, both of a pair alike; empty: all open. Shut portals let neither rays nor membership through.
    std::vector<std::uint8_t> closed;
    /// By portal: index into `instances` of the surface that fills the shut opening, kNone where it is open.
    std::vector<InstanceIndex> fillings;

    /// The moving instances that are members of a space.
    [[nodiscard]] std::span<const ListedInstance> instancesIn(SpaceIndex space) const {
        if (firstInSpace.empty())
            return {};
        return std::span<const ListedInstance>(listed).subspan(firstInSpace[space],
                                                               firstInSpace[space + 1] - firstInSpace[space]);
    }
    [[nodiscard]] bool isClosed(PortalIndex portal) const { return !closed.empty() && closed[portal] != 0; }
};

/// Lists a moment's instances, as they are now, in the spaces that they are members of, in order. `spaceCount`: of the world.
void listBySpace(std::size_t spaceCount, Moment& moment);

} // namespace limen::world
