#pragma once

#include "FloodScenes.h"
#include "Stopwatch.h"

#include "core/Hash.h"
#include "visibility/VisibleSet.h"

#include <span>

namespace limen::bench {

/// What a flood costs from each of many views, in microseconds. Every view is timed by itself, several times over, so that what
/// else the machine does can be told from what a view costs.
struct ViewTimes {
    std::vector<double> median;    ///< by view, over the repeats
    std::vector<double> p95;       ///< by view, over the repeats
    std::uint64_t allocations = 0; ///< of one warm pass over all views
    std::uint64_t hash = 0;        ///< of what is seen from all of them
    double meanSeen = 0.0;         ///< spaces a view, each counted once a visit
    double meanVisits = 0.0;
};

/// How often a flood is repeated to time it.
struct Effort {
    int repeats = 5;
    int floodsEach = 1; ///< in a row under one reading of the clock: for floods of less than a microsecond
};

/// Floods from every view several times in a row, the first two to warm up, as a session does whose eye hardly moves from frame
/// to frame.
[[nodiscard]] ViewTimes timeViews(const visibility::Graph& graph, std::span<const visibility::View> views,
                                  const Effort& effort, AllocationCounter counter);

/// Mean of a value a view.
[[nodiscard]] double meanOf(std::span<const double> values);
/// The value that all but a share of 1 - q of them stay below.
[[nodiscard]] double quantileOf(std::span<const double> values, double q);

/// Folds what a flood yields, spaces, visits and regions, into a hash.
[[nodiscard]] std::uint64_t hashOf(const visibility::VisibleSet& set, std::uint64_t sofar);

} // namespace limen::bench
