#include "motion/Sprites.h"

#include <gtest/gtest.h>

namespace limen::motion {
namespace {

world::Emitter fountain() {
    world::Emitter emitter;
    emitter.rate = 4.0;
    emitter.life = 2.0;
    emitter.velocity = {0, 0, 1};
    emitter.acceleration = {0, 0, -0.5};
    emitter.spread = 0.3;
    emitter.radius = 0.1;
    emitter.size[0] = 0.2, emitter.size[1] = 1.0;
    emitter.alpha[0] = 1.0, emitter.alpha[1] = 0.0;
    emitter.seed = 3;
    emitter.reach = 0.1 + (1.0 + 0.3 * std::sqrt(3.0)) * 2.0 + 0.5 * 0.5 * 4.0 + 1.0;
    return emitter;
}

TEST(Sprites, asManyLiveAsRateTimesLife) {
    const world::Emitter emitter = fountain();
    for (const double seconds : {-7.3, 0.0, 0.01, 1.0, 123456.78}) {
        const SpriteRange living = livingAt(emitter, seconds);
        EXPECT_EQ(living.last - living.first + 1, 8) << seconds;
        EXPECT_LE(static_cast<double>(living.last) / emitter.rate, seconds);
        EXPECT_GT(static_cast<double>(living.first) / emitter.rate + emitter.life, seconds);
    }
}

TEST(Sprites, followTheirParabolaAndAge) {
    world::Emitter emitter = fountain();
    emitter.spread = emitter.radius = 0.0;
    const SpriteState born = spriteAt(emitter, 8, 2.0), half = spriteAt(emitter, 8, 3.0);
    EXPECT_EQ(born.offset, Vec3(0.0));
    EXPECT_EQ(born.size, 0.2);
    EXPECT_EQ(born.opacity, 1.0);
    EXPECT_NEAR(half.offset.z, 1.0 - 0.25, 1e-12);
    EXPECT_NEAR(half.size, 0.6, 1e-12);
    EXPECT_NEAR(half.opacity, 0.5, 1e-12);
}

TEST(Sprites, neverLeaveTheReachAndNeverJump) {
    const world::Emitter emitter = fountain();
    for (double seconds = 0.0; seconds < 20.0; seconds += 0.05) {
        const SpriteRange living = livingAt(emitter, seconds);
        for (std::int64_t n = living.first; n <= living.last; ++n) {
            const SpriteState now = spriteAt(emitter, n, seconds),
                              next = spriteAt(emitter, n, seconds + 1e-4);
            EXPECT_LE(glm::length(now.offset) + now.size / 2, emitter.reach);
            EXPECT_LT(glm::length(next.offset - now.offset), 1e-3);
        }
    }
}

TEST(Sprites, differBySeedAndNumber) {
    world::Emitter emitter = fountain(), other = fountain();
    other.seed = 4;
    EXPECT_EQ(spriteAt(emitter, 3, 1.0).offset, spriteAt(emitter, 3, 1.0).offset);
    EXPECT_NE(spriteAt(emitter, 3, 1.0).offset, spriteAt(other, 3, 1.0).offset);
    EXPECT_NE(spriteAt(emitter, 3, 1.0).offset.x, spriteAt(emitter, 2, 0.75).offset.x);
}

TEST(HashedUnit, isSpreadEvenly) {
    int buckets[10] = {};
    for (int i = -5000; i < 5000; ++i)
        ++buckets[static_cast<int>(hashedUnit(1, i, 2) * 10.0)];
    for (const int count : buckets)
        EXPECT_NEAR(count, 1000, 150);
}

} // namespace
} // namespace limen::motion
