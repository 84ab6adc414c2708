#include "ViewTimes.h"

#include "core/Assert.h"
#include "visibility/Flood.h"

#include <numeric>

namespace limen::bench {

ViewTimes timeViews(const visibility::Graph& graph, std::span<const visibility::View> views,
                    const Effort& effort, AllocationCounter counter) {
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    ViewTimes out;
    out.median.reserve(views.size());
    out.p95.reserve(views.size());
    double seen = 0.0, visits = 0.0;
    for (const visibility::View& view : views) {
        const Samples samples = measure(effort.repeats, nullptr, [&] {
            for (int i = 0; i < effort.floodsEach; ++i)
                LIMEN_ASSERT(visibility::flood(graph, {}, view, {}, scratch, set),
                             "the views of a bench are valid");
        });
        out.median.push_back(samples.quantile(0.5) * 1e6 / effort.floodsEach);
        out.p95.push_back(samples.quantile(0.95) * 1e6 / effort.floodsEach);
        out.hash = hashOf(set, out.hash);
        seen += static_cast<double>(set.seen.size());
        visits += static_cast<double>(set.visits.size());
    }
    out.meanSeen = seen / static_cast<double>(views.size());
    out.meanVisits = visits / static_cast<double>(views.size());
    // Two passes: the flood swaps buffers, so the first pass can leave some of them too small.
    for (int pass = 0; pass < 2; ++pass) {
        const std::uint64_t before = counter ? counter() : 0;
        for (const visibility::View& view : views)
            LIMEN_ASSERT(visibility::flood(graph, {}, view, {}, scratch, set),
                         "the views of a bench are valid");
        out.allocations = counter ? counter() - before : 0;
    }
    return out;
}

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantileOf(std::span<const double> values, double q) {
    return Samples{{values.begin(), values.end()}, 0}.quantile(q);
}

std::uint64_t hashOf(const visibility::VisibleSet& set, std::uint64_t sofar) {
    Hash hash;
    hash.add(sofar);
    for (const visibility::SeenSpace& s : set.seen) {
        hash.add(s.space);
        hash.add(s.visit);
    }
    for (const visibility::Visit& v : set.visits)
        hash.add(v.portal);
    for (const Vec3& v : set.regionVertices)
        hash.add(v);
    return hash.value();
}

} // namespace limen::bench
