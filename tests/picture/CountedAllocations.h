#pragma once

#include <cstddef>

namespace limen::test {

/// Number of heap allocations by `new` so far, in programs that link CountedAllocations.cpp.
[[nodiscard]] std::size_t allocations();

} // namespace limen::test
