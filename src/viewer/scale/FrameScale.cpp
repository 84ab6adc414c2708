#include "viewer/scale/FrameScale.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::viewer {
namespace {

// A median of three frames ends a heavy overload at once; a slight one must last longer than noise does.
constexpr std::size_t kHastyFrames = 3, kSteadyFrames = 9;
constexpr double kHeavy = 1.25;         // times the goal
constexpr double kAim = 0.92;           // of the goal, after the scale was lowered
constexpr double kRiseBelow = 0.9;      // of the goal, after a rise
constexpr std::size_t kLongWait = 480;  // frames
constexpr std::size_t kRisesHold = 120; // frames after which a rise counts as right

double total(const FrameTimes& times) {
    return times.scene + times.other;
}

/// The largest scale of the steps from `least` to `most` whose frame takes at most `ms`, if the work of `times`, at
/// `percent`, grows with the pixels; `least` if none does.
std::uint32_t largestWithin(double ms, const FrameTimes& times, std::uint32_t percent, std::uint32_t least,
                            std::uint32_t most) {
    std::uint32_t chosen = least;
    for (std::uint32_t next = least; next <= most; next += FrameScale::kStep) {
        const double sides = static_cast<double>(next) / percent;
        if (times.other + times.scene * sides * sides <= ms)
            chosen = next;
    }
    return chosen;
}

} // namespace

void FrameScale::add(const FrameTimes& times) {
    times_[count_ % kKept] = times;
    ++count_;
}

FrameTimes FrameScale::median(std::size_t count) const {
    LIMEN_ASSERT(count > 0 && count <= std::min(count_, kKept), "only frames that were seen");
    const auto middle = [&](double FrameTimes::*part) {
        std::array<double, kKept> values{};
        for (std::size_t i = 0; i < count; ++i)
            values[i] = times_[(count_ - 1 - i) % kKept].*part;
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(values.begin(), at, values.begin() + static_cast<std::ptrdiff_t>(count));
        return *at;
    };
    return {middle(&FrameTimes::scene), middle(&FrameTimes::other)};
}

bool FrameScale::isTooLong(const ScaleGoal& goal) const {
    return (count_ >= kHastyFrames && total(median(kHastyFrames)) > kHeavy * goal.frameMs) ||
           (count_ >= kSteadyFrames && total(median(kSteadyFrames)) > goal.frameMs);
}

void FrameScale::change(std::uint32_t percent) {
    percent_ = percent;
    count_ = 0;
    skipped_ = 0;
}

void FrameScale::set(std::uint32_t percent) {
    change(percent);
    wait_ = kKept;
    hasRisen_ = false;
}

void FrameScale::confine(const ScaleBounds& bounds) {
    LIMEN_ASSERT(bounds.least > 0 && bounds.least <= bounds.most, "the bounds of a scale");
    if (percent_ < bounds.least || percent_ > bounds.most)
        set(std::clamp(percent_, bounds.least, bounds.most));
}

void FrameScale::lower(const ScaleGoal& goal) {
    if (percent_ <= goal.bounds.least)
        return;
    const FrameTimes times = median(count_ < kSteadyFrames ? kHastyFrames : kSteadyFrames);
    const std::uint32_t most = std::max(percent_ - std::min(kStep, percent_), goal.bounds.least);
    if (hasRisen_ && count_ < kRisesHold)
        wait_ = std::min(2 * wait_, kLongWait);
    hasRisen_ = false;
    change(largestWithin(kAim * goal.frameMs, times, percent_, goal.bounds.least, most));
}

void FrameScale::rise(const ScaleGoal& goal) {
    if (percent_ >= goal.bounds.most)
        return;
    const std::uint32_t found =
        largestWithin(kRiseBelow * goal.frameMs, median(kKept), percent_, percent_, goal.bounds.most);
    if (found == percent_)
        return;
    change(found);
    hasRisen_ = true;
}

std::uint32_t FrameScale::next(const FrameTimes& times, const ScaleGoal& goal) {
    LIMEN_ASSERT(std::isfinite(times.scene) && std::isfinite(times.other), "measured times");
    confine(goal.bounds);
    if (skipped_ < goal.settling) {
        ++skipped_;
        return percent_;
    }
    add(times);
    if (hasRisen_ && count_ == kRisesHold)
        wait_ = kKept;
    if (isTooLong(goal))
        lower(goal);
    else if (count_ >= wait_)
        rise(goal);
    return percent_;
}

} // namespace limen::viewer
