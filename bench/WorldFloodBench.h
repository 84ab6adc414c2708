#pragma once

#include "BenchRow.h"

namespace limen::bench {

// Rows of `limen bench flood` on generated worlds and levels, in microseconds a view. The value of a row is
// the mean or the 99th percentile, over all views, of the views' median times. Its p95 is the mean or 99th
// percentile of the views' 95th percentiles. If a world cannot be made, the row has the error as its scene
// and misses its target.

/// `flood/fine`: 3,364 convex cells, as a complex loaded from dats and as finely cut halls. Takes about 25
/// seconds.
[[nodiscard]] std::vector<BenchRow> fineRows(AllocationCounter counter);

/// `flood/scale`: dungeons of growing size, with views that see equally many cells. Takes about 30 seconds,
/// mostly loading.
[[nodiscard]] std::vector<BenchRow> scaleRows(AllocationCounter counter);

/// `flood/town`: 64 houses with open doors, eyes in the streets and behind windows. Takes about 1 second.
[[nodiscard]] std::vector<BenchRow> townRows(AllocationCounter counter);

} // namespace limen::bench
