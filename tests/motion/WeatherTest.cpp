#include "motion/DynamicStateBuilder.h"

#include "support/Effects.h"
#include "world/Loader.h"

#include <algorithm>
#include <gmock/gmock.h>

// The weather of the Region's day groups, around the eye.
namespace limen::motion {
namespace {

using test::EffectsHut;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using world::kOutside;

constexpr double kRainRadius = 10.0;

/// A hut under a sky with two day groups. In the second, an object has sparks that hang in the air within a
/// radius of the eye.
struct Sky {
    EffectsHut effects;
    dat::SkyObject object;

    explicit Sky(double radius = kRainRadius) {
        dat::ParticleEmitter record = EffectsHut::emitter(effects.spark);
        record.birthrate = 0.02;
        record.maxParticles = 300;
        record.lifespan = 6.0;
        record.offset = {{0.0f, 0.0f, 1.0f}, 0.0f, static_cast<float>(radius)};
        object.script = effects.addScript(
            {{0.0, EffectsHut::create(effects.add(record), EffectsHut::kWhole, {0, 0, 2})}});
    }
    world::World load(const world::Readings& readings = {}) {
        dat::DayGroup weather;
        weather.objects = {object};
        effects.hut.source.region().sky.dayGroups = {{}, weather};
        world::LoadOptions options;
        options.readings = readings;
        world::World world = effects.hut.load(options);
        EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
        return world;
    }
};

struct Falling {
    explicit Falling(Sky sky, const world::Readings& readings = {})
        : record(sky.effects.spark), world(sky.load(readings)), home(sky.effects.hut.at(Vec3(0.0))) {}

    /// The positions of the particles around an eye, block-local.
    std::vector<Vec3> around(const Vec3& eye, std::optional<world::SkyHour> hour = world::SkyHour{1, 0.5}) {
        DynamicStateInput input;
        input.seconds = 100.0;
        input.eye = home + eye;
        input.weather = hour;
        dynamicsBuilder.build(input, dynamics);
        std::vector<Vec3> places;
        for (const world::Instance& i : dynamics.instances) {
            if (i.record != record)
                continue;
            places.push_back(world.blocks[i.block].origin() + Vec3(i.origin) - home);
            EXPECT_THAT(std::vector(dynamics.members.begin() + i.firstMember,
                                    dynamics.members.begin() + i.firstMember + i.memberCount),
                        ElementsAre(kOutside));
        }
        return places;
    }

