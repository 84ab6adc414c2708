#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Counts the GL calls of frames with ids on the null device, which counts the calls that a driver would get.
/// A row has the largest number of its frames and the hash of all numbers. It fails if frames with equal
/// stages and batches differ.
///
/// `calls/tour` and `calls/tour/fast`: all way points and named places of the built-in world, four headings
/// each, with doors as loaded, closed and open, in both ways of drawing. `calls/objects`: the field of 100,000 objects of `limen bench dispatch`, 16
/// headings, beside the classic path.
///
/// Takes about two minutes. Writes the built-in world to the system's temporary directory and removes it.
[[nodiscard]] std::vector<BenchRow> benchCalls(AllocationCounter counter = nullptr);

} // namespace limen::bench
