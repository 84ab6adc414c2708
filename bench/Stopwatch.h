#pragma once

#include "BenchRow.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <span>

namespace limen::bench {

/// Repeats of one measurement, in seconds.
struct Samples {
    std::vector<double> seconds;
    std::uint64_t allocations = 0; ///< of the last repeat

    [[nodiscard]] double quantile(double q) const {
        std::vector<double> sorted = seconds;
        std::sort(sorted.begin(), sorted.end());
        return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1) + 0.5)];
    }
};

/// Wall-clock seconds that `work` takes.
template <class Work>
[[nodiscard]] double secondsOf(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Processor time of this thread in seconds. Time taken by other programs does not count.
[[nodiscard]] inline double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of all threads of this program in seconds, those of a software rasteriser included.
[[nodiscard]] inline double processSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Runs `work` twice to warm up, then times `repeats` runs.
template <class Work>
[[nodiscard]] Samples measure(int repeats, AllocationCounter counter, Work&& work) {
    for (int i = 0; i < 2; ++i)
        work();
    Samples out;
    out.seconds.reserve(static_cast<std::size_t>(repeats));
    for (int i = 0; i < repeats; ++i) {
        const std::uint64_t before = counter ? counter() : 0;
        out.seconds.push_back(secondsOf(work));
        out.allocations = counter ? counter() - before : 0;
    }
    return out;
}

} // namespace limen::bench
