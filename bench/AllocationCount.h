#pragma once

#include <cstdint>

namespace limen::bench {

/// Number of heap allocations of this program through `new`. 0 in sanitizer builds, which do not count.
[[nodiscard]] std::uint64_t allocationCount();

} // namespace limen::bench
