#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures the room `dat`: opening of a file and warm look-ups, in files of 100,001 records with both block
/// sizes; and decoding of generated geometry on one thread, in payload bytes a second, compared with a plain
/// copy of the same bytes. Takes about two seconds. Writes two files to the temporary directory and removes
/// them.
[[nodiscard]] std::vector<BenchRow> benchDat(AllocationCounter counter = nullptr);

} // namespace limen::bench
