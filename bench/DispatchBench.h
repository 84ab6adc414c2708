#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures planning and submission of frames of an object field (ObjectField.h) in which 0, 1 or 100 % of
/// the objects are dynamic, compared with the classic path (classic/ClassicPath.h) on the same frames. The
/// flood is not included.
///
/// `dispatch/plan+submit`: microseconds of processor time a frame on the null device, mean over 16 headings
/// at 1280x720. A row meets its target only if a driver shows the same ids by the classic path, in 4 headings
/// at 320x180. The hash is of these ids. Without a driver the scene says so, and the hash is 0.
/// `dispatch/driver`: the same 4 headings with a driver, without a target. The scene names the driver, and
/// says whether a frame ends with the last call or with glFinish.
///
/// Takes one to two minutes with a software driver.
[[nodiscard]] std::vector<BenchRow> benchDispatch(AllocationCounter counter = nullptr);

} // namespace limen::bench
