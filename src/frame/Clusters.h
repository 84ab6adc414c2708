#pragma once

#include "visibility/Viewcone.h"
#include "world/World.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace limen::frame {

/// Positions of Clusters::order, from `first` to before `end`.
struct PositionRange {
    std::uint32_t first = 0, end = 0;
};

/// Distances at which the instances of a cluster are drawn, by their levels of detail. Conservative bounds for
/// world::isInLevelRange: metres from the eye to the middle of the cluster's bounds.
struct DetailRange {
    static constexpr double kEvery = std::numeric_limits<double>::infinity();
    double leastFrom = 0.0, mostUpTo = kEvery; ///< of the instances' ranges
    double mostFrom = 0.0, leastUpTo = kEvery;
    double slack = 0.0; ///< the most by which the distance of an instance differs from that of the middle

    /// Inside: all are drawn. Outside: none is. `offset`: from the eye to the middle of the bounds.
    [[nodiscard]] visibility::Containment at(const Vec3& offset, const world::LevelShare& share) const {
        const double factor = share.value();
        const double level = offset.x * offset.x + offset.y * offset.y; // a horizontal distance may count
        const double whole = level + offset.z * offset.z;
        if (whole < squareOf(factor * leastFrom - slack) || level >= squareOf(factor * mostUpTo + slack))
            return visibility::Containment::Outside;
        const bool areAll = level >= (mostFrom > 0.0 ? squareOf(factor * mostFrom + slack) : 0.0) &&
                            whole < squareOf(factor * leastUpTo - slack);
        return areAll ? visibility::Containment::Inside : visibility::Containment::Partial;
    }
    [[nodiscard]] bool isEndless() const { return mostFrom == 0.0 && leastUpTo == kEvery; }

private:
    static double squareOf(double metres) { return metres > 0.0 ? metres * metres : 0.0; }
};

/// Static instances near each other that are members of one space only: a range of Clusters::order, divided
/// among the cluster's children.
struct Cluster {
    Sphere bounds;                                ///< global; contains the bounds of its instances
    std::uint32_t first = 0, end = 0;             ///< positions
    std::uint32_t firstChild = 0, childCount = 0; ///< a run of Clusters::clusters; 0: a leaf
    DetailRange detail = {};
};

/// The static instances in the order in which they are resident and drawn, and a tree over each space's share
/// of that order. A property of the world: nothing here depends on a view.
struct Clusters {
    std::vector<Cluster> clusters;
    /// By position: instances by space, near ones together; then the instances that several spaces list.
    /// Instances that no space lists are absent.
    std::vector<world::InstanceIndex> order;
    std::vector<Sphere> bounds;          ///< by position, global
    std::vector<std::uint32_t> roots;    ///< by space: its tree; world::kNone if all its instances are shared
    std::uint32_t firstShared = 0;       ///< position of the first instance that several spaces list
    std::vector<std::uint32_t> sharedOf; ///< by space: positions of the shared instances that it lists
    std::vector<std::uint32_t> sharedStart; ///< by space, and one more: runs of sharedOf
    std::vector<std::uint8_t>
        sharedIsInOneZone; ///< by position from firstShared on: 1 if all its spaces are in one zone

    [[nodiscard]] std::span<const std::uint32_t> sharedIn(world::SpaceIndex space) const {
        return std::span(sharedOf).subspan(sharedStart[space], sharedStart[space + 1] - sharedStart[space]);
    }
};

/// Maximum number of instances of a leaf.
inline constexpr std::uint32_t kLeafInstances = 16;

/// Deterministic. Cost: n log n.
[[nodiscard]] Clusters buildClusters(const world::World& world);

/// Whether all spaces that an instance is a member of are in one zone. `members`: the array that its run is
/// in.
[[nodiscard]] bool isInOneZone(const world::World& world, const world::Instance& instance,
                               std::span<const world::SpaceIndex> members);

/// The tree of Clusters in batches of sibling clusters, so that siblings are tested together
/// (LevelSelection).
struct ClusterBatches {
    static constexpr std::size_t kBatchSize = visibility::SphereQuad::kCount;
    /// The children of one cluster, contiguous in memory.
    struct alignas(64) Batch {
        std::array<double, kBatchSize> x{}, y{}, z{}, radius{}; ///< bounds, global
        std::array<PositionRange, kBatchSize> positions{};
        std::array<std::uint32_t, kBatchSize> children{}; ///< their own batch; kNone: a leaf
        std::uint32_t count = 0;
        [[nodiscard]] Sphere bounds(std::size_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
    };
    using BatchDetail = std::array<DetailRange, kBatchSize>;
    explicit ClusterBatches(const Clusters& clusters);

    std::vector<Batch> batches;
    std::vector<BatchDetail> details; ///< by batch; empty if every instance is drawn at every distance
    std::vector<std::uint32_t> roots; ///< by space: the batch that holds its root only; kNone: no tree

private:
    std::uint32_t add(const Clusters& clusters, std::uint32_t first, std::uint32_t count);
};

} // namespace limen::frame
