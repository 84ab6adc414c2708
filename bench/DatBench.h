#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures the `dat` room: opening a file and warm look-ups in files of 100,001 records of both block sizes,
/// and decoding of generated geometry, in payload bytes a second on one thread beside a plain copy of the
/// same bytes. Takes about two seconds; writes two files to the temporary directory and removes them.
[[nodiscard]] std::vector<BenchRow> benchDat(AllocationCounter counter = nullptr);

} // namespace limen::bench
