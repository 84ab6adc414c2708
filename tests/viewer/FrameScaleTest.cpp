#include "viewer/scale/FrameScale.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace limen::viewer {
namespace {

/// A machine that draws frames: a fixed part, a part that grows with the pixels, and all else.
struct Machine {
    double fixed = 0.0, pixels = 0.0, other = 0.0; ///< milliseconds at full size
    double noise = 0.0;                            ///< share by which times differ, at most
    std::uint32_t seed = 1;

    double factor() {
        seed = seed * 1664525u + 1013904223u;
        return 1.0 + noise * (static_cast<double>(seed >> 8) / double(1u << 23) - 1.0);
    }
    FrameTimes draw(std::uint32_t percent) {
        const double sides = percent / 100.0;
        return {(fixed + pixels * sides * sides) * factor(), other * factor()};
    }
    [[nodiscard]] double usual(std::uint32_t percent) const {
        const double sides = percent / 100.0;
        return fixed + pixels * sides * sides + other;
    }
};

/// Draws `frames` frames; returns the scale after each.
std::vector<std::uint32_t> run(FrameScale& scale, Machine& machine, const ScaleGoal& goal, int frames) {
    std::vector<std::uint32_t> scales;
    for (int i = 0; i < frames; ++i)
        scales.push_back(scale.next(machine.draw(scale.percent()), goal));
    return scales;
}

/// Draws frames for some seconds of the machine's time.
void runFor(double seconds, FrameScale& scale, Machine& machine, const ScaleGoal& goal) {
    for (double left = seconds * 1e3; left > 0.0;) {
        const FrameTimes times = machine.draw(scale.percent());
        left -= times.scene + times.other;
        scale.next(times, goal);
    }
}

int changesIn(const std::vector<std::uint32_t>& scales) {
    int changes = 0;
    for (std::size_t i = 1; i < scales.size(); ++i)
        changes += scales[i] != scales[i - 1] ? 1 : 0;
    return changes;
}

Machine anyMachine() {
    Machine machine;
    machine.fixed = *rc::gen::inRange(0, 300) / 10.0;
    machine.pixels = *rc::gen::inRange(0, 2500) / 10.0;
    machine.other = *rc::gen::inRange(0, 100) / 10.0;
    machine.seed = *rc::gen::inRange(1u, 1000000u);
    return machine;
}

ScaleGoal anyGoal() {
    ScaleGoal goal;
    goal.frameMs = *rc::gen::inRange(80, 500) / 10.0;
    goal.bounds.least = 5 * *rc::gen::inRange(10u, 16u);
    goal.bounds.most = goal.bounds.least + 5 * *rc::gen::inRange(0u, (100 - goal.bounds.least) / 5 + 1);
    goal.settling = *rc::gen::inRange(0u, 5u);
    return goal;
}

TEST(FrameScale, staysAtFullSizeWhileFramesAreShort) {
    FrameScale scale;
    Machine machine{.fixed = 2, .pixels = 15, .other = 3};
    EXPECT_EQ(changesIn(run(scale, machine, {}, 1000)), 0);
    EXPECT_EQ(scale.percent(), 100u);
}

TEST(FrameScale, fallsToTheLeastScaleAndStaysThereIfNothingHelps) {
    FrameScale scale;
    Machine machine{.fixed = 5, .pixels = 400, .other = 3};
    const std::vector<std::uint32_t> scales = run(scale, machine, {}, 200);
    EXPECT_EQ(scales[9], 50u);
    EXPECT_EQ(scales.back(), 50u);
}

TEST(FrameScale, aSingleLongFrameChangesNothing) {
    FrameScale scale;
    Machine machine{.fixed = 2, .pixels = 20, .other = 3};
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(changesIn(run(scale, machine, {}, 40)), 0);
        scale.next({900.0, 3.0}, {});
    }
    EXPECT_EQ(scale.percent(), 100u);
}

TEST(FrameScale, timesOfFramesBeforeTheChangeAreLeftOut) {
    FrameScale scale;
    const ScaleGoal goal{.settling = 4};
    while (scale.percent() == 100)
        scale.next({50.0, 3.0}, goal);
    const std::uint32_t lowered = scale.percent();
    ASSERT_GT(lowered, 60u);
    for (int i = 0; i < 4; ++i) // timers still report frames of full size
        EXPECT_EQ(scale.next({50.0, 3.0}, goal), lowered);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(scale.next({26.0, 3.0}, goal), lowered);
}

