#include "viewer/SelectionPulse.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

constexpr std::uint32_t strengthOf(std::uint32_t colour) {
    return colour >> 24;
}

TEST(SelectionPulse, isYellowOf1point2Seconds) {
    constexpr std::uint64_t kObject = 42;
    for (const double start : {0.0, 1.2, 12.0}) {
        EXPECT_EQ(selectionPulse(kObject, start).object, kObject);
        EXPECT_EQ(strengthOf(selectionPulse(kObject, start).colour), 40u) << start;
        EXPECT_EQ(strengthOf(selectionPulse(kObject, start + 0.3).colour), 100u);
        EXPECT_EQ(strengthOf(selectionPulse(kObject, start + 0.6).colour), 160u);
        EXPECT_EQ(selectionPulse(kObject, start + 0.25).colour & 0xFFFFFFu, 0x40D0FFu) << "R, G, B: R lowest";
    }
}

} // namespace
} // namespace limen::viewer
