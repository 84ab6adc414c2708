#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace limen::viewer {

/// A sliding window over the values of the last seconds.
class TimeWindow {
public:
    /// Keeps values younger than `seconds`.
    explicit TimeWindow(double seconds = 5.0) : seconds_(seconds) {}

    /// Adds a value at time `now`, seconds; `now` never decreases. NaN, from timers without a result yet, is
    /// ignored.
    void add(double now, double value);

    /// Median and 95th percentile; NaN without values.
    [[nodiscard]] double median() const { return quantile(0.5); }
    [[nodiscard]] double p95() const { return quantile(0.95); }
    [[nodiscard]] std::size_t count() const { return samples_.size(); }
    /// The value at `index`, 0..count()-1, oldest first.
    [[nodiscard]] double value(std::size_t index) const { return samples_[index].value; }

private:
    struct Sample {
        double time = 0.0, value = 0.0;
    };
    /// The smallest value that at least a share `q` of all values do not exceed.
    [[nodiscard]] double quantile(double q) const;

    double seconds_;
    std::deque<Sample> samples_;           ///< the oldest first
    mutable std::vector<double> sorted_{}; ///< scratch
};

} // namespace limen::viewer
