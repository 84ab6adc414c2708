#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Flights over landblocks at 50 m/s with near radius 4 and far radius 12, at 60 frames a second of real
/// time. Measures the time that streaming takes of the drawing thread, frames with blocks missing in the near
/// tier, and memory. Takes two minutes.
[[nodiscard]] std::vector<BenchRow> benchStream(AllocationCounter counter);

/// The same measurement over a data set of the user, from the south-western to the north-eastern end of the
/// ground. `dat`: a directory, as for engine::openWorldSource. The retail map takes 23 minutes a device.
[[nodiscard]] std::vector<BenchRow> benchStreamOver(const std::string& dat);

/// The same flights over a world with as many placed objects as the published database. The first makes its own world; the
/// second writes a world.db of made-up objects beside the files at `dat` if there is none.
[[nodiscard]] std::vector<BenchRow> benchPlaced(AllocationCounter counter);
[[nodiscard]] std::vector<BenchRow> benchPlacedOver(const std::string& dat);

} // namespace limen::bench
