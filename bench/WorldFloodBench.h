#pragma once

#include "BenchRow.h"

namespace limen::bench {

// Rows of `limen bench flood` on generated worlds and levels, microseconds a view. A row of a mean or of a 99th percentile over
// views is made of each view's median time; its p95 is the same of each view's 95th percentile. A world that cannot be made
// yields a row that says so and meets no target.

/// `flood/fine`: 3,364 convex cells; a complex loaded from dats, and halls cut finely. About 25 seconds.
[[nodiscard]] std::vector<BenchRow> fineRows(AllocationCounter counter);

/// `flood/scale`: dungeons of growing size, views that see alike many cells. About 30 seconds, nearly all of it loading.
[[nodiscard]] std::vector<BenchRow> scaleRows(AllocationCounter counter);

/// `flood/town`: 64 houses, eyes in the streets and behind windows, every door open. About 1 second.
[[nodiscard]] std::vector<BenchRow> townRows(AllocationCounter counter);

} // namespace limen::bench
