#include "world/World.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limen::world {
namespace {

/// An instance in the middle of a block far from the map's origin.
struct LevelRangeTest : ::testing::Test {
    World world;
    Instance instance;
    LevelRangeTest() {
        world.blocks.push_back({{200, 31}, false, {}, {}});
        instance.block = 0;
        instance.origin = {96.5f, 20.25f, 12.0f};
    }
    [[nodiscard]] bool isSeenFrom(const Vec3& offset) const {
        const Vec3 origin = world.blocks[0].origin() + Vec3(instance.origin);
        return isInLevelRange(world, instance, rangeStepsOf(origin + offset));
    }
};

TEST_F(LevelRangeTest, withoutLimitsFromAnywhere) {
    EXPECT_TRUE(isSeenFrom({0, 0, 0}));
    EXPECT_TRUE(isSeenFrom({30000, -4000, 900}));
}

TEST_F(LevelRangeTest, upToALimitAndFromTheNextStepOn) {
    const std::uint16_t limit = levelRangeLimit(5.0);
    EXPECT_EQ(limit, 80);
    const double step = 1.0 / kRangeSteps, less = 1e-9;
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.8, 0)}) {
        instance.levelRange = {0, limit};
        EXPECT_TRUE(isSeenFrom({0, 0, 0}));
        EXPECT_TRUE(isSeenFrom(along * 5.0 + less)) << "within the limit's own step";
        EXPECT_FALSE(isSeenFrom(along * (5.0 + 1.5 * step)));
        instance.levelRange = {limit, LevelRange::kEndless};
        EXPECT_FALSE(isSeenFrom({0, 0, 0}));
        EXPECT_FALSE(isSeenFrom(along * 5.0 + less));
        EXPECT_TRUE(isSeenFrom(along * (5.0 + 1.5 * step)));
    }
}

TEST_F(LevelRangeTest, exactlyOneOfTheLevelsFromEverywhere) {
    const std::array<LevelRange, 3> levels{LevelRange{0, 80}, LevelRange{80, 333},
                                           LevelRange{333, LevelRange::kEndless}};
    for (int i = 0; i < 4000; ++i) {
        const Vec3 offset(std::fmod(i * 7.13, 61.0) - 30, std::fmod(i * 3.77, 53.0) - 26, i * 0.003 - 6);
        int seen = 0;
        for (const LevelRange& reach : levels) {
            instance.levelRange = reach;
            seen += isSeenFrom(offset) ? 1 : 0;
        }
        ASSERT_EQ(seen, 1) << i;
    }
}

TEST_F(LevelRangeTest, fartherThanNumbersGo) {
    instance.levelRange = {levelRangeLimit(2000.0), LevelRange::kEndless};
    EXPECT_TRUE(isSeenFrom({1e6, 1e6, 1e6})) << "squares do not overflow";
    EXPECT_TRUE(isSeenFrom({-3000, 0, 0}));
    EXPECT_FALSE(isSeenFrom({1999, 0, 0}));
    instance.levelRange = {0, levelRangeLimit(2312.5)};
    EXPECT_EQ(instance.levelRange.upTo, kMostRangeSteps);
    EXPECT_FALSE(isSeenFrom({0, 2300, 2300}));
    EXPECT_EQ(levelRangeLimit(2313.0), LevelRange::kEndless);
    EXPECT_EQ(levelRangeLimit(std::nan("")), LevelRange::kEndless);
    EXPECT_EQ(levelRangeLimit(-1.0), 0);
}

} // namespace
} // namespace limen::world
