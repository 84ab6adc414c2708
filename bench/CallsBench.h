#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Counts the GL calls of frames with ids, by the null device, which counts what a driver would get. Each row is the largest
/// number of its frames, has the hash of all of them, and fails if frames with the same stages and batches differ.
///
/// `calls/tour`: from every way point and named place of the built-in world, four headings each, doors at rest, shut and open.
/// `calls/objects`: the field of 100,000 objects of `limen bench dispatch`, 16 headings, beside the classic path.
///
/// Takes about a minute; writes the built-in world to the system's temporary directory meanwhile.
[[nodiscard]] std::vector<BenchRow> benchCalls(AllocationCounter counter = nullptr);

} // namespace limen::bench
