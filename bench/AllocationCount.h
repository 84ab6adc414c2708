#pragma once

#include <cstdint>

namespace limen::bench {

/// How many heap allocations this program has made through `new`; 0 in sanitizer builds, where nobody counts.
[[nodiscard]] std::uint64_t allocationCount();

} // namespace limen::bench
