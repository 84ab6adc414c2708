#include "frame/LevelSelection.h"

#include "core/Prefetch.h"

#include <algorithm>
#include <bit>

namespace limen::frame {

namespace {

using visibility::Containment;
/// Batches prefetched ahead of the one that is tested.
constexpr std::size_t kBatchesAhead = 4;
constexpr std::uint32_t kBits = 64;
constexpr std::uint64_t kAll = ~std::uint64_t{0};

} // namespace

LevelSelection::LevelSelection(const Clusters& clusters, const ClusterBatches& batches)
    : clusters_(clusters), batches_(batches) {
    // One more of each: `descend` writes an element before it knows whether to count it.
    open_.resize(batches.batches.size() + 1);
    whole_.resize(clusters.clusters.size() + 1);
    leaves_.resize(clusters.clusters.size() + 1);
    marked_.resize(clusters.order.size() / kBits + 1);
}

std::span<const PositionRange> LevelSelection::select(world::SpaceIndex space,
                                                      const visibility::Viewcones& cones, const Vec3& eye,
                                                      const Vec3& forward, double nearPlane,
                                                      const world::LevelShare& levels) {
    share_ = levels;
    ranges_.clear();
    boundsTested_ = 0;
    const std::uint32_t root = batches_.roots[space];
    descend(root, cones, eye);
    for (std::size_t i = 0; i < wholeCount_; ++i)
        mark(whole_[i]);
    for (std::size_t i = 0; i < leafCount_; ++i) {
        const ClusterBatches::Batch& batch = batches_.batches[leaves_[i].batch];
        const std::uint32_t number = leaves_[i].number;
        const Sphere bounds = batch.bounds(number);
        // A leaf ahead of the near plane is drawn whole: testing its instances costs more than drawing those
        // beyond the picture's edges. Not a leaf that extends behind the eye: its triangles are kept across
        // the whole window.
        if (glm::dot(bounds.centre - eye, forward) > bounds.radius + nearPlane)
            mark(batch.positions[number]);
        else
            markLeaf(batch.positions[number], cones, eye);
    }
    if (wholeCount_ + leafCount_ > 0)
        gather(batches_.batches[root].positions[0]);
    return ranges_;
}

void LevelSelection::descend(std::uint32_t root, const visibility::Viewcones& cones, const Vec3& eye) {
    std::size_t openCount = 1;
    open_[0] = root;
    wholeCount_ = leafCount_ = 0;
    for (std::size_t next = 0; next < openCount; ++next) {
        const std::uint32_t index = open_[next];
        const ClusterBatches::Batch& batch = batches_.batches[index];
        const auto found =
            cones.classifyQuad({batch.x.data(), batch.y.data(), batch.z.data(), batch.radius.data()}, eye);
        boundsTested_ += batch.count;
        for (std::uint32_t i = 0; i < batch.count; ++i) {
            // Every list is written; only the counts depend on the result.
            const Containment levels = levelsAt(index, i, eye);
            const bool isLeaf = batch.children[i] == world::kNone;
            const bool isSeen = levels != Containment::Outside;
            const bool isInside = found[i] == Containment::Inside;
            const bool isPartial = isSeen & (found[i] == Containment::Partial);
            const bool isWhole = isSeen & isInside & (isLeaf | (levels == Containment::Inside));
            const bool isOpened = isPartial | (isSeen & isInside & !isWhole);
            open_[openCount] = batch.children[i];
            leaves_[leafCount_] = {index, i};
            whole_[wholeCount_] = batch.positions[i];
            openCount += static_cast<std::size_t>(isOpened & !isLeaf);
            leafCount_ += static_cast<std::size_t>(isPartial & isLeaf);
            wholeCount_ += static_cast<std::size_t>(isWhole);
        }
        if (next + kBatchesAhead < openCount)
            prefetch(batches_.batches[open_[next + kBatchesAhead]]);
    }
}

void LevelSelection::markLeaf(const PositionRange& leaf, const visibility::Viewcones& cones,
                              const Vec3& eye) {
    for (std::uint32_t position = leaf.first; position < leaf.end; ++position) {
        const Sphere& sphere = clusters_.bounds[position];
        if (cones.classify(0, cones.sphereOf({sphere.centre - eye, sphere.radius})) != Containment::Outside)
            mark({position, position + 1});
    }
    boundsTested_ += leaf.end - leaf.first;
}

void LevelSelection::mark(const PositionRange& range) {
    const auto [first, end] = range;
    const std::uint32_t firstWord = first / kBits, lastWord = (end - 1) / kBits;
    const std::uint64_t from = kAll << first % kBits, upTo = kAll >> (kBits - 1 - (end - 1) % kBits);
    if (firstWord == lastWord) {
        marked_[firstWord] |= from & upTo;
        return;
    }
    marked_[firstWord] |= from;
    std::fill(marked_.begin() + firstWord + 1, marked_.begin() + lastWord, kAll);
    marked_[lastWord] |= upTo;
}

// Clears the marks.
void LevelSelection::gather(const PositionRange& within) {
    const auto [first, end] = within;
    bool isOpen = false; // the last range
    for (std::uint32_t word = first / kBits; word <= (end - 1) / kBits; ++word) {
        std::uint64_t bits = marked_[word];
        marked_[word] = 0;
        std::uint32_t at = word * kBits;
        for (std::uint32_t left = kBits; left > 0;) {
            // Length of the run of equal bits: all marked, or none.
            const std::uint64_t others = isOpen ? ~bits : bits;
            const auto alike =
                std::min<std::uint32_t>(static_cast<std::uint32_t>(std::countr_zero(others)), left);
            at += alike;
            left -= alike;
            bits = alike < kBits ? bits >> alike : 0;
            if (left == 0)
                break;
            isOpen = !isOpen;
            if (isOpen)
                ranges_.push_back({at, at});
            else
                ranges_.back().end = at;
        }
    }
    if (isOpen)
        ranges_.back().end = end;
}

} // namespace limen::frame
