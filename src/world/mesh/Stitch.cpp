#include "world/mesh/Stitch.h"

#include "core/Assert.h"
#include "geometry/Segment.h"
#include "world/mesh/Weld.h"

#include <algorithm>

namespace limen::world {
namespace {

/// An inserted vertex bends its edge by up to the tolerance, so further vertices can come within reach of the
/// parts. In intact data one round is enough; the bound stops hostile data.
constexpr int kRounds = 4;
/// Longer chains are not reconciled: the number of pairs grows with the square of the length.
constexpr std::size_t kLongestChain = 64;

StitchCorner between(const StitchCorner& a, const StitchCorner& b, float t, std::uint32_t vertex) {
    return {vertex, glm::mix(a.normal, b.normal, t), glm::mix(a.front, b.front, t),
            glm::mix(a.back, b.back, t)};
}

/// Cuts a loop at every vertex that it returns to.
std::vector<StitchLoop> simpleLoops(const StitchLoop& loop) {
    std::vector<StitchLoop> loops;
    StitchLoop open;
    for (const StitchCorner& corner : loop) {
        const auto seen = std::find_if(open.begin(), open.end(),
                                       [&](const StitchCorner& c) { return c.vertex == corner.vertex; });
        if (seen == open.end()) {
            open.push_back(corner);
            continue;
        }
        if (open.end() - seen >= 3)
            loops.emplace_back(seen, open.end());
        open.erase(seen + 1, open.end());
    }
    if (open.size() >= 3)
        loops.push_back(std::move(open));
    return loops;
}

} // namespace

Stitcher::Stitcher(std::span<const Vec3> vertices) : vertices_(vertices), tree_(vertices) {}

bool Stitcher::along(const Inserted& a, const Inserted& b) {
    return a.t != b.t ? a.t < b.t : a.vertex < b.vertex;
}

std::uint64_t Stitcher::keyOf(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

bool Stitcher::force(std::uint32_t a, std::uint32_t b, std::uint32_t vertex) {
    const auto edge = edges_.find(keyOf(a, b));
    if (edge == edges_.end() || vertex == a || vertex == b)
        return false;
    std::vector<Inserted>& list = edge->second;
    if (std::any_of(list.begin(), list.end(), [&](const Inserted& i) { return i.vertex == vertex; }))
        return false;
    const Vec3 from(vertices_[std::min(a, b)]), to(vertices_[std::max(a, b)]);
    list.push_back({vertex, distanceToSegment(vertices_[vertex], from, to).t});
    std::sort(list.begin(), list.end(), along);
    return true;
}

bool Stitcher::reconcile() {
    std::vector<std::vector<std::uint32_t>> chains;
    for (const auto& [key, list] : edges_) {
        if (list.size() < 2 || list.size() > kLongestChain)
            continue;
        std::vector<std::uint32_t>& chain = chains.emplace_back();
        chain.push_back(static_cast<std::uint32_t>(key >> 32));
        for (const Inserted& i : list)
            chain.push_back(i.vertex);
        chain.push_back(static_cast<std::uint32_t>(key));
    }
    bool changed = false;
    for (const std::vector<std::uint32_t>& chain : chains) {
        for (std::size_t i = 0; i + 2 < chain.size(); ++i) {
            for (std::size_t j = i + 2; j < chain.size(); ++j)
                for (std::size_t k = i + 1; k < j; ++k)
                    changed = force(chain[i], chain[j], chain[k]) || changed;
        }
    }
    return changed;
}

const std::vector<Stitcher::Inserted>& Stitcher::onEdge(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(a, b), high = std::max(a, b);
    LIMEN_ASSERT(low < high && high < vertices_.size(), "an edge joins two vertices");
    const auto [entry, fresh] = edges_.try_emplace(keyOf(a, b));
    if (fresh) {
        const Vec3 from(vertices_[low]), to(vertices_[high]);
        near_.clear();
        tree_.nearSegment(from, to, kWeldTolerance, near_);
        for (const std::uint32_t v : near_)
            if (v != low && v != high)
                entry->second.push_back({v, distanceToSegment(vertices_[v], from, to).t});
        std::sort(entry->second.begin(), entry->second.end(), along);
    }
    return entry->second;
}

bool Stitcher::insertInto(const StitchLoop& in, StitchLoop& out) {
    out.clear();
    bool changed = false;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const StitchCorner& a = in[i];
        const StitchCorner& b = in[(i + 1) % in.size()];
        if (a.vertex == b.vertex) {
            changed = true;
            continue;
        }
        out.push_back(a);
        const std::vector<Inserted>& inserted = onEdge(a.vertex, b.vertex);
        changed = changed || !inserted.empty();
        if (a.vertex < b.vertex)
            for (const Inserted& v : inserted)
                out.push_back(between(a, b, static_cast<float>(v.t), v.vertex));
        else
            for (auto v = inserted.rbegin(); v != inserted.rend(); ++v)
                out.push_back(between(a, b, static_cast<float>(1.0 - v->t), v->vertex));
    }
    return changed;
}

std::vector<StitchLoop> Stitcher::stitch(const StitchLoop& polygon) {
    StitchLoop current = polygon, next;
    for (int round = 0; round < kRounds && insertInto(current, next); ++round)
        std::swap(current, next);
    return simpleLoops(current);
}

} // namespace limen::world
