#pragma once

#include "world/World.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::world {

/// Moving instances as their spaces list them, an array for each thing that is asked of all of them in every frame: what is asked of
/// many is asked of several at once.
struct ListedInstances {
    /// More balls than are listed, so that a block of so many can be read from any of them on.
    static constexpr std::size_t kSpare = 16;
    /// Metres, along each axis, that balls may lie from `origin`.
    static constexpr double kMostOffset = 4096.0;
    std::vector<InstanceIndex> instance;     ///< of Moment::instances (not numbered on)
    std::vector<std::uint8_t> isListedAgain; ///< 1 if it is a member of other spaces, too
    std::vector<std::uint32_t> mesh;         ///< its own
    bool anyListedAgain = false;
    Vec3 origin{0.0};                   ///< global, near them
    std::vector<float> x, y, z, radius; ///< its bounds, from there; and kSpare more
    bool areFar =
        false; ///< some lie farther than kMostOffset: what these say of where balls are is of no use

    /// `around`: where most are, global.
    void resize(std::size_t count, const Vec3& around);
    void set(std::size_t position, const Instance& in, InstanceIndex number) {
        instance[position] = number;
        isListedAgain[position] = in.memberCount > 1 ? 1 : 0;
        mesh[position] = in.mesh;
        anyListedAgain |= in.memberCount > 1;
        const Vec3 offset = in.bounds.centre - origin;
        x[position] = static_cast<float>(offset.x);
        y[position] = static_cast<float>(offset.y);
        z[position] = static_cast<float>(offset.z);
        radius[position] = static_cast<float>(in.bounds.radius);
        // Neither is true of what is not a number.
        const bool isNear = std::abs(offset.x) <= kMostOffset && std::abs(offset.y) <= kMostOffset &&
                            std::abs(offset.z) <= kMostOffset && in.bounds.radius <= kMostOffset;
        areFar |= !isNear;
    }
    friend bool operator==(const ListedInstances&, const ListedInstances&) = default;
};

/// What of a world changes from moment to moment: where moving things stand, to which spaces they belong, which
/// openings are shut. Plain data laid over a World, made by motion/DynamicStateBuilder.h; visibility, frame and reference read
/// the two side by side. A moment of a world in which nothing moves is empty.
///
/// Its instances are complete: a villager's parts, door leaves, the surfaces that fill shut openings, sprites, and
/// those statics whose membership depends on a door (World::looseInstances; they are in no space's static list).
/// They are numbered on from World::instances.size(). Reuse it: steady frames allocate nothing.
struct DynamicState {
    std::vector<Instance> instances; ///< firstMember: into `members` below; idBase as in the world: stable
    std::vector<SpaceIndex> members; ///< by instance a run, placedIn first
    std::vector<std::uint32_t> firstInSpace; ///< by space, and one more: runs of `listed`; empty: none
    ListedInstances listed;                  ///< by space; made by listBySpace
    /// By portal, both of a pair alike; empty: all open. Shut portals let neither rays nor membership through.
    std::vector<std::uint8_t> closed;
    /// By portal: index into `instances` of the surface that fills the shut opening, kNone where it is open.
    std::vector<InstanceIndex> fillings;

    /// The run of `listed` that a space has.
    struct Run {
        std::uint32_t first = 0, end = 0;
    };
    [[nodiscard]] Run listedIn(SpaceIndex space) const {
        return firstInSpace.empty() ? Run() : Run{firstInSpace[space], firstInSpace[space + 1]};
    }
    /// The moving instances that are members of a space.
    [[nodiscard]] std::span<const InstanceIndex> instancesIn(SpaceIndex space) const {
        const Run run = listedIn(space);
        return std::span(listed.instance).subspan(run.first, run.end - run.first);
    }
    [[nodiscard]] bool isClosed(PortalIndex portal) const { return !closed.empty() && closed[portal] != 0; }
};

/// Lists a moment's instances, as they are now, in the spaces that they are members of, in order. `spaceCount`: of the world.
void listBySpace(std::size_t spaceCount, DynamicState& dynamics);

} // namespace limen::world
