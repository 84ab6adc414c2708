#include "viewer/HeldInput.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

using Kind = play::PlayActKind;
using Acts = std::vector<play::PlayAct>;

TEST(HeldInput, oppositeKeysCancelAndAMouseTurns) {
    HeldInput held;
    held.forward = held.back = held.right = held.down = held.fast = true;
    held.lookX = 20.0;
    held.lookY = 10.0;
    const play::PlayInput input = inputOf(held, 0.25);
    EXPECT_EQ(input.seconds, 0.25);
    EXPECT_EQ(input.forward, 0.0);
    EXPECT_EQ(input.right, 1.0);
    EXPECT_EQ(input.up, -1.0);
    EXPECT_TRUE(input.fast);
    EXPECT_FALSE(input.jump);
    EXPECT_DOUBLE_EQ(input.turnRight, 3.0);
    EXPECT_DOUBLE_EQ(input.turnUp, -1.5) << "mouse down looks down";
}

TEST(HeldInput, sticksAndKeysTogetherAskNoMoreThanAll) {
    HeldInput held;
    held.forward = true;
    held.sticks = Sticks{0.0f, -1.0f, 0.0f, 0.0f};
    EXPECT_EQ(inputOf(held, 0.1).forward, 1.0);
    EXPECT_TRUE(inputOf(held, 0.1).fast);
}

TEST(HeldInput, theWheelTakesTheEyeOutOfTheHead) {
    EXPECT_EQ(wheelActs(-1.0, {true, false, 3.0, 1.0}), (Acts{{Kind::Chase}, {Kind::Distance, 1.0}}));
    EXPECT_EQ(wheelActs(-3.0, {true, false, 3.0, 1.0}), (Acts{{Kind::Chase}, {Kind::Distance, 2.0}}))
        << "the first notch switches to third person, the others add distance";
    EXPECT_TRUE(wheelActs(1.0, {true, false, 3.0, 1.0}).empty()) << "first person is the nearest";
}

TEST(HeldInput, theWheelMovesTheEyeBehindTheBodyAndBackIntoTheHead) {
    EXPECT_EQ(wheelActs(-2.0, {true, true, 3.0, 1.0}), (Acts{{Kind::Distance, 4.0}}));
    EXPECT_EQ(wheelActs(2.0, {true, true, 3.0, 1.0}), (Acts{{Kind::Distance, 2.0}}));
    EXPECT_EQ(wheelActs(9.0, {true, true, 3.0, 1.0}), (Acts{{Kind::Distance, 1.0}}))
        << "stops at the nearest distance first";
    EXPECT_EQ(wheelActs(1.0, {true, true, 1.0, 1.0}), (Acts{{Kind::Chase}}));
    EXPECT_EQ(wheelActs(-1.0, {true, true, 1.0, 1.0}), (Acts{{Kind::Distance, 1.5}}));
}

TEST(HeldInput, theWheelDoesNothingToWhoFliesOrWhenItRests) {
    EXPECT_TRUE(wheelActs(-1.0, {false, false, 3.0, 1.0}).empty());
    EXPECT_TRUE(wheelActs(1.0, {false, true, 3.0, 1.0}).empty());
    EXPECT_TRUE(wheelActs(0.0, {true, true, 3.0, 1.0}).empty());
}

} // namespace
} // namespace limen::viewer
