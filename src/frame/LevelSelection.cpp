#include "frame/LevelSelection.h"

#include "core/Fetch.h"

#include <algorithm>
#include <bit>

namespace limen::frame {

namespace {

using visibility::Containment;
/// Clusters on their way to the cache while one is asked about.
constexpr std::size_t kPartsAhead = 4;
constexpr std::uint32_t kBits = 64;
constexpr std::uint64_t kAll = ~std::uint64_t{0};

} // namespace

LevelSelection::LevelSelection(const Clusters& clusters) : clusters_(clusters) {
    for (const std::uint32_t root : clusters.roots)
        roots_.push_back(root == world::kNone ? root : addParts(root, 1));
    open_.resize(parts_.size() + 1); // the last is written, and does not count
    whole_.resize(clusters.clusters.size() + 1);
    leaves_.resize(clusters.clusters.size() + 1);
    marked_.resize(clusters.order.size() / kBits + 1);
}

std::uint32_t LevelSelection::addParts(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(parts_.size());
    parts_.emplace_back().count = count;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Cluster& cluster = clusters_.clusters[first + i];
        const std::uint32_t own =
            cluster.childCount > 0 ? addParts(cluster.firstChild, cluster.childCount) : world::kNone;
        Parts& parts = parts_[index];
        parts.x[i] = cluster.bounds.centre.x;
        parts.y[i] = cluster.bounds.centre.y;
        parts.z[i] = cluster.bounds.centre.z;
        parts.radius[i] = cluster.bounds.radius;
        parts.positions[i] = {cluster.first, cluster.end};
        parts.parts[i] = own;
    }
    return index;
}

std::span<const PositionRange> LevelSelection::select(world::SpaceIndex space,
                                                      const visibility::Viewcones& cones, const Vec3& eye,
                                                      const Vec3& forward, double nearPlane) {
    ranges_.clear();
    boundsTested_ = 0;
    descend(roots_[space], cones, eye);
    for (std::size_t i = 0; i < wholeCount_; ++i)
        mark(whole_[i]);
    for (std::size_t i = 0; i < leafCount_; ++i) {
        const Parts& parts = parts_[leaves_[i].parts];
        const std::uint32_t number = leaves_[i].number;
        const Sphere bounds = parts.bounds(number);
        // What lies beyond the picture's edges shows nothing, and to ask costs more than to draw. But for what reaches behind the eye:
        // of that triangles are kept and drawn around the whole window.
        if (glm::dot(bounds.centre - eye, forward) > bounds.radius + nearPlane)
            mark(parts.positions[number]);
        else
            markLeaf(parts.positions[number], cones, eye);
    }
    if (wholeCount_ + leafCount_ > 0)
        gather(parts_[roots_[space]].positions[0]);
    return ranges_;
}

void LevelSelection::descend(std::uint32_t root, const visibility::Viewcones& cones, const Vec3& eye) {
    std::size_t openCount = 1;
    open_[0] = root;
    wholeCount_ = leafCount_ = 0;
    for (std::size_t next = 0; next < openCount; ++next) {
        const std::uint32_t index = open_[next];
        const Parts& parts = parts_[index];
        const auto found =
            cones.classifyFew({parts.x.data(), parts.y.data(), parts.z.data(), parts.radius.data()}, eye);
        boundsTested_ += parts.count;
        for (std::uint32_t i = 0; i < parts.count; ++i) {
            // What is found is written either way, and counts or does not.
            const bool isLeaf = parts.parts[i] == world::kNone;
            const bool isPartial = found[i] == Containment::Partial;
            open_[openCount] = parts.parts[i];
            leaves_[leafCount_] = {index, i};
            whole_[wholeCount_] = parts.positions[i];
            openCount += static_cast<std::size_t>(isPartial & !isLeaf);
            leafCount_ += static_cast<std::size_t>(isPartial & isLeaf);
            wholeCount_ += static_cast<std::size_t>(found[i] == Containment::Inside);
        }
        if (next + kPartsAhead < openCount)
            fetch(parts_[open_[next + kPartsAhead]]);
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
            // So many that are all marked, or all are not.
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
