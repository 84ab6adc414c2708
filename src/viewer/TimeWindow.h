#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace limen::viewer {

/// Figures of the last few seconds.
class TimeWindow {
public:
    /// Keeps what is less than `seconds` old.
    explicit TimeWindow(double seconds = 5.0) : seconds_(seconds) {}

    /// `now` never decreases, seconds. Values that are no numbers, of clocks that have not answered yet, are left out.
    void add(double now, double value);

    /// Of the values that are kept; NaN if there are none.
    [[nodiscard]] double median() const { return quantile(0.5); }
    [[nodiscard]] double p95() const { return quantile(0.95); }
    [[nodiscard]] std::size_t count() const { return samples_.size(); }
    /// The one that was added as the `index`-th of those that are kept, 0..count()-1.
    [[nodiscard]] double value(std::size_t index) const { return samples_[index].value; }

private:
    struct Sample {
        double time = 0.0, value = 0.0;
    };
    /// The smallest value that a share `q` of all do not exceed.
    [[nodiscard]] double quantile(double q) const;

    double seconds_;
    std::deque<Sample> samples_;           ///< the oldest first
    mutable std::vector<double> sorted_{}; ///< scratch
};

} // namespace limen::viewer
