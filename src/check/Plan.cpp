#include "check/Plan.h"

#include "check/views/Views.h"
#include "world/Loader.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>

namespace limen::check {

namespace {

constexpr std::array<std::size_t, kKindCount> kParts{30, 20, 20, 28,
                                                     2,  28, 20, 20}; ///< shares of the kinds, by ViewKind

/// Outside views of a block with buildings for each one of a block without: pictures go wrong at openings,
/// and every block costs a load.
constexpr std::uint64_t kBuiltWeight = 12;

/// Distributes `amount` by weight and calls take(i, share). The shares add up to it unless all weights are 0.
template <class Take>
void shareOut(std::size_t amount, std::span<const std::uint64_t> weights, Take take) {
    const std::uint64_t all = std::accumulate(weights.begin(), weights.end(), std::uint64_t{0});
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < weights.size() && all > 0; ++i) {
        const std::uint64_t after = before + weights[i];
        take(i, static_cast<std::size_t>(amount * after / all - amount * before / all));
        before = after;
    }
}

bool isNeighbour(dat::BlockCoord a, dat::BlockCoord b) {
    return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1;
}

} // namespace

Result<std::vector<BlockSummary>> blocksOf(const dat::Archive& archive) {
    std::map<dat::RecordId, BlockSummary> all;
    const Result<void> read = archive.cell().forEach([&](const dat::Entry& entry) {
        if (entry.id == dat::kIterationId)
            return true;
        BlockSummary& summary = all[entry.id & 0xFFFF0000u];
        summary.block = dat::blockOf(entry.id);
        const std::uint32_t low = entry.id & 0xFFFFu;
        if (low == 0xFFFFu)
            summary.hasLandscape = true;
        else if (low == 0xFFFEu) {
            const auto info = archive.load<dat::LandBlockInfo>(entry.id);
            summary.hasBuildings = info && !info->buildings.empty();
        } else if (low >= dat::kFirstCell)
            ++summary.cells;
        return true;
    });
    if (!read)
        return Failure(read.error());
    std::vector<BlockSummary> built, blocks;
    for (auto& [word, summary] : all) {
        summary.hasLandscape = summary.hasLandscape && !world::isDungeon(archive, summary.block);
        if (summary.hasBuildings)
            built.push_back(summary);
    }
    for (const auto& [word, found] : all) {
        const BlockSummary& summary = found; // Clang 14 lets no lambda capture a structured binding
        const bool near =
            summary.hasLandscape && std::any_of(built.begin(), built.end(), [&](const auto& other) {
                return isNeighbour(summary.block, other.block);
            });
        if (summary.cells > 0 || summary.hasBuildings || near)
            blocks.push_back(summary);
    }
    return blocks;
}

KindCounts shareAmongKinds(std::size_t views, std::span<const ViewKind> kinds) {
    std::array<std::uint64_t, kKindCount> weights{};
    for (const ViewKind kind : kinds)
        weights[static_cast<std::size_t>(kind)] = kParts[static_cast<std::size_t>(kind)];
    KindCounts counts{};
    shareOut(views, weights, [&](std::size_t i, std::size_t share) {
        counts[i] = weights[i] > 0 ? std::max<std::size_t>(share, 1) : 0;
    });
    return counts;
}

std::vector<ViewKind> kindsWithPlaces(std::span<const ViewKind> kinds, std::span<const BlockSummary> blocks) {
    std::vector<ViewKind> placed;
    std::copy_if(kinds.begin(), kinds.end(), std::back_inserter(placed), [&](ViewKind kind) {
        return std::any_of(blocks.begin(), blocks.end(), [&](const BlockSummary& block) {
            return kind == ViewKind::Outside ? block.hasLandscape : block.cells > 0;
        });
    });
    return placed;
}

std::size_t BlockTask::total() const {
    return std::accumulate(counts.begin(), counts.end(), given.size());
}

std::vector<BlockTask> tasksOf(std::span<const View> views) {
    std::map<std::uint32_t, BlockTask> byBlock;
    for (const View& view : views) {
        const dat::BlockCoord block = centreOf(view);
        BlockTask& task =
            byBlock.try_emplace(dat::blockWord(block), BlockTask{block, {}, 0, {}}).first->second;
        task.given.push_back(view);
    }
    std::vector<BlockTask> tasks;
    tasks.reserve(byBlock.size());
    for (auto& [word, task] : byBlock)
        tasks.push_back(std::move(task));
    return tasks;
}

std::vector<BlockTask> planTasks(std::span<const BlockSummary> blocks, std::span<const world::Place> tour,
                                 const KindCounts& counts) {
    std::vector<std::uint64_t> byCells, byLandscape;
    std::vector<BlockTask> tasks;
    for (const BlockSummary& block : blocks) {
        byCells.push_back(block.cells);
        byLandscape.push_back(!block.hasLandscape ? 0 : block.hasBuildings ? kBuiltWeight : 1);
        tasks.push_back({block.block, {}, 0});
    }
    KindCounts shared = counts;
    const std::size_t path = static_cast<std::size_t>(ViewKind::Path);
    const std::size_t tourViews = tour.size() < 2 ? 0 : counts[path] / 2;
    shared[path] -= tourViews;
    for (std::size_t kind = 0; kind < kKindCount; ++kind) {
        const bool outside = static_cast<ViewKind>(kind) == ViewKind::Outside;
        shareOut(shared[kind], outside ? byLandscape : byCells,
                 [&](std::size_t i, std::size_t share) { tasks[i].counts[kind] = share; });
    }
    for (BlockTask& task : tasks)
        task.tourViews = tourPointsIn(tour, tourViews, task.block) > 0 ? tourViews : 0;
    std::erase_if(tasks, [](const BlockTask& task) { return task.total() + task.tourViews == 0; });
    return tasks;
}

} // namespace limen::check
