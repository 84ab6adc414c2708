#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Flights over landblocks at 50 m/s, near radius 4, far radius 12, 60 frames a second of real time: what streaming takes of the thread
/// that draws, what of the near tier is missing, and how much memory there is. Takes two minutes.
[[nodiscard]] std::vector<BenchRow> benchStream(AllocationCounter counter);

} // namespace limen::bench
