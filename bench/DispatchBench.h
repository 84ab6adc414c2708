#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures planning and submitting a frame of a field of objects (ObjectField.h), of which none, one in a hundred or all move,
/// beside the classic path (classic/ClassicPath.h) on the same frames. The flood is no part of it.
///
/// `dispatch/plan+submit`: microseconds of processor time a frame on the null device, mean over 16 headings at 1280x720. A row
/// meets its target only if the classic path shows the same ids with a driver, 4 headings at 320x180; the hash is of these. Where no
/// driver can be had, the scene says so and the hash is 0.
/// `dispatch/driver`: the same 4 headings with a driver, no target; the scene tells the driver, and whether a frame ends with the
/// last call or with glFinish.
///
/// Takes a minute or two with a software driver.
[[nodiscard]] std::vector<BenchRow> benchDispatch(AllocationCounter counter = nullptr);

} // namespace limen::bench