TEST(FrameScale, aTightGoalLowersItAndALooseOneBringsFullSizeBack) {
    FrameScale scale;
    Machine machine{.fixed = 2, .pixels = 60, .other = 3};
    run(scale, machine, {.frameMs = 1.0}, 300);
    EXPECT_EQ(scale.percent(), 50u);
    run(scale, machine, {.frameMs = 200.0}, 300);
    EXPECT_EQ(scale.percent(), 100u);
}

TEST(FrameScale, newBoundsApplyAtOnce) {
    FrameScale scale;
    EXPECT_EQ(scale.next({1.0, 1.0}, {.bounds = {50, 70}}), 70u);
    EXPECT_EQ(scale.next({1.0, 1.0}, {.bounds = {80, 100}}), 80u);
}

TEST(FrameScale, aRiseThatFailsWaitsLongerEachTime) {
    // Frames of the larger size take far more than their pixels: each rise must be taken back.
    FrameScale scale;
    scale.set(70);
    std::vector<int> rises;
    for (int i = 0; i < 4000; ++i) {
        const std::uint32_t before = scale.percent();
        const double ms = before > 70 ? 60.0 : 20.0;
        if (scale.next({ms, 1.0}, {.bounds = {70, 100}}) > before)
            rises.push_back(i);
    }
    ASSERT_GE(rises.size(), 5u);
    EXPECT_LE(rises.size(), 14u);
    EXPECT_GT(rises[3] - rises[2], rises[1] - rises[0] + 60);
    EXPECT_GT(rises.back() - rises[rises.size() - 2], 450);
}

RC_GTEST_PROP(FrameScale, staysInBounds, (std::vector<std::uint16_t> scenes)) {
    const ScaleGoal goal = anyGoal();
    FrameScale scale;
    for (const std::uint16_t scene : scenes) {
        const std::uint32_t percent = scale.next({scene / 100.0, scene % 7 * 1.0}, goal);
        RC_ASSERT(percent >= goal.bounds.least && percent <= goal.bounds.most);
    }
}

RC_GTEST_PROP(FrameScale, convergesOnAnyMachine, ()) {
    Machine machine = anyMachine();
    const ScaleGoal goal = anyGoal();
    FrameScale scale;
    run(scale, machine, goal, 1500);
    RC_ASSERT(changesIn(run(scale, machine, goal, 1000)) == 0);
    const std::uint32_t percent = scale.percent();
    RC_ASSERT(machine.usual(percent) <= goal.frameMs || percent == goal.bounds.least);
    // No larger step was safe.
    const std::uint32_t larger = percent + FrameScale::kStep;
    const double sides = static_cast<double>(larger) / percent;
    const double scene = machine.usual(percent) - machine.other;
    RC_ASSERT(percent == goal.bounds.most || machine.other + scene * sides * sides > 0.9 * goal.frameMs);
}

RC_GTEST_PROP(FrameScale, doesNotPumpUnderNoise, ()) {
    Machine machine = anyMachine();
    machine.noise = 0.1;
    const ScaleGoal goal = anyGoal();
    FrameScale scale;
    run(scale, machine, goal, 600);
    const std::vector<std::uint32_t> scales = run(scale, machine, goal, 3000);
    const auto [least, most] = std::minmax_element(scales.begin(), scales.end());
    // A rise that noise takes back doubles the wait: 60, 120, 240, then 480 frames. So 3,000 frames hold eight such rises, if the
    // first of them comes late, each with its return, and the return of a rise before them. 6 was the bound: one run of 200 had 7.
    RC_ASSERT(changesIn(scales) <= 2 * 8 + 1);
    RC_ASSERT(*most - *least <= 2 * FrameScale::kStep);
}

RC_GTEST_PROP(FrameScale, meetsALargerLoadWithinASecondAndRecovers, ()) {
    Machine machine{.fixed = *rc::gen::inRange(0, 60) / 10.0,
                    .pixels = *rc::gen::inRange(80, 200) / 10.0,
                    .other = *rc::gen::inRange(0, 30) / 10.0,
                    .noise = 0.05};
    const ScaleGoal goal;
    FrameScale scale;
    runFor(5.0, scale, machine, goal);
    RC_ASSERT(scale.percent() == 100u);
    const double light = machine.pixels;
    machine.pixels *= *rc::gen::inRange(15, 60) / 10.0;
    runFor(1.0, scale, machine, goal);
    RC_ASSERT(machine.usual(scale.percent()) <= 1.03 * goal.frameMs || scale.percent() == 50u);
    machine.pixels = light;
    runFor(6.0, scale, machine, goal);
    RC_ASSERT(scale.percent() == 100u);
}

} // namespace
} // namespace limen::viewer
