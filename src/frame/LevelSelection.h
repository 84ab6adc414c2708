#pragma once

#include "frame/Clusters.h"

namespace limen::frame {

/// Selects the static instances of a space in which a single visit has the whole picture. Leaves out clusters
/// whose levels of detail are all out of range. Tests clusters level by level, four at a time. No branch depends on a result: with unpredictable branches a frame of
/// 10,000 objects took 1.5 times as long.
///
/// Reuse it: steady frames allocate nothing. Clusters and batches must outlive it.
class LevelSelection {
public:
    LevelSelection(const Clusters& clusters, const ClusterBatches& batches);

    /// The visible ranges of a space that has a tree, in order and disjoint; valid until the next call.
    /// `forward` is the view's.
    [[nodiscard]] std::span<const PositionRange> select(world::SpaceIndex space,
                                                        const visibility::Viewcones& cones, const Vec3& eye,
                                                        const Vec3& forward, double nearPlane,
                                                        const world::LevelShare& levels = {});
    [[nodiscard]] std::uint32_t boundsTested() const { return boundsTested_; } ///< in the last call

private:
    /// One cluster of a batch.
    struct BatchEntry {
        std::uint32_t batch = 0, number = 0;
    };
    /// DetailRange::at for a cluster of a batch.
    [[nodiscard]] visibility::Containment levelsAt(std::uint32_t batch, std::uint32_t number,
                                                   const Vec3& eye) const {
        return batches_.details.empty() ? visibility::Containment::Inside
                                        : batches_.details[batch][number].at(
                                              batches_.batches[batch].bounds(number).centre - eye, share_);
    }
    void descend(std::uint32_t root, const visibility::Viewcones& cones, const Vec3& eye);
    void markLeaf(const PositionRange& leaf, const visibility::Viewcones& cones, const Vec3& eye);
    void mark(const PositionRange& range);
    void gather(const PositionRange& within);

    world::LevelShare share_; ///< of the call
    const Clusters& clusters_;
    const ClusterBatches& batches_;
    // These arrays have their maximum size; the counts say how much of them is in use.
    std::vector<std::uint32_t> open_; ///< batches to test
    std::vector<PositionRange> whole_;
    std::vector<BatchEntry> leaves_;
    std::size_t wholeCount_ = 0, leafCount_ = 0;
    std::vector<std::uint64_t> marked_; ///< a bit per position: it is visible; all 0 between calls
    std::vector<PositionRange> ranges_;
    std::uint32_t boundsTested_ = 0;
};

} // namespace limen::frame
