#include "WorldFloodBench.h"

#include "GeneratedWorlds.h"
#include "HallScene.h"
#include "PathFlood.h"
#include "ViewTimes.h"

#include "core/Assert.h"
#include "frame/WorldGraph.h"
#include "visibility/Flood.h"

#include <fmt/format.h>
#include <limits>
#include <map>
#include <optional>

namespace limen::bench {

namespace {

using visibility::View;
using Against = std::vector<std::pair<std::string, double>>;

constexpr std::uint32_t kWorldSeed = 1;

/// Microseconds a view of a well-known shooter's flood, on an arena level of 3,364 cells and 9,705 openings.
constexpr double kKnownMean = 1200.0, kKnownWorst = 13700.0;
/// Targets in microseconds a view.
struct FineTargets {
    double mean, worst;
};
constexpr FineTargets kFine{100.0, 800.0}, kFineApart{400.0, 3000.0};
constexpr double kMostInTown = 60.0;

BenchRow rowOf(const char* bench, std::string scene, const ViewTimes& times, std::optional<double> target) {
    BenchRow row{bench, std::move(scene), 0.0, 0.0, "us"};
    row.target = target.value_or(0.0);
    row.hasTarget = target.has_value();
    row.allocations = times.allocations;
    row.hash = times.hash;
    return row;
}

BenchRow meanRow(const char* bench, const std::string& scene, const ViewTimes& times,
                 std::optional<double> target) {
    BenchRow row = rowOf(bench, scene + ", mean", times, target);
    row.value = meanOf(times.median);
    row.p95 = meanOf(times.p95);
    return row;
}

BenchRow worstRow(const char* bench, const std::string& scene, const ViewTimes& times,
                  std::optional<double> target) {
    BenchRow row = rowOf(bench, scene + ", p99", times, target);
    row.value = quantileOf(times.median, 0.99);
    row.p95 = quantileOf(times.p95, 0.99);
    return row;
}

visibility::Graph graphOf(const world::World& world) {
    Result<visibility::Graph> graph = frame::visibilityGraph(world);
    LIMEN_ASSERT(graph.has_value(), "a loaded world is a valid graph");
    return std::move(*graph);
}

/// Microseconds of one path flood from each view.
std::vector<double> pathTimes(const FloodScene& scene) {
    PathFlood naive;
    std::vector<double> times;
    for (const View& view : scene.views)
        times.push_back(secondsOf([&] { naive.run(scene.graph, view); }) * 1e6);
    return times;
}

void addFineRows(const FloodScene& scene, const FineTargets& targets, AllocationCounter counter,
                 std::vector<BenchRow>& rows) {
    const ViewTimes times = timeViews(scene.graph, scene.views, {3, 1}, counter);
    const std::vector<double> paths = pathTimes(scene);
    rows.push_back(meanRow("flood/fine", scene.name, times, targets.mean));
    rows.back().against = {{"path flood", meanOf(paths)}, {"edge-plane engine (known, arena)", kKnownMean}};
    rows.push_back(worstRow("flood/fine", scene.name, times, targets.worst));
    rows.back().against = {{"path flood", quantileOf(paths, 0.99)},
                           {"edge-plane engine (known, arena)", kKnownWorst}};
}

std::size_t seenFrom(const visibility::Graph& graph, const View& view, visibility::FloodScratch& scratch,
                     visibility::VisibleSet& set) {
    LIMEN_ASSERT(visibility::flood(graph, {}, view, {}, scratch, set), "the views of a bench are valid");
    return set.seen.size();
}

/// Numbers of views by the number of spaces that they see.
using SeenCounts = std::map<std::size_t, std::size_t>;

SeenCounts countSeen(const visibility::Graph& graph, const std::vector<View>& views) {
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    SeenCounts counts;
    for (const View& view : views)
        ++counts[seenFrom(graph, view, scratch, set)];
    return counts;
}

/// Chooses views from `candidates` whose numbers of seen spaces are distributed as in `wanted`.
std::vector<View> viewsThatSee(const visibility::Graph& graph, SeenCounts wanted,
                               const std::vector<View>& candidates) {
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    std::vector<View> views;
    for (const View& view : candidates) {
        const auto found = wanted.find(seenFrom(graph, view, scratch, set));
        if (found != wanted.end() && found->second > 0) {
            --found->second;
            views.push_back(view);
        }
    }
    return views;
}

} // namespace

std::vector<BenchRow> fineRows(AllocationCounter counter) {
    constexpr std::size_t kViews = 500;
    std::vector<BenchRow> rows;
    HallSpec halls;
    halls.views = kViews;
    for (const bool merged : {true, false}) {
        halls.merged = merged;
        addFineRows(hallScene(halls), merged ? kFine : kFineApart, counter, rows);
    }
    Result<world::World> world = generatedWorld({worlds::GeneratedKind::Complex, halls.cells, 3, 0.0});
    if (!world) {
        rows.push_back(failedRow("flood/fine", world.error().message(), "us"));
        return rows;
    }
    const std::vector<View> views = viewsInCells(*world, kViews, kWorldSeed);
    const std::string name = fmt::format("complex of {} cells, {} openings, ", world->spaces.size() - 1,
                                         world->portals.size() / 2);
    addFineRows({fmt::format("{}{} zones as loaded", name, world->zones.size()), graphOf(*world), views},
                kFine, counter, rows);
    addFineRows({name + "every cell a zone", graphOf(apart(std::move(*world))), views}, kFineApart, counter,
                rows);
    return rows;
}

std::vector<BenchRow> scaleRows(AllocationCounter counter) {
    constexpr std::size_t kViews = 1000;
    std::vector<BenchRow> rows;
    SeenCounts wanted;
    for (const std::uint32_t size : {1000u, 10000u, 100000u}) {
        const Result<world::World> world =
            generatedWorld({worlds::GeneratedKind::Dungeon, size, kWorldSeed, 0.02});
        if (!world) {
            rows.push_back(failedRow("flood/scale", world.error().message(), "us"));
            continue;
        }
        const visibility::Graph graph = graphOf(*world);
        const bool first = wanted.empty();
        std::vector<View> views = viewsInCells(*world, first ? kViews : 8 * kViews, kWorldSeed);
        if (first)
            wanted = countSeen(graph, views);
        else
            views = viewsThatSee(graph, wanted, views);
        const ViewTimes times = timeViews(graph, views, {15, 16}, counter);
        const std::string scene =
            fmt::format("dungeon of {} cells, {} loaded, {} views that see {:.2f} cells", size,
                        world->spaces.size() - 1, views.size(), times.meanSeen);
        rows.push_back(meanRow("flood/scale", scene, times,
                               rows.empty() ? std::nullopt : std::optional(1.1 * rows.front().value)));
        if (rows.size() > 1)
            rows.back().against = {{"the smallest", rows.front().value}};
    }
    return rows;
}

std::vector<BenchRow> townRows(AllocationCounter counter) {
    constexpr std::size_t kViews = 1000;
    const Result<world::World> world = generatedWorld({worlds::GeneratedKind::Town, 64, kWorldSeed, 0.0});
    if (!world)
        return {failedRow("flood/town", world.error().message(), "us")};
    const visibility::Graph graph = graphOf(*world);
    const std::string name =
        fmt::format("64 houses, {} building portals, ", world->spaces[world::kOutside].portalCount);
    std::vector<BenchRow> rows;
    const auto add = [&](const std::string& where, const std::vector<View>& views) {
        const ViewTimes times = timeViews(graph, views, {15, 1}, counter);
        rows.push_back(meanRow("flood/town", name + where, times, kMostInTown));
        rows.push_back(worstRow("flood/town", name + where, times, std::nullopt));
    };
    add("eye in the street", viewsOutdoors(*world, kViews, kWorldSeed));
    add("eye at a window", viewsAtWindows(*world, kViews, kWorldSeed));
    return rows;
}

} // namespace limen::bench
