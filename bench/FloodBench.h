#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures visibility::flood on the room grids and the corridor of docs/performance.md, 1,000 random views
/// each, in microseconds a view, beside the plain path flood on the same views and two figures known from
/// elsewhere. The hash is of the spaces seen and the visits' regions. Every grid is measured merged into one
/// zone, as it would be loaded, and with every room a zone of its own. Takes about ten seconds.
[[nodiscard]] std::vector<BenchRow> benchFlood(AllocationCounter counter = nullptr);

} // namespace limen::bench
