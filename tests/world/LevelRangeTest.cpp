#include "world/World.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limen::world {
namespace {

/// An object in the middle of a block far from the map's origin.
struct LevelRangeTest : ::testing::Test {
    World world;
    Instance instance;
    LevelShare share;
    const Vec3 local{96.5, 20.25, 12.0}; ///< in landcell (4, 0), whose middle is at (108, 12)
    LevelRangeTest() {
        world.blocks.push_back({{200, 31}, false, {}, {}});
        world.levels.push_back({{}, LevelMeasure::Object, localRangeSteps(local)});
        instance.block = 0;
        instance.level = 0;
    }
    [[nodiscard]] bool isSeenFrom(const Vec3& blockLocal) const {
        return isInLevelRange(world, instance, rangeStepsOf(world.blocks[0].origin() + blockLocal), share);
    }
    [[nodiscard]] bool isSeenAcross(const Vec3& offset) const { return isSeenFrom(local + offset); }
};

TEST_F(LevelRangeTest, withoutLevelsFromAnywhere) {
    instance.level = kNone;
    EXPECT_TRUE(isSeenAcross({0, 0, 0}));
    EXPECT_TRUE(isSeenAcross({30000, -4000, 900}));
}

TEST_F(LevelRangeTest, beforeALimitAndFromThereOn) {
    const std::uint16_t limit = levelRangeLimit(5.0);
    EXPECT_EQ(limit, 80);
    const double less = 1e-6;
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.8, 0)}) {
        world.levels[0].range = {0, limit};
        EXPECT_TRUE(isSeenAcross({0, 0, 0}));
        EXPECT_TRUE(isSeenAcross(along * (5.0 - 1.0 / kRangeSteps)));
        EXPECT_FALSE(isSeenAcross(along * 5.0 + less)) << "a level ends before its distance";
        world.levels[0].range = {limit, LevelRange::kEndless};
        EXPECT_FALSE(isSeenAcross({0, 0, 0}));
        EXPECT_FALSE(isSeenAcross(along * (5.0 - 1.0 / kRangeSteps)));
        EXPECT_TRUE(isSeenAcross(along * 5.0 + less));
    }
}

TEST_F(LevelRangeTest, exactlyOneOfTheLevelsFromEverywhere) {
    const std::array<LevelRange, 3> levels{LevelRange{0, 80}, LevelRange{80, 933},
                                           LevelRange{933, LevelRange::kEndless}};
    for (const LevelMeasure measure : {LevelMeasure::Object, LevelMeasure::Landcell}) {
        world.levels[0].measure = measure;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 offset(std::fmod(i * 7.13, 161.0) - 80, std::fmod(i * 3.77, 153.0) - 76,
                              i * 0.003 - 6);
            int seen = 0;
            for (const LevelRange& range : levels) {
                world.levels[0].range = range;
                seen += isSeenAcross(offset) ? 1 : 0;
            }
            ASSERT_EQ(seen, 1) << i;
            share = {1u + static_cast<std::uint32_t>(i) % 16}; // of the next
        }
    }
}

TEST_F(LevelRangeTest, atHalfOfItsDistanceInAPictureOfHalfTheSize) {
    world.levels[0].range = {levelRangeLimit(20.0), levelRangeLimit(40.0)};
    const auto isSeenAt = [&](double metres) { return isSeenAcross(Vec3(metres, 0, 0)); };
    EXPECT_TRUE(!isSeenAt(19.9) && isSeenAt(20.1) && isSeenAt(39.9) && !isSeenAt(40.1));
    share = levelShareOf(50);
    EXPECT_TRUE(!isSeenAt(9.9) && isSeenAt(10.1) && isSeenAt(19.9) && !isSeenAt(20.1));
}

