#pragma once

#include "FloodScenes.h"
#include "Stopwatch.h"

#include "core/Hash.h"
#include "visibility/VisibleSet.h"

#include <span>

namespace limen::bench {

/// Times of floods from many views, in microseconds. Each view is timed separately and repeatedly, so that
/// the median hides interruptions by other programs.
struct ViewTimes {
    std::vector<double> median;    ///< by view, over the repeats
    std::vector<double> p95;       ///< by view, over the repeats
    std::uint64_t allocations = 0; ///< of one pass over all views after the warm-up
    std::uint64_t hash = 0;        ///< of the visible sets of all views
    double meanSeen = 0.0;         ///< mean number of seen spaces a view, counted once for each visit
    double meanVisits = 0.0;
};

/// Numbers of repetitions for the timing of a flood.
struct Effort {
    int repeats = 5;
    int floodsEach =
        1; ///< floods between two readings of the clock; more than 1 for floods of less than a microsecond
};

/// Floods several times in a row from each view. The first two floods warm up, as in a session whose eye
/// hardly moves from frame to frame.
[[nodiscard]] ViewTimes timeViews(const visibility::Graph& graph, std::span<const visibility::View> views,
                                  const Effort& effort, AllocationCounter counter);

/// Mean of the values.
[[nodiscard]] double meanOf(std::span<const double> values);
/// The q-quantile of the values, 0 <= q <= 1.
[[nodiscard]] double quantileOf(std::span<const double> values, double q);

/// Adds a flood's spaces, visits and regions to a hash.
[[nodiscard]] std::uint64_t hashOf(const visibility::VisibleSet& set, std::uint64_t sofar);

} // namespace limen::bench
