#pragma once

#include "core/Assert.h"
#include "world/World.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::world {

/// Dynamic instances in the order in which their spaces list them, one array for each property that every
/// frame reads of all. So frustum culling tests several spheres at once.
struct ListedInstances {
    /// Spare spheres at the end of the arrays, so that a batch of this size can be read from any position on.
    static constexpr std::size_t kSpare = 16;
    /// Greatest distance of spheres from `origin` along each axis, metres.
    static constexpr double kMostOffset = 4096.0;
    std::vector<InstanceIndex> instance;     ///< index into DynamicState::instances
    std::vector<std::uint8_t> isListedAgain; ///< 1 if it is a member of other spaces, too
    std::vector<std::uint32_t> mesh;         ///< index into World::meshes
    bool anyListedAgain = false;
    Vec3 origin{0.0};                   ///< global, near the spheres
    std::vector<float> x, y, z, radius; ///< bounds relative to `origin`; with kSpare more entries
    bool areFar =
        false; ///< some sphere exceeds kMostOffset or is not finite: x, y, z and radius must not be used

    /// `around`: a global position near most instances.
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
        // All of these comparisons are false for NaN.
        const bool isNear = std::abs(offset.x) <= kMostOffset && std::abs(offset.y) <= kMostOffset &&
                            std::abs(offset.z) <= kMostOffset && in.bounds.radius <= kMostOffset;
        areFar |= !isNear;
    }
    friend bool operator==(const ListedInstances&, const ListedInstances&) = default;
};

/// The dynamic state of a world at one time: poses of dynamic instances, their spaces, and the shut openings.
/// Plain data beside a World, made by motion/DynamicStateBuilder.h; visibility, frame and reference read
/// both. Empty for a world without dynamic objects.
///
/// Its instances are complete: parts of villagers, door leaves, fillings of shut openings, sprites, and the
/// static objects whose membership depends on a door (World::looseObjects; no space's static list has them).
/// Their numbers continue those of World::instances. Reuse the object: then steady frames do not allocate.
struct DynamicState {
    std::vector<Instance>
        instances; ///< firstMember is an index into `members` below; idBase is as in the world
    std::vector<SpaceIndex> members; ///< a run for each instance, placedIn first
    std::vector<std::uint32_t>
        firstInSpace;       ///< by space, plus one entry: runs of `listed`; empty: no instances
    ListedInstances listed; ///< by space; made by listBySpace
    /// By portal, equal for both portals of a pair; empty: all are open. Shut portals stop rays and
    /// membership.
    std::vector<std::uint8_t> closed;
    /// By portal: index into `instances` of the filling of a shut opening; kNone if it is open.
    std::vector<InstanceIndex> fillings;

    /// A run of `listed`.
    struct Run {
        std::uint32_t first = 0, end = 0;
    };
    [[nodiscard]] Run listedIn(SpaceIndex space) const {
        LIMEN_ASSERT(firstInSpace.empty() || space + 1 < firstInSpace.size(), "the space has a run");
        return firstInSpace.empty() ? Run() : Run{firstInSpace[space], firstInSpace[space + 1]};
    }
    /// The dynamic instances that are members of a space.
    [[nodiscard]] std::span<const InstanceIndex> instancesIn(SpaceIndex space) const {
        const Run run = listedIn(space);
        return std::span(listed.instance).subspan(run.first, run.end - run.first);
    }
    [[nodiscard]] bool isClosed(PortalIndex portal) const { return !closed.empty() && closed[portal] != 0; }
};

/// Fills `listed` and `firstInSpace` from the instances and their members. `spaceCount`: that of the world.
void listBySpace(std::size_t spaceCount, DynamicState& dynamics);

} // namespace limen::world
