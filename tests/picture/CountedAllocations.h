#pragma once

#include <cstddef>

namespace limen::test {

/// Heap allocations of this program so far, through `new`. Of test programs that link CountedAllocations.cpp.
[[nodiscard]] std::size_t allocations();

} // namespace limen::test