    std::uint32_t record;
    world::World world;
    Vec3 home;
    DynamicStateBuilder dynamicsBuilder{world};
    world::DynamicState dynamics;
};

double level(const Vec3& way) {
    return glm::length(Vec2(way));
}

TEST(Weather, asMuchLiesAroundTheEyeAsItsEmitterHas) {
    Falling falling{Sky()};
    for (const Vec3& eye : {Vec3(60, 60, 4), Vec3(93, 47, 4), Vec3(20.5, 110.25, 4)}) {
        const std::vector<Vec3> places = falling.around(eye);
        EXPECT_NEAR(static_cast<double>(places.size()), 300.0, 75.0); // random
        std::size_t near = 0;
        for (const Vec3& place : places) {
            EXPECT_LE(level(place - eye), kRainRadius + 1e-3);
            EXPECT_NEAR(place.z, eye.z + 2.0, 1e-3);
            near += level(place - eye) < kRainRadius * std::sqrt(0.5) ? 1 : 0;
        }
        EXPECT_NEAR(static_cast<double>(near) / static_cast<double>(places.size()), 0.5, 0.12)
            << "evenly spread";
    }
}

TEST(Weather, staysWhereItIsWhenTheEyeMoves) {
    Falling falling{Sky()};
    const Vec3 eye(60, 60, 4), then(64, 57, 4);
    const std::vector<Vec3> before = falling.around(eye), after = falling.around(then);
    std::size_t both = 0;
    for (const Vec3& place : before) {
        if (level(place - then) > kRainRadius - 1e-3)
            continue;
        ++both;
        EXPECT_TRUE(std::any_of(after.begin(), after.end(),
                                [&](const Vec3& other) { return glm::length(other - place) < 1e-3; }))
            << place.x << ", " << place.y;
    }
    EXPECT_GT(both, 100u);
}

TEST(Weather, bornCloseTogetherItGoesWithTheEye) {
    Falling falling{Sky(0.5)};
    const Vec3 eye(60, 60, 4), then(64.5, 57, 6);
    const std::vector<Vec3> before = falling.around(eye), after = falling.around(then);
    ASSERT_THAT(before, SizeIs(300));
    ASSERT_THAT(after, SizeIs(300));
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LT(glm::length(after[i] - then - (before[i] - eye)), 1e-3);
}

TEST(Weather, byAnotherReadingIsDensestAtTheEye_andGoesWithIt) {
    world::Readings readings;
    readings.skyParticles = world::SkyParticles::Eye;
    Falling falling{Sky(), readings};
    const Vec3 eye(60, 60, 4), then(64.5, 57, 6);
    const std::vector<Vec3> before = falling.around(eye), after = falling.around(then);
    ASSERT_THAT(before, SizeIs(300));
    ASSERT_THAT(after, SizeIs(300));
    std::size_t near = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LT(glm::length(after[i] - then - (before[i] - eye)), 1e-3);
        EXPECT_LE(level(before[i] - eye), kRainRadius + 1e-3);
        near += level(before[i] - eye) < 0.25 * kRainRadius ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(near) / 300.0, 0.25, 0.08)
        << "distances are spread evenly: over the ground it would be a sixteenth";
}

TEST(Weather, byAnotherReadingIsNone) {
    world::Readings readings;
    readings.skyParticles = world::SkyParticles::None;
    EXPECT_THAT(Falling(Sky(), readings).around({60, 60, 4}), IsEmpty());
}

TEST(Weather, ofNoSensibleSizeItIsNotLookedForForEver) {
    for (const double radius : {1.5, 1e30}) {
        Sky sky(radius);
        dat::ParticleEmitter storm = EffectsHut::emitter(sky.effects.spark);
        storm.lifespan = 2.3; // none is born just now
        storm.particleType = dat::ParticleType::GlobalVelocity;
        storm.offset = {{0.0f, 0.0f, 1.0f}, 0.0f, static_cast<float>(radius)};
        storm.a = {{1e30f, 0.0f, 0.0f}, 1.0f, 1.0f};
        sky.object.script = sky.effects.addScript({{0.0, EffectsHut::create(sky.effects.add(storm))}});
        Falling falling{std::move(sky)};
        EXPECT_THAT(falling.around({60, 60, 4}), IsEmpty());
    }
}

TEST(Weather, fallsOnDaysAndAtHoursThatHaveIt) {
    Sky sky;
    sky.object.beginTime = 0.8f;
    sky.object.endTime = 0.95f;
    Falling falling{std::move(sky)};
    const Vec3 eye(60, 60, 4);
    EXPECT_FALSE(falling.around(eye, world::SkyHour{1, 0.9}).empty());
    EXPECT_THAT(falling.around(eye, world::SkyHour{1, 0.5}), IsEmpty());
    EXPECT_THAT(falling.around(eye, world::SkyHour{0, 0.9}), IsEmpty());
    EXPECT_THAT(falling.around(eye, std::nullopt), IsEmpty()) << "the player is inside";
}

TEST(Weather, aSetupInTheSkyPlaysItsOwnScriptWhereTheObjectNamesNone) {
    Sky sky;
    sky.object.object = sky.effects.addScripted(sky.object.script);
    sky.object.script = 0;
    Falling falling{std::move(sky)};
    EXPECT_FALSE(falling.around({60, 60, 4}).empty());
}

} // namespace
} // namespace limen::motion
