#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures visibility::flood in microseconds a view.
/// - The room grids and the corridor of docs/performance.md, 1,000 random views each, compared with the path
///   flood on the same views and with two published figures. Each grid is measured as one zone, as the loader
///   merges it, and with a zone for each room.
/// - The rows of WorldFloodBench.h.
///
/// The hash is of the spaces seen and of the visits' regions. Takes about 45 seconds. Writes worlds to the
/// system's temporary directory and removes them.
[[nodiscard]] std::vector<BenchRow> benchFlood(AllocationCounter counter = nullptr);

} // namespace limen::bench
