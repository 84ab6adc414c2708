#include "world/World.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limen::world {
namespace {

/// An instance in the middle of a block far out on the map.
struct ReachTest : ::testing::Test {
    World world;
    Instance instance;
    ReachTest() {
        world.blocks.push_back({{200, 31}, false, {}, {}});
        instance.block = 0;
        instance.origin = {96.5f, 20.25f, 12.0f};
    }
    [[nodiscard]] bool isSeenFrom(const Vec3& offset) const {
        const Vec3 origin = world.blocks[0].origin() + Vec3(instance.origin);
        return isInReach(world, instance, reachStepsOf(origin + offset));
    }
};

TEST_F(ReachTest, withoutLimitsFromAnywhere) {
    EXPECT_TRUE(isSeenFrom({0, 0, 0}));
    EXPECT_TRUE(isSeenFrom({30000, -4000, 900}));
}

TEST_F(ReachTest, upToALimitAndFromTheNextStepOn) {
    const std::uint16_t limit = reachLimit(5.0);
    EXPECT_EQ(limit, 80);
    const double step = 1.0 / kReachSteps, less = 1e-9;
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.8, 0)}) {
        instance.reach = {0, limit};
        EXPECT_TRUE(isSeenFrom({0, 0, 0}));
        EXPECT_TRUE(isSeenFrom(along * 5.0 + less)) << "within the limit's own step";
        EXPECT_FALSE(isSeenFrom(along * (5.0 + 1.5 * step)));
        instance.reach = {limit, Reach::kEndless};
        EXPECT_FALSE(isSeenFrom({0, 0, 0}));
        EXPECT_FALSE(isSeenFrom(along * 5.0 + less));
        EXPECT_TRUE(isSeenFrom(along * (5.0 + 1.5 * step)));
    }
}

TEST_F(ReachTest, exactlyOneOfTheLevelsFromEverywhere) {
    const std::array<Reach, 3> levels{Reach{0, 80}, Reach{80, 333}, Reach{333, Reach::kEndless}};
    for (int i = 0; i < 4000; ++i) {
        const Vec3 offset(std::fmod(i * 7.13, 61.0) - 30, std::fmod(i * 3.77, 53.0) - 26, i * 0.003 - 6);
        int seen = 0;
        for (const Reach& reach : levels) {
            instance.reach = reach;
            seen += isSeenFrom(offset) ? 1 : 0;
        }
        ASSERT_EQ(seen, 1) << i;
    }
}

TEST_F(ReachTest, fartherThanNumbersGo) {
    instance.reach = {reachLimit(2000.0), Reach::kEndless};
    EXPECT_TRUE(isSeenFrom({1e6, 1e6, 1e6})) << "squares do not overflow";
    EXPECT_TRUE(isSeenFrom({-3000, 0, 0}));
    EXPECT_FALSE(isSeenFrom({1999, 0, 0}));
    instance.reach = {0, reachLimit(2312.5)};
    EXPECT_EQ(instance.reach.upTo, kMostReachSteps);
    EXPECT_FALSE(isSeenFrom({0, 2300, 2300}));
    EXPECT_EQ(reachLimit(2313.0), Reach::kEndless);
    EXPECT_EQ(reachLimit(std::nan("")), Reach::kEndless);
    EXPECT_EQ(reachLimit(-1.0), 0);
}

} // namespace
} // namespace limen::world
