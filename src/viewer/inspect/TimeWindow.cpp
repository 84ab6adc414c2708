#include "viewer/inspect/TimeWindow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limen::viewer {

void TimeWindow::add(double now, double value) {
    while (!samples_.empty() && samples_.front().time <= now - seconds_)
        samples_.pop_front();
    if (!std::isnan(value))
        samples_.push_back({now, value});
}

double TimeWindow::quantile(double q) const {
    if (samples_.empty())
        return std::numeric_limits<double>::quiet_NaN();
    sorted_.clear();
    for (const Sample& sample : samples_)
        sorted_.push_back(sample.value);
    const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(sorted_.size())));
    const auto place = sorted_.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(sorted_.begin(), place, sorted_.end());
    return *place;
}

} // namespace limen::viewer
