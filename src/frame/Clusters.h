#pragma once

#include "world/World.h"

#include <span>
#include <vector>

namespace limen::frame {

/// Instances near each other that are members of one space alone: a range of Clusters::order, parted among its children.
struct Cluster {
    Sphere bounds;                                ///< global; holds those of its instances
    std::uint32_t first = 0, end = 0;             ///< positions
    std::uint32_t firstChild = 0, childCount = 0; ///< a run of Clusters::clusters; none: a leaf
};

/// What stands still, in the order in which it is resident and drawn, and a tree over each space's share of it. A fixed
/// property of the world: nothing here depends on an eye.
struct Clusters {
    std::vector<Cluster> clusters;
    /// By position: instances by space, near ones together; behind them those that several spaces list. What no space
    /// lists is not here.
    std::vector<world::InstanceIndex> order;
    std::vector<Sphere> bounds;          ///< by position, global
    std::vector<std::uint32_t> roots;    ///< by space: its tree, world::kNone if all its instances are shared
    std::uint32_t firstShared = 0;       ///< position of the first that several spaces list
    std::vector<std::uint32_t> sharedOf; ///< by space: positions of those it lists
    std::vector<std::uint32_t> sharedStart; ///< by space, and one more: runs of sharedOf

    [[nodiscard]] std::span<const std::uint32_t> sharedIn(world::SpaceIndex space) const {
        return std::span(sharedOf).subspan(sharedStart[space], sharedStart[space + 1] - sharedStart[space]);
    }
};

/// Most instances of a leaf.
inline constexpr std::uint32_t kLeafInstances = 16;

/// The same for the same world, always. Cost: n log n.
[[nodiscard]] Clusters buildClusters(const world::World& world);

} // namespace limen::frame
