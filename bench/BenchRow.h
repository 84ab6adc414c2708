#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace limen::bench {

/// One line of `limen bench`. Whether the target is met, and the ratios to what it is measured against,
/// follow from it.
struct BenchRow {
    std::string bench{}; ///< "dat/lookup"
    std::string scene{}; ///< what it ran on
    double value = 0.0;  ///< median over the repeats
    double p95 = 0.0;    ///< 95th percentile of the repeats, counted towards the worse side
    std::string unit{};
    std::vector<std::pair<std::string, double>> against{}; ///< the same measure of something known
    double target = 0.0;
    bool hasTarget = false;
    bool lowerIsBetter = true;
    std::uint64_t allocations = 0; ///< heap allocations of one repeat; 0 also where nobody counts
    std::uint64_t hash = 0;        ///< of the result: a figure counts only beside the same hash
};

/// Tells how many heap allocations the program has made so far; null where nobody counts.
using AllocationCounter = std::uint64_t (*)();

} // namespace limen::bench
