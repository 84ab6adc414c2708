#include "viewer/inspect/TimeWindow.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace limen::viewer {
namespace {

TEST(TimeWindow, isNoNumberWhileItIsEmpty) {
    TimeWindow window;
    EXPECT_TRUE(std::isnan(window.median()));
    EXPECT_TRUE(std::isnan(window.p95()));
    window.add(1.0, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(window.count(), 0u);
}

TEST(TimeWindow, tellsMedianAndP95OfWhatItHolds) {
    TimeWindow window;
    for (int i = 100; i >= 1; --i)
        window.add(1.0, i);
    EXPECT_EQ(window.median(), 50.0);
    EXPECT_EQ(window.p95(), 95.0);
    EXPECT_EQ(window.value(0), 100.0) << "in order of addition";
    EXPECT_EQ(window.value(99), 1.0);
    TimeWindow one;
    one.add(0.0, 7.0);
    EXPECT_EQ(one.median(), 7.0);
    EXPECT_EQ(one.p95(), 7.0);
}

TEST(TimeWindow, forgetsWhatIsOlderThanItsSeconds) {
    TimeWindow window(5.0);
    window.add(0.0, 1000.0);
    window.add(4.9, 1.0);
    EXPECT_EQ(window.p95(), 1000.0);
    window.add(5.0, 2.0);
    EXPECT_EQ(window.count(), 2u);
    EXPECT_EQ(window.p95(), 2.0);
    window.add(60.0, 3.0);
    EXPECT_EQ(window.count(), 1u);
    EXPECT_EQ(window.median(), 3.0);
}

} // namespace
} // namespace limen::viewer
