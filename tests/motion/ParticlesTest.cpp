#include "PlainStyle.h"

#include "world/records/ParticleStyles.h"

#include <gtest/gtest.h>
#include <numbers>

namespace limen::motion {
namespace {

using dat::ParticleType;
using world::kNeverEnds;
using world::ParticleSource;
using world::ParticleStyle;

Vec3 offsetAt(const ParticleStyle& style, double age, const Quat& born = {1, 0, 0, 0},
              const Vec3& offset = Vec3(0.0)) {
    return particleAt(style, {3, 5}, age, 3.0, born, offset).offset;
}

void expectNear(const Vec3& got, const Vec3& wanted) {
    EXPECT_LT(glm::length(got - wanted), 1e-9)
        << "(" << got.x << ", " << got.y << ", " << got.z << ") instead of (" << wanted.x << ", " << wanted.y
        << ", " << wanted.z << ")";
}

TEST(Particles, standStillWhereTheyWereBorn) {
    const Quat quarter = glm::angleAxis(std::numbers::pi / 2, Vec3(0, 0, 1));
    expectNear(offsetAt(plain(), 2.0, quarter, {1, 0, 3}), {0, 1, 3});
}

/// A particle of each type, with A = (1, 2, 3), B = (4, 5, 6), C = (0.5, 0.25, 2), two seconds old, born at
/// an offset of (1, 0, 0) in a frame that is rotated by a quarter turn: x becomes y, y becomes -x.
TEST(Particles, moveByTheFormulasOfTheirTypes) {
    const Quat born = glm::angleAxis(std::numbers::pi / 2, Vec3(0, 0, 1));
    const Vec3 o(0, 1, 0), a(1, 2, 3), b(4, 5, 6), c(0.5, 0.25, 2);
    const Vec3 localA(-2, 1, 3), localB(-5, 4, 6);
    const double t = 2.0;
    const auto at = [&](ParticleType type) {
        ParticleStyle style = plain(type);
        style.a = {a, 1.0, 1.0};
        style.b = {b, 1.0, 1.0};
        style.c = {c, 1.0, 1.0};
        return offsetAt(style, t, born, {1, 0, 0});
    };
    expectNear(at(ParticleType::LocalVelocity), o + t * localA);
    expectNear(at(ParticleType::GlobalVelocity), o + t * a);
    expectNear(at(ParticleType::ParabolicLVGA), o + t * localA + 2.0 * b);
    expectNear(at(ParticleType::ParabolicLVGAGR), o + t * localA + 2.0 * b);
    expectNear(at(ParticleType::ParabolicLVLA), o + t * localA + 2.0 * localB);
    expectNear(at(ParticleType::ParabolicLVLALR), o + t * localA + 2.0 * localB);
    expectNear(at(ParticleType::ParabolicGVGA), o + t * a + 2.0 * b);
    expectNear(at(ParticleType::ParabolicGVGAGR), o + t * a + 2.0 * b);
    expectNear(at(ParticleType::Swarm),
               o + t * localA + Vec3(std::cos(8.0) * 0.5, std::sin(10.0) * 0.25, std::cos(12.0) * 2.0));
    expectNear(at(ParticleType::Implode), Vec3(0, 0.25, 0) * (1.0 + std::cos(2.0)) + 4.0 * b);
}

/// The stated cases: offset (1, 2, 3), A = (0.5, 0.25, 0.125), B = (0, 0, -9.8), 2 s old, born in an unturned frame at (10, 20, 30).
TEST(Particles, areWhereTheStatedCasesHaveThem) {
    const auto at = [](ParticleType type) {
        ParticleStyle style = plain(type);
        style.a = {{0.5, 0.25, 0.125}, 1.0, 1.0};
        style.b = {{0, 0, -9.8}, 1.0, 1.0};
        style.c = {{2, 3, 4}, 1.0, 1.0};
        return Vec3(10, 20, 30) + offsetAt(style, 2.0, {1, 0, 0, 0}, {1, 2, 3});
    };
    expectNear(at(ParticleType::Still), {11, 22, 33});
    expectNear(at(ParticleType::LocalVelocity), {12, 22.5, 33.25});
    EXPECT_NEAR(at(ParticleType::ParabolicLVGA).z, 13.65, 1e-9);
}

TEST(Particles, explodeFromOnePointToAllSides) {
    ParticleStyle style = plain(ParticleType::Explode);
    style.a = {{2, 0, 0}, 1.0, 1.0};
    style.c = {{1, 1, 1}, 1.0, 1.0};
    Vec3 sum(0.0);
    for (std::int64_t n = 0; n < 500; ++n) {
        const Vec3 out = particleAt(style, {3, n}, 1.5, 3.0, {1, 0, 0, 0}, {}).offset;
        EXPECT_NEAR(glm::length(out), 3.0, 1e-9) << "2 m/s for 1.5 s";
        sum += out;
    }
    EXPECT_LT(glm::length(sum) / 500.0, 0.5);
    style.b = {{0, 0, -1}, 1.0, 1.0};
    style.a.vector = Vec3(0.0);
    expectNear(offsetAt(style, 2.0), {0, 0, -4}); // t (t B)
}

TEST(Particles, explosionsRiseByTheThirdComponentOfA) {
    ParticleStyle style = plain(ParticleType::Explode);
    style.c = {{1, 1, 1}, 1.0, 1.0};
    style.a = {{1, 100, 0}, 1.0, 1.0};
    const Vec3 flat = offsetAt(style, 1.0);
    style.a.vector.z = 10000.0;
    expectNear(offsetAt(style, 1.0) - flat, {0, 0, 10000});
    expectNear(offsetAt(style, 2.0) - 2.0 * flat, {0, 0, 20000});
}

TEST(Particles, turnByTheirThirdVectorWhereTheirTypeSaysSo) {
    const Quat born = glm::angleAxis(std::numbers::pi / 2, Vec3(0, 0, 1));
    const auto at = [&](ParticleType type) {
        ParticleStyle style = plain(type);
        style.c = {{std::numbers::pi / 2, 0, 0}, 1.0, 1.0}; // a quarter a second
        return particleAt(style, {3, 5}, 1.0, 3.0, born, {}).orientation * Vec3(0, 1, 0);
    };
    expectNear(at(ParticleType::ParabolicLVGA), {-1, 0, 0});
    expectNear(at(ParticleType::ParabolicLVGAGR), {-1, 0, 0}); // about the axis that it points along
    expectNear(at(ParticleType::ParabolicGVGAGR), {-1, 0, 0});
    expectNear(at(ParticleType::ParabolicLVLALR), {0, 0, 1}); // about the x axis of its frame of birth
}

TEST(Particles, areBornAsideAcrossTheDirection) {
    ParticleStyle style = plain();
    style.offset = {{0, 0, 1}, 0.5, 0.75};
    double least = 1.0, most = 0.0;
    for (std::int64_t n = 0; n < 500; ++n) {
        const Vec3 aside = particleAt(style, {3, n}, 0.0, 3.0, {1, 0, 0, 0}, {}).offset;
        EXPECT_NEAR(aside.z, 0.0, 1e-12);
        least = std::min(least, glm::length(aside));
        most = std::max(most, glm::length(aside));
    }
    EXPECT_NEAR(least, 0.5, 0.01);
    EXPECT_NEAR(most, 0.75, 0.01);
}

TEST(Particles, growAndFadeOverTheirLives) {
    ParticleStyle style = plain();
    style.scale = {1.0f, 3.0f, 0.0f};
    style.translucency = {0.5f, 1.0f, 0.0f};
    const ParticleState half = particleAt(style, {3, 5}, 1.5, 3.0, {1, 0, 0, 0}, {});
    EXPECT_NEAR(half.scale, 2.0, 1e-12);
    EXPECT_NEAR(half.opacity, 0.25, 1e-12) << "translucency 0 is opaque";
    style.scale = {0.0f, 100.0f, 0.0f};
    style.translucency = {-1.0f, 2.0f, 0.0f};
    EXPECT_NEAR(particleAt(style, {3, 5}, 0.0, 3.0, {1, 0, 0, 0}, {}).scale, 0.1, 1e-12);
    EXPECT_NEAR(particleAt(style, {3, 5}, 3.0, 3.0, {1, 0, 0, 0}, {}).scale, 10.0, 1e-12);
    EXPECT_EQ(particleAt(style, {3, 5}, 0.0, 3.0, {1, 0, 0, 0}, {}).opacity, 1.0);
    EXPECT_EQ(particleAt(style, {3, 5}, 3.0, 3.0, {1, 0, 0, 0}, {}).opacity, 0.0);
}

TEST(Particles, liveAndScaleWithinTheirSpread) {
    ParticleStyle style = plain();
    style.lifeSpread = 1.0;
    style.scale = {2.0f, 2.0f, 0.5f};
    style.most = 100; // a place is always free
    const ParticleSource source = started(style);
    double least = 10.0, most = 0.0;
    for (std::int64_t n = 0; n < 500; ++n) {
        const double life = Births(style, source).lifeOf(style, {9, n});
        least = std::min(least, life);
        most = std::max(most, life);
        const double scale = particleAt(style, {9, n}, 0.0, life, {1, 0, 0, 0}, {}).scale;
        EXPECT_GE(scale, 1.5);
        EXPECT_LE(scale, 2.5);
    }
    EXPECT_NEAR(least, 2.0, 0.02);
    EXPECT_NEAR(most, 4.0, 0.02);
    style.lifeSpread = 10.0;
    for (std::int64_t n = 0; n < 50; ++n)
        EXPECT_GE(Births(style, source).lifeOf(style, {9, n}), 0.0);
}

TEST(Particles, differByStartAndSource) {
    const ParticleSource source = burning(plain());
    const auto of = [&](const ParticleKey& key) {
        ParticleStyle style = plain();
        style.offset = {{0, 0, 1}, 0.5, 0.75};
        return particleAt(style, key, 0.0, 3.0, {1, 0, 0, 0}, {}).offset;
    };
    ParticleSource other = source;
    other.seed = 8;
    EXPECT_EQ(of(keyOf(source, 1, 2)), of(keyOf(source, 1, 2)));
    EXPECT_NE(of(keyOf(source, 1, 2)), of(keyOf(source, 2, 2)));
    EXPECT_NE(of(keyOf(source, 1, 2)), of(keyOf(source, 1, 3)));
    EXPECT_NE(of(keyOf(source, 1, 2)), of(keyOf(other, 1, 2)));
}

TEST(Particles, neverLeaveTheirReach) {
    for (int type = 1; type <= 12; ++type) {
        ParticleStyle style = plain(static_cast<ParticleType>(type));
        style.lifeSpread = 1.0;
        style.offset = {{0, 0.6, 0.8}, 0.25, 1.0};
        style.a = {{1, -2, 0.5}, -1.0, 2.0};
        style.b = {{0.3, 1, -2}, 0.0, 1.5};
        style.c = {{0.5, 1.25, -1}, 0.5, 1.5};
        style.scale = {0.5f, 2.0f, 0.25f};
        style.size = 0.75;
        const Vec3 offset(0.3, 0.2, -0.4);
        const double reach = world::particleReach(style, offset);
        double farthest = 0.0;
        for (std::int64_t n = 0; n < 300; ++n) {
            const double life = Births(style, started(style)).lifeOf(style, {1, n});
            for (double share = 0.0; share <= 1.0; share += 0.125) {
                const ParticleState state =
                    particleAt(style, {1, n}, share * life, life, {1, 0, 0, 0}, offset);
                farthest = std::max(farthest, glm::length(state.offset) + style.size * state.scale);
            }
        }
        EXPECT_LE(farthest, reach) << "type " << type;
        EXPECT_GT(farthest, reach * 0.2) << "type " << type << ": not far too much";
    }
}

TEST(ParticleStyles, makeSenseOfAnyRecord) {
    dat::ParticleEmitter record;
    record.maxParticles = 5;
    record.initialParticles = 50;
    record.lifespan = 2.0;
    record.birthrate = 0.0;
    record.a = {Vec3f(std::numeric_limits<float>::quiet_NaN()), 1.0f, 1.0f};
    record.particleType = static_cast<ParticleType>(77);
    std::optional<ParticleStyle> style = world::particleStyleOf(record);
    ASSERT_TRUE(style);
    EXPECT_EQ(style->initial, 5u) << "no more than may live";
    EXPECT_NEAR(style->interval, 0.001, 1e-12) << "more than a thousand a second is no rate";
    EXPECT_EQ(style->a.vector, Vec3(0.0));
    EXPECT_EQ(style->type, ParticleType::Still);
    EXPECT_TRUE(style->isEndless());
    record.totalSeconds = 3.0;
    EXPECT_FALSE(world::particleStyleOf(record)->isEndless());
    record.birthrate = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(world::particleStyleOf(record)->interval, kNeverEnds);
    record.lifespan = 1e308;
    record.lifespanRandom = -1e308;
    EXPECT_TRUE(std::isfinite(world::particleStyleOf(record)->longestLife()));
    record.lifespanRandom = 0.0;
    record.maxParticles = 0;
    EXPECT_FALSE(world::particleStyleOf(record)) << "never one alive";
    record.maxParticles = 5;
    record.lifespan = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(world::particleStyleOf(record));
}

} // namespace
} // namespace limen::motion
