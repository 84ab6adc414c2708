#pragma once

#include "Stopwatch.h"
#include "api/House.h"

#include <optional>

namespace limen::bench {

/// Floods of all eyes of a house through one interface.
struct FloodTimes {
    Samples samples;        ///< processor time of all eyes, for each repeat
    std::uint64_t hash = 0; ///< of visits and seen spaces
};

[[nodiscard]] FloodTimes floodThroughCpp(const House& house, int repeats, AllocationCounter counter);
[[nodiscard]] Result<FloodTimes> floodThroughC(const House& house, int repeats, AllocationCounter counter);
/// In a process of its own: bench/api/flood.py with Debian's Python. Empty: there is no module `limen`. Errors: the process fails.
[[nodiscard]] Result<std::optional<FloodTimes>> floodThroughPython(const House& house, int repeats);

} // namespace limen::bench
