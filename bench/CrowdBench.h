#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// 200 people of a world database around one place of the built-in world, all in the picture: processor time of the dynamic
/// state, the flood and the plan of a frame, less the same without them. `crowd/planning` has the flood and the plan,
/// `crowd/state` the dynamic state. Needs no driver.
[[nodiscard]] std::vector<BenchRow> benchCrowd(AllocationCounter counter = nullptr);

} // namespace limen::bench
