#pragma once

#include "check/View.h"
#include "dat/Archive.h"
#include "world/Places.h"

#include <array>
#include <span>
#include <vector>

namespace limen::check {

/// A landblock as far as its size matters for sharing views out.
struct BlockSummary {
    dat::BlockCoord block;
    std::uint32_t cells = 0;
    bool hasBuildings = false;
    bool hasLandscape = false; ///< a LandBlock record, and no dungeon
};

/// The blocks of an archive that hold cells or buildings, and those with landscape next to one that has buildings;
/// ascending. Errors: a damaged index. A block whose own record is damaged counts by its cells.
[[nodiscard]] Result<std::vector<BlockSummary>> blocksOf(const dat::Archive& archive);

/// How many views of each kind; 0: not wanted.
using KindCounts = std::array<std::size_t, kKindCount>;

/// Shares a budget out among kinds: 30 parts random, 20 outside, 20 path, 28 sweep, 2 still; a wanted kind gets at least
/// one.
[[nodiscard]] KindCounts shareAmongKinds(std::size_t views, std::span<const Kind> kinds);

/// Those of `kinds` that have somewhere to stand: outside, in a block with landscape; the others, in a cell.
[[nodiscard]] std::vector<Kind> kindsWithPlaces(std::span<const Kind> kinds,
                                                std::span<const BlockSummary> blocks);

/// What is to be looked at from one block. Counts are what is asked for; legal eyes may be fewer.
struct BlockTask {
    dat::BlockCoord block;
    KindCounts counts{};       ///< of Path: the walks
    std::size_t tourViews = 0; ///< of the whole tour, 0: none of it here
    std::vector<View> given{}; ///< looked at as they are, after all others
    [[nodiscard]] std::size_t total() const;
};

/// Tasks for views that are there already, each loaded as `limen shot` would; they stay in order within a block.
[[nodiscard]] std::vector<BlockTask> tasksOf(std::span<const View> views);

/// Shares views out among blocks: random, sweep and still ones and walks by the number of cells, outside ones among
/// blocks with landscape, most to those with buildings, half of the path views along the tour where there is one.
/// Blocks without a share are left out.
[[nodiscard]] std::vector<BlockTask> planTasks(std::span<const BlockSummary> blocks,
                                               std::span<const world::Place> tour, const KindCounts& counts);

} // namespace limen::check
