#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace limen::bench {

/// One row of `limen bench`. BenchTable.h derives the ratio and whether the target is met.
struct BenchRow {
    std::string bench{}; ///< "dat/lookup"
    std::string scene{}; ///< data and conditions of the measurement
    double value = 0.0;  ///< median over the repeats
    double p95 = 0.0;    ///< 95th percentile of the repeats, counted towards the worse side
    std::string unit{};
    std::vector<std::pair<std::string, double>> against{}; ///< the same quantity of the systems compared with
    double target = 0.0;
    bool hasTarget = false;
    bool lowerIsBetter = true;
    std::uint64_t allocations = 0; ///< heap allocations of one repeat; 0 if they are not counted
    std::uint64_t hash = 0;        ///< of the result; figures are comparable only if their hashes are equal
};

/// The value of a figure that was not measured.
inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// Size of the drawn pictures, pixels.
inline constexpr std::uint32_t kFrameWidth = 1280, kFrameHeight = 720;

/// A row that misses its target because the benchmark failed. `scene` ends with the reason.
[[nodiscard]] BenchRow failedRow(std::string bench, std::string scene, std::string unit);

/// Returns the number of heap allocations so far. Null: they are not counted.
using AllocationCounter = std::uint64_t (*)();

} // namespace limen::bench
