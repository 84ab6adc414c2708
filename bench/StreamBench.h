#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Flights over landblocks at 50 m/s, near radius 4, far radius 12, 60 frames a second of real time: what streaming takes of the thread
/// that draws, what of the near tier is missing, and how much memory there is. Takes two minutes.
[[nodiscard]] std::vector<BenchRow> benchStream(AllocationCounter counter);

/// The same over a data set of the user's, from the south-western end of what has ground to the north-eastern; `dat`: as engine::openWorldSource
/// takes it. The retail map takes 23 minutes a device.
[[nodiscard]] std::vector<BenchRow> benchStreamOver(const std::string& dat);

} // namespace limen::bench
