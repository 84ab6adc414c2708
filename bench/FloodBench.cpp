#include "FloodBench.h"

#include "FloodScenes.h"
#include "PathFlood.h"
#include "Stopwatch.h"
#include "ViewTimes.h"
#include "WorldFloodBench.h"
#include "core/Assert.h"

#include "visibility/Flood.h"

namespace limen::bench {
namespace {

constexpr int kRepeats = 31;
constexpr std::uint32_t kSeed = 1;

/// Microseconds a view on the same grids, of the flood of a well-known 1990s engine and of a portal-zone
/// scene manager. Source: docs/performance.md.
struct Known {
    int columns, rows;
    double door;
    double edgePlaneFlood, sceneManager;
};
constexpr Known kScenes[] = {
    {8, 8, 2.0, 1.9, 8.0},     {16, 16, 2.0, 3.1, 24.0}, {32, 32, 2.0, 6.4, 67.0},
    {16, 16, 6.0, 10.2, 90.0}, {64, 1, 2.0, 1.8, 15.0},
};

BenchRow rowFor(const char* name, const FloodScene& scene, const Known& known, AllocationCounter counter) {
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    const Samples ours = measure(kRepeats, counter, [&] {
        for (const visibility::View& view : scene.views)
            LIMEN_ASSERT(visibility::flood(scene.graph, {}, view, {}, scratch, set),
                         "the views of a bench are valid");
    });
    PathFlood naive;
    const Samples plain = measure(kRepeats, nullptr, [&] {
        for (const visibility::View& view : scene.views)
            naive.run(scene.graph, view);
    });
    const double perView = 1e6 / static_cast<double>(scene.views.size());
    BenchRow row{name, scene.name, ours.quantile(0.5) * perView, ours.quantile(0.95) * perView, "us"};
    row.against = {{"path flood", plain.quantile(0.5) * perView},
                   {"edge-plane engine (known)", known.edgePlaneFlood},
                   {"scene manager (known)", known.sceneManager}};
    row.target = known.edgePlaneFlood;
    row.hasTarget = true;
    row.allocations = ours.allocations;
    for (const visibility::View& view : scene.views) {
        LIMEN_ASSERT(visibility::flood(scene.graph, {}, view, {}, scratch, set),
                     "the views of a bench are valid");
        row.hash = hashOf(set, row.hash);
    }
    return row;
}

} // namespace

std::vector<BenchRow> benchFlood(AllocationCounter counter) {
    std::vector<BenchRow> rows;
    for (const Known& known : kScenes) {
        rows.push_back(
            rowFor("flood/rooms", roomGrid(known.columns, known.rows, known.door, kSeed), known, counter));
    }
    for (const Known& known : kScenes) {
        rows.push_back(rowFor("flood/rooms", roomGridApart(known.columns, known.rows, known.door, kSeed),
                              known, counter));
    }
    for (const auto& more : {fineRows(counter), scaleRows(counter), townRows(counter)})
        rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

} // namespace limen::bench