TEST(LevelShare, isThatOfThePictureRoundedUp) {
    EXPECT_EQ(levelShareOf(100), LevelShare{});
    EXPECT_EQ(levelShareOf(50).sixteenths, 8u);
    EXPECT_EQ(levelShareOf(51).sixteenths, 9u);
    EXPECT_EQ(levelShareOf(94).sixteenths, 16u);
    EXPECT_EQ(levelShareOf(1).sixteenths, 1u);
    EXPECT_EQ(LevelShare{8}.seen(100), 400u);
    EXPECT_EQ(LevelShare{1}.seen(0xFFFFFFFFu), 0xFFFFFFFFu) << "no overflow";
}

TEST_F(LevelRangeTest, fartherThanNumbersGo) {
    world.levels[0].range = {levelRangeLimit(2000.0), LevelRange::kEndless};
    EXPECT_TRUE(isSeenAcross({1e6, 1e6, 1e6})) << "squares do not overflow";
    EXPECT_TRUE(isSeenAcross({-3000, 0, 0}));
    EXPECT_FALSE(isSeenAcross({1999, 0, 0}));
    world.levels[0].range = {0, levelRangeLimit(2312.5)};
    EXPECT_EQ(world.levels[0].range.upTo, kMostRangeSteps);
    EXPECT_FALSE(isSeenAcross({0, 2300, 2300}));
    EXPECT_EQ(levelRangeLimit(2313.0), LevelRange::kEndless);
    EXPECT_EQ(levelRangeLimit(std::nan("")), LevelRange::kEndless);
    EXPECT_EQ(levelRangeLimit(-1.0), 0);
}

// Within 50 m of the landcell's middle the object's own distance counts, beyond that the middle's, horizontally.
TEST_F(LevelRangeTest, byTheLandcellBeyond50Metres) {
    world.levels[0].measure = LevelMeasure::Landcell;
    const Vec3 middle(108, 12, 0);
    // 50 m east of the middle: 61.5 m horizontally from the object, whose own distance counts.
    world.levels[0].range = {0, levelRangeLimit(61.0)};
    EXPECT_FALSE(isSeenFrom(middle + Vec3(50, 0, 12)));
    world.levels[0].range = {0, levelRangeLimit(63.0)};
    EXPECT_TRUE(isSeenFrom(middle + Vec3(50, 0, 12)));
    EXPECT_FALSE(isSeenFrom(middle + Vec3(50, 0, 112))) << "its height counts";
    // 51 m east of the middle: 51 m, at every height.
    world.levels[0].range = {0, levelRangeLimit(51.5)};
    EXPECT_TRUE(isSeenFrom(middle + Vec3(51, 0, 12)));
    EXPECT_TRUE(isSeenFrom(middle + Vec3(51, 0, 900)));
    world.levels[0].range = {0, levelRangeLimit(51.0)};
    EXPECT_FALSE(isSeenFrom(middle + Vec3(51, 0, 12)));
    // Every object of a landcell changes at once.
    world.levels[0].range = {0, levelRangeLimit(100.0)};
    for (const Vec3& elsewhere : {Vec3(96, 0, 0), Vec3(119.9, 23.9, 0), Vec3(100, 20, 50)}) {
        world.levels[0].origin = localRangeSteps(elsewhere);
        EXPECT_TRUE(isSeenFrom(middle + Vec3(-99.9, 0, 0)));
        EXPECT_FALSE(isSeenFrom(middle + Vec3(-100, 0, 0)));
    }
}

TEST_F(LevelRangeTest, landcellsRoundDown) {
    EXPECT_EQ(landcellMiddle(0), 192);
    EXPECT_EQ(landcellMiddle(383), 192);
    EXPECT_EQ(landcellMiddle(384), 576);
    EXPECT_EQ(landcellMiddle(-1), -192);
    EXPECT_EQ(landcellMiddle(-384), -192);
    EXPECT_EQ(landcellMiddle(-385), -576);
    EXPECT_EQ(landcellMiddle(-kMostLocalSteps) % 384, -192);
}

} // namespace
} // namespace limen::world
