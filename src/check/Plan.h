#pragma once

#include "check/View.h"
#include "dat/Archive.h"
#include "world/Places.h"

#include <array>
#include <span>
#include <vector>

namespace limen::check {

/// The properties of a landblock that decide its share of views.
struct BlockSummary {
    dat::BlockCoord block;
    std::uint32_t cells = 0;
    bool hasBuildings = false;
    bool hasLandscape = false; ///< a LandBlock record that is no dungeon
};

/// The blocks of an archive with cells or buildings, and the landscape blocks next to one with buildings;
/// ascending. A block whose own record is damaged counts by its cells. Errors: a damaged index.
[[nodiscard]] Result<std::vector<BlockSummary>> blocksOf(const dat::Archive& archive);

/// The number of views of each kind; 0: none.
using KindCounts = std::array<std::size_t, kKindCount>;

/// Distributes a number of views among kinds: 30 parts random, 20 outside, 20 path, 28 sweep, 2 still, 28 straddle, 20 telephoto, 20 wide. Each
/// kind of `kinds` gets at least one.
[[nodiscard]] KindCounts shareAmongKinds(std::size_t views, std::span<const ViewKind> kinds);

/// The kinds that have viewpoints in the blocks: Outside needs a landscape, the others need a cell.
[[nodiscard]] std::vector<ViewKind> kindsWithPlaces(std::span<const ViewKind> kinds,
                                                    std::span<const BlockSummary> blocks);

/// The views of one block. Counts are upper bounds: there may be fewer legal viewpoints.
struct BlockTask {
    dat::BlockCoord block;
    KindCounts counts{};       ///< of Path: the walks
    std::size_t tourViews = 0; ///< of the whole tour; 0: no point of it is in this block
    std::vector<View> given{}; ///< views that are checked unchanged, after all others
    [[nodiscard]] std::size_t total() const;
};

/// Tasks for given views, each loaded as by `limen shot`. Views of one block stay in order.
[[nodiscard]] std::vector<BlockTask> tasksOf(std::span<const View> views);

/// Distributes views among blocks. Random, sweep and still views and walks follow the number of cells;
/// outside views go to blocks with landscape, most of them to those with buildings; half of the path views
/// follow the tour, if there is one. Blocks without views are left out.
[[nodiscard]] std::vector<BlockTask> planTasks(std::span<const BlockSummary> blocks,
                                               std::span<const world::Place> tour, const KindCounts& counts);

} // namespace limen::check
