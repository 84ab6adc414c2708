#include "viewer/Gamepad.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

TEST(Gamepad, sticksThatAreLetGoAskNothing) {
    for (const float off : {0.0f, 0.05f, -0.12f}) {
        const StickInput input = inputOf({off, -off, off, off}, 0.1);
        EXPECT_EQ(input.forward, 0.0);
        EXPECT_EQ(input.right, 0.0);
        EXPECT_EQ(input.turnRight, 0.0);
        EXPECT_EQ(input.turnUp, 0.0);
        EXPECT_FALSE(input.fast);
    }
}

TEST(Gamepad, theLeftStickWalksAndRunsAllTheWayOut) {
    const StickInput half = inputOf({0.0f, -0.59f, 0.0f, 0.0f}, 0.1);
    EXPECT_NEAR(half.forward, 0.5, 1e-6);
    EXPECT_EQ(half.right, 0.0);
    EXPECT_FALSE(half.fast);
    const StickInput corner = inputOf({1.0f, 1.0f, 0.0f, 0.0f}, 0.1); // corners have a larger deflection
    EXPECT_NEAR(std::hypot(corner.forward, corner.right), 1.0, 1e-6);
    EXPECT_LT(corner.forward, 0.0) << "stick down moves back";
    EXPECT_GT(corner.right, 0.0);
    EXPECT_TRUE(corner.fast);
}

TEST(Gamepad, theRightStickLooksSlowlyNearItsMiddle) {
    const StickInput full = inputOf({0.0f, 0.0f, 1.0f, 0.0f}, 0.5);
    EXPECT_NEAR(full.turnRight, 90.0, 1e-6) << "180 degrees a second";
    const StickInput half = inputOf({0.0f, 0.0f, 0.59f, 0.0f}, 0.5);
    EXPECT_NEAR(half.turnRight, 22.5, 1e-5) << "half the deflection turns a quarter as fast";
    EXPECT_GT(inputOf({0.0f, 0.0f, 0.0f, -1.0f}, 0.5).turnUp, 0.0) << "stick up looks up";
    EXPECT_EQ(inputOf({0.0f, 0.0f, 1.0f, 1.0f}, -1.0).turnRight, 0.0);
}

} // namespace
} // namespace limen::viewer
