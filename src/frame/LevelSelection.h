#pragma once

#include "frame/Clusters.h"
#include "visibility/Viewcone.h"

#include <array>

namespace limen::frame {

/// Positions of Clusters::order, from the first to before the end.
struct PositionRange {
    std::uint32_t first = 0, end = 0;
};

/// Chooses of what stands still in a space where a single visit has the whole picture. Clusters are asked level by level, four at
/// a time: no answer is waited for, and no processor has to guess it, before the next are asked. Nobody can foretell the answers, and a
/// frame of 10,000 objects took half as long again with guessing.
///
/// Reuse it: steady frames allocate nothing. Clusters must outlive it.
class LevelSelection {
public:
    explicit LevelSelection(const Clusters& clusters);

    /// What shows of a space that has a tree, in order and apart; stays until the next call. `forward` is the view's.
    [[nodiscard]] std::span<const PositionRange> select(world::SpaceIndex space,
                                                        const visibility::Viewcones& cones, const Vec3& eye,
                                                        const Vec3& forward, double nearPlane);
    [[nodiscard]] std::uint32_t boundsTested() const { return boundsTested_; } ///< of that call

private:
    static constexpr std::size_t kFew = visibility::Viewcones::kFew;
    /// The parts of a cluster, together in memory: they are asked together.
    struct alignas(64) Parts {
        std::array<double, kFew> x{}, y{}, z{}, radius{};
        std::array<PositionRange, kFew> positions{};
        std::array<std::uint32_t, kFew> parts{}; ///< their own, index into parts_; kNone: a leaf
        std::uint32_t count = 0;
        [[nodiscard]] Sphere bounds(std::size_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
    };
    /// One of them.
    struct Part {
        std::uint32_t parts = 0, number = 0;
    };
    std::uint32_t addParts(std::uint32_t first, std::uint32_t count);
    void descend(std::uint32_t root, const visibility::Viewcones& cones, const Vec3& eye);
    void markLeaf(const PositionRange& leaf, const visibility::Viewcones& cones, const Vec3& eye);
    void mark(const PositionRange& range);
    void gather(const PositionRange& within);

    const Clusters& clusters_;
    std::vector<Parts> parts_;
    std::vector<std::uint32_t> roots_; ///< by space: index into parts_, of one that has the root alone
    // As long as they may have to be; in use is what the counts tell.
    std::vector<std::uint32_t> open_; ///< into parts_
    std::vector<PositionRange> whole_;
    std::vector<Part> leaves_;
    std::size_t wholeCount_ = 0, leafCount_ = 0;
    std::vector<std::uint64_t> marked_; ///< a bit a position: it shows; clear between calls
    std::vector<PositionRange> ranges_;
    std::uint32_t boundsTested_ = 0;
};

} // namespace limen::frame
