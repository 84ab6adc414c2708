#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures visibility::flood in microseconds a view: on the room grids and the corridor of docs/performance.md, 1,000 random
/// views each, beside the plain path flood on the same views and two figures known from elsewhere, every grid merged into one
/// zone, as it would be loaded, and with every room a zone of its own; and on what WorldFloodBench.h names. The hash is of the
/// spaces seen and the visits' regions. Takes about 45 seconds; writes worlds to the system's temporary directory meanwhile.
[[nodiscard]] std::vector<BenchRow> benchFlood(AllocationCounter counter = nullptr);

} // namespace limen::bench
