#pragma once

#include "BenchRow.h"

namespace limen::bench {

/// Measures the same floods through the C++ headers, the C interface and the Python module, in microseconds a view of processor
/// time. The rows ".../more" have the difference from C++, and the targets: 1 microsecond for C, 10 for Python. The times
/// of C and Python include copies of visits and seen spaces into arrays of the caller, that of C also of the regions.
///
/// A grid of 16 by 16 rooms with a zone each, 1,000 random views. The hash is of visits and seen spaces; all three ways must have
/// the same, else a row fails. Without the Python module, its rows have no value. Takes some seconds. Writes to
/// the system's temporary directory.
[[nodiscard]] std::vector<BenchRow> benchApi(AllocationCounter counter = nullptr);

} // namespace limen::bench
