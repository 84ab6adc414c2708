#include "motion/DynamicStateBuilder.h"

#include "support/Effects.h"
#include "support/Puppet.h"
#include "world/Loader.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <numbers>

// Motion that the records define: particles and idle objects.
namespace limen::motion {
namespace {

using test::EffectsHut;
using test::frameAt;
using testing::ElementsAre;
using testing::SizeIs;
using world::kOutside;

struct Loaded {
    world::World world;
    Vec3 home{0.0};
    DynamicStateBuilder dynamicsBuilder{world};
    world::DynamicState dynamics;

    explicit Loaded(test::MovingHut& hut) : world(hut.load()), home(hut.at(Vec3(0.0))) {
        EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    }
    /// The eye is 3 m east of the middle of the hut's meadow, and looks west.
    void at(double seconds, std::optional<double> doors = 1.0) { at(seconds, doors, home + Vec3(8, 5, 2)); }
    void at(double seconds, std::optional<double> doors, const Vec3& eye) {
        DynamicStateInput input;
        input.seconds = seconds;
        input.allDoors = doors;
        input.eye = eye;
        input.right = {0, 1, 0};
        input.forward = {-1, 0, 0};
        dynamicsBuilder.build(input, dynamics);
    }
    [[nodiscard]] std::vector<world::Instance> of(std::uint32_t record) const {
        std::vector<world::Instance> found;
        std::copy_if(dynamics.instances.begin(), dynamics.instances.end(), std::back_inserter(found),
                     [&](const auto& i) { return i.record == record; });
        return found;
    }
    [[nodiscard]] Vec3 place(const world::Instance& i) const {
        return world.blocks[i.block].origin() + Vec3(i.origin) - home;
    }
    [[nodiscard]] std::vector<world::SpaceIndex> membersOf(const world::Instance& i) const {
        const auto begin = dynamics.members.begin() + i.firstMember;
        return {begin, begin + i.memberCount};
    }
    [[nodiscard]] const world::Mesh& mesh(const world::Instance& i) const { return world.meshes[i.mesh]; }
};

void expectAt(const Vec3& got, const Vec3& wanted) {
    EXPECT_LT(glm::length(got - wanted), 1e-4)
        << "(" << got.x << ", " << got.y << ", " << got.z << ") instead of (" << wanted.x << ", " << wanted.y
        << ", " << wanted.z << ")";
}

std::size_t opaqueIn(const world::Mesh& mesh) {
    return mesh.ranges[static_cast<std::size_t>(world::SurfaceClass::Opaque)].indexCount;
}

TEST(Effects, aDefaultScriptSendsParticlesFromAPartOfItsObject) {
    EffectsHut effects;
    const std::uint32_t emitter = effects.add(EffectsHut::emitter(effects.spark));
    const std::uint32_t script = effects.addScript({{0.0, EffectsHut::create(emitter, 1, {1, 0, 0.5})}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({5, 5, 2}, 90.0));
    Loaded loaded(effects.hut);
    loaded.at(100.0);
    const std::vector<world::Instance> sparks = loaded.of(effects.spark);
    ASSERT_THAT(sparks, SizeIs(4)) << "one each half second, each for two";
    for (const world::Instance& spark : sparks) {
        expectAt(loaded.place(spark), {5, 6, 4.5}); // the part is 2 m up, and its x is the world's y
        EXPECT_THAT(loaded.membersOf(spark), ElementsAre(kOutside));
        EXPECT_GT(opaqueIn(loaded.mesh(spark)), 0u) << "nothing makes it translucent";
        EXPECT_GE(spark.idBase, loaded.world.spriteIds);
    }
    EXPECT_EQ(sparks[1].idBase - sparks[0].idBase, loaded.mesh(sparks[0]).polygonCount) << "ids of their own";
    loaded.at(-1000.0);
    EXPECT_THAT(loaded.of(effects.spark), SizeIs(4)) << "an endless one has always been burning";
}

TEST(Effects, oneThatEndsBeginsWithTheWorld) {
    EffectsHut effects;
    dat::ParticleEmitter burst = EffectsHut::emitter(effects.spark);
    burst.initialParticles = 3;
    burst.totalParticles = 3;
    const std::uint32_t script = effects.addScript({{1.0, EffectsHut::create(effects.add(burst))}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({5, 5, 2}));
    Loaded loaded(effects.hut);
    const auto sparksAt = [&](double seconds) {
        loaded.at(seconds);
        return loaded.of(effects.spark).size();
    };
    EXPECT_EQ(sparksAt(0.9), 0u);
    EXPECT_EQ(sparksAt(1.1), 3u);
    EXPECT_EQ(sparksAt(2.9), 3u);
    EXPECT_EQ(sparksAt(3.1), 0u);
}

TEST(Effects, aScriptThatCallsItselfGoesRound) {
    EffectsHut effects;
    dat::ParticleEmitter burst = EffectsHut::emitter(effects.spark);
    burst.initialParticles = burst.totalParticles = 3;
    const std::uint32_t self = effects.nextScript();
    const std::uint32_t script = effects.addScript(
        {{1.0, EffectsHut::create(effects.add(burst))}, {5.0, EffectsHut::call(self, 0.0f)}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({5, 5, 2}));
    Loaded loaded(effects.hut);
    for (const double round : {-5.0, 0.0, 5.0, 500.0}) {
        loaded.at(round + 0.9);
        EXPECT_THAT(loaded.of(effects.spark), SizeIs(0)) << round;
        loaded.at(round + 2.0);
        EXPECT_THAT(loaded.of(effects.spark), SizeIs(3)) << round;
    }
}

TEST(Effects, spritesOfTheNearestLevelFaceTheEyeAndFadingOnesAreBlended) {
    EffectsHut effects;
    dat::ParticleEmitter fading = EffectsHut::emitter(effects.flake);
    fading.translucency = {0.5f, 0.5f, 0.0f};
    fading.scale = {2.0f, 2.0f, 0.0f};
    const std::uint32_t script = effects.addScript({{0.0, EffectsHut::create(effects.add(fading))}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({5, 5, 2}));
    Loaded loaded(effects.hut);
    loaded.at(100.0);
    const std::vector<world::Instance> flakes = loaded.of(effects.flake);
    ASSERT_THAT(flakes, SizeIs(4));
    EXPECT_EQ(flakes[0].opacity, 0.5f);
    EXPECT_EQ(opaqueIn(loaded.mesh(flakes[0])), 0u);
    EXPECT_EQ(loaded.mesh(flakes[0]).vertexCount, 6u) << "a flat picture";
    expectAt(Vec3(flakes[0].linear[0]), {0, 2, 0}); // to the right
    expectAt(Vec3(flakes[0].linear[2]), {0, 0, 2});
    const Sphere& bounds = loaded.mesh(flakes[0]).bounds;
    EXPECT_NEAR(bounds.radius, std::hypot(0.1, 0.2), 1e-5) << "as wide and high as the mesh";
    for (const double metres : {499.0, 501.0}) { // the greatest distance of its level, without another 50 m
        loaded.at(100.0, 1.0, loaded.home + Vec3(5, 5 - metres, 2));
        EXPECT_THAT(loaded.of(effects.flake), SizeIs(metres < 500.0 ? 4 : 0)) << metres;
    }
}

TEST(Effects, particlesStayBehindOrComeAlong) {
    for (const std::uint32_t isParentLocal : {0u, 1u}) {
        EffectsHut effects;
        dat::ParticleEmitter record = EffectsHut::emitter(effects.spark);
        record.isParentLocal = isParentLocal;
        const std::uint32_t script = effects.addScript(
            {{0.0, EffectsHut::create(effects.add(record), EffectsHut::kWhole, {0, 0, 1})}});
        effects.hut.moving.villagers[0].model = effects.addScripted(script);
        Loaded loaded(effects.hut);
        loaded.at(5.25); // anna goes east at 1 m/s from (4, 11.5) at 0 s
        std::vector<double> ahead;
        for (const world::Instance& spark : loaded.of(effects.spark))
            ahead.push_back(loaded.place(spark).x);
        ASSERT_THAT(ahead, SizeIs(4));
        for (std::size_t i = 0; i < ahead.size(); ++i)
            EXPECT_NEAR(ahead[i], isParentLocal != 0 ? 9.25 : 7.5 + 0.5 * static_cast<double>(i), 1e-3);
    }
}

TEST(Effects, particlesAreMembersOfWhatTheyReach) {
    EffectsHut effects;
    dat::ParticleEmitter record = EffectsHut::emitter(effects.spark);
    record.particleType = dat::ParticleType::GlobalVelocity;
    record.a = {{1, 0, 0}, 1.0f, 1.0f};
    const std::uint32_t script = effects.addScript({{0.0, EffectsHut::create(effects.add(record))}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({9, 11.5, 3})); // before the front door
    Loaded loaded(effects.hut);
    const world::SpaceIndex front = world::findCell(loaded.world, effects.hut.source.id(effects.hut.front));
    loaded.at(100.25, 1.0);
    std::size_t inside = 0;
    for (const world::Instance& spark : loaded.of(effects.spark)) {
        if (loaded.place(spark).x > 10.2) {
            EXPECT_THAT(loaded.membersOf(spark), ElementsAre(front));
            ++inside;
        }
    }
    EXPECT_EQ(inside, 2u) << "1.25 and 1.75 s old";
    loaded.at(100.25, 0.0);
    for (const world::Instance& spark : loaded.of(effects.spark))
        EXPECT_THAT(loaded.membersOf(spark), SizeIs(1)) << "shut: on one side or the other";
    loaded.at(99.95, 1.0); // one is 0.95 s old, and 0.1 m wide each way
    EXPECT_TRUE(std::any_of(
        loaded.dynamics.instances.begin(), loaded.dynamics.instances.end(),
        [&](const auto& i) { return i.record == effects.spark && loaded.membersOf(i).size() == 2; }))
        << "in the doorway";
}

TEST(Effects, framesOfACycleStartParticlesWhereTheBodyIsThen) {
    test::Puppet puppet;
    EffectsHut records; // for its ids only
    dat::ParticleEmitter dust = EffectsHut::emitter(0);
    dust.gfxObj = puppet.hut.source.addModel(
        {test::Wall{test::rectangle({-0.1, 0, -0.1}, {0.1, 0, 0.1}), "glow", true}});
    dust.id = 0x32000001;
    dust.initialParticles = dust.totalParticles = dust.maxParticles = 1;
    dust.lifespan = 1.0;
    puppet.hut.source.portalFile().add(dust);
    dat::Animation steps;
    steps.id = 0x03000050;
    steps.partCount = 2;
    for (int k = 0; k < 4; ++k)
        steps.frames.push_back({{frameAt({0, 0, 0}), frameAt({0, 0, 0.9})}, {}});
    steps.frames[1].hooks = {EffectsHut::create(dust.id, 1)};
    steps.frames[1].hooks[0].direction = 1;
    steps.frames[2].hooks = {EffectsHut::create(dust.id)};
    steps.frames[2].hooks[0].direction = -1; // not this way
    puppet.hut.source.portalFile().add(steps);
    // Four frames at 4 a second, 2 m each round: she walks at 1 m/s, so one round takes 2 s, frame 1 is
    // passed after 1 s.
    puppet.cycle(test::kPuppetWalks, {{steps.id, 0, -1, 4.0f}}, {0.0f, 2.0f, 0.0f});
    Loaded loaded{[&]() -> test::MovingHut& {
        puppet.hut.source.portalFile().add(puppet.table);
        puppet.hut.moving.villagers[0].model = puppet.hut.source.addSetup(puppet.setup);
        return puppet.hut;
    }()};
    for (const double round : {0.0, 2.0, 4.0}) {
        loaded.at(round + 0.99);
        EXPECT_THAT(loaded.of(dust.gfxObj), SizeIs(0)) << round;
        loaded.at(round + 1.5);
        const std::vector<world::Instance> dusts = loaded.of(dust.gfxObj);
        ASSERT_THAT(dusts, SizeIs(1)) << round;
        expectAt(loaded.place(dusts[0]), {4 + round + 1.0, 11.5, 2 + 0.9}); // where the leg was
    }
}

TEST(Effects, birthsByTheMetreFollowTheWay) {
    EffectsHut effects;
    dat::ParticleEmitter record = EffectsHut::emitter(effects.spark);
    record.emitterType = dat::ParticleEmitter::kPerMetre;
    record.birthrate = 0.25;
    record.maxParticles = 100;
    const std::uint32_t emitter = effects.add(record);
    const std::uint32_t script = effects.addScript({{0.0, EffectsHut::create(emitter)}});
    const std::uint32_t model = effects.addScripted(script);
    effects.hut.moving.villagers[0].model = model;
    effects.hut.moving.villagers[0].speed = 0.5;
    effects.hut.source.addObject(model, frameAt({5, 5, 2}));
    Loaded loaded(effects.hut);
    loaded.at(7.1);
    std::vector<double> at;
    for (const world::Instance& spark : loaded.of(effects.spark)) {
        EXPECT_NEAR(loaded.place(spark).y, 11.5, 1e-3) << "a standing carrier emits none";
        at.push_back(loaded.place(spark).x);
    }
    ASSERT_THAT(at, SizeIs(4)) << "two seconds, a metre";
    for (std::size_t i = 1; i < at.size(); ++i)
        EXPECT_NEAR(at[i] - at[i - 1], 0.25, 1e-3);
}

TEST(Effects, worldFilesPlayScriptsOfATable) {
    EffectsHut effects;
    const std::uint32_t weak = effects.add(EffectsHut::emitter(effects.spark));
    const std::uint32_t strong = effects.add(EffectsHut::emitter(effects.flake));
    dat::PhysicsScriptTable table;
    table.id = 0x34000001;
    table.scripts = {{12,
                      {{0.5f, effects.addScript({{0.0, EffectsHut::create(weak)}})},
                       {1.0f, effects.addScript({{0.0, EffectsHut::create(strong)}})}}}};
    effects.hut.source.portalFile().add(table);
    dat::Setup setup;
    setup.parts = {effects.post};
    setup.scriptTable = table.id;
    effects.hut.moving.villagers[0].model = effects.hut.source.addSetup(setup);
    effects.hut.moving.villagers[0].play = {12, 0.75};
    Loaded loaded(effects.hut);
    loaded.at(3.0);
    EXPECT_THAT(loaded.of(effects.spark), SizeIs(0));
    EXPECT_THAT(loaded.of(effects.flake), SizeIs(4));
}

TEST(Effects, areAPureFunctionOfTheTime) {
    EffectsHut effects;
    dat::ParticleEmitter record = EffectsHut::emitter(effects.spark);
    record.particleType = dat::ParticleType::Explode;
    record.a = {{1, 0, 0}, 0.5f, 1.0f};
    record.c = {{1, 1, 1}, 1.0f, 1.0f};
    record.lifespanRandom = 0.5;
    const std::uint32_t script = effects.addScript({{0.0, EffectsHut::create(effects.add(record))}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({5, 5, 2}));
    Loaded loaded(effects.hut);
    loaded.at(7.3);
    const world::DynamicState first = loaded.dynamics;
    for (const double other : {0.0, 7.29, 7.31, 1e6})
        loaded.at(other);
    loaded.at(7.3);
    ASSERT_EQ(first.instances.size(), loaded.dynamics.instances.size());
    for (std::size_t i = 0; i < first.instances.size(); ++i) {
        EXPECT_EQ(first.instances[i].origin, loaded.dynamics.instances[i].origin);
        EXPECT_EQ(first.instances[i].idBase, loaded.dynamics.instances[i].idBase);
    }
}

/// A mill: a post, and a wheel on it whose rim is to the side, a quarter turn a second about +y.
struct Mill {
    EffectsHut effects;
    std::uint32_t rim =
        effects.hut.source.addModel(test::boxExterior({0.9, -0.1, -0.1}, {1.1, 0.1, 0.1}, "oak"));
    dat::Setup setup;

    explicit Mill(bool turns = true) {
        dat::Animation round;
        round.id = 0x03000060;
        round.partCount = 2;
        for (int k = 0; k < 4; ++k) {
            dat::Frame wheel = frameAt({0, 0, 3});
            const double half = turns ? -k * std::numbers::pi / 4 : 0.0;
            wheel.orientation =
                Quatf(static_cast<float>(std::cos(half)), 0.0f, static_cast<float>(std::sin(half)), 0.0f);
            round.frames.push_back({{frameAt({0, 0, 0}), wheel}, {}});
        }
        effects.hut.source.portalFile().add(round);
        setup.parts = {effects.post, rim};
        dat::AnimationFrame rest;
        rest.parts = {frameAt({0, 0, 0}), frameAt({0, 0, 3})};
        setup.placementFrames = {{dat::Setup::kPlacementResting, rest}};
        setup.animation = round.id;
    }
    void stand(const Vec3& at, double turn = 0.0) {
        effects.hut.source.addObject(effects.hut.source.addSetup(setup), frameAt(at, turn));
    }
};

TEST(IdleObjects, moveTheirPartsWhereTheyStand) {
    Mill mill;
    mill.stand({5, 5, 2}, 90.0);
    Loaded loaded(mill.effects.hut);
    EXPECT_TRUE(std::none_of(loaded.world.instances.begin(), loaded.world.instances.end(),
                             [&](const auto& i) { return i.record == mill.rim; }))
        << "not among the static instances";
    ASSERT_THAT(loaded.world.idleObjects, SizeIs(1));
    // Its own x is the world's y. 30 frames a second: 1/30 s is a quarter turn.
    const double frame = 1.0 / 30.0;
    const Vec3 rims[] = {{5, 6, 5}, {5, 5, 6}, {5, 4, 5}, {5, 5, 4}};
    for (int k = 0; k < 9; ++k) {
        loaded.at(k * frame + 1e-9);
        const std::vector<world::Instance> found = loaded.of(mill.rim);
        ASSERT_THAT(found, SizeIs(1));
        expectAt(found[0].bounds.centre - loaded.home, rims[k % 4]);
        const Sphere& sphere = loaded.world.idleObjects[0].body.bounds;
        EXPECT_LE(glm::length(found[0].bounds.centre - loaded.home - Vec3(5, 5, 2) -
                              Vec3(-sphere.centre.y, sphere.centre.x, sphere.centre.z)) +
                      found[0].bounds.radius,
                  sphere.radius + 1e-6);
    }
}

TEST(IdleObjects, thatDoNotMoveStandWithAllElse) {
    Mill mill(false);
    mill.stand({5, 5, 2});
    const world::World world = mill.effects.hut.load();
    EXPECT_TRUE(world.idleObjects.empty());
    EXPECT_EQ(std::count_if(world.instances.begin(), world.instances.end(),
                            [&](const auto& i) { return i.record == mill.rim; }),
              1);
    EXPECT_TRUE(std::none_of(world.movingParts.begin(), world.movingParts.end(),
                             [&](const auto& i) { return i.record == mill.rim; }));
}

TEST(IdleObjects, standAsTheirCycleSaysWhereThatIsNotAsTheyRest) {
    Mill mill(false);
    mill.setup.placementFrames[0].second.parts[1] = frameAt({0, 0, 1});
    mill.stand({5, 5, 2});
    Loaded loaded(mill.effects.hut);
    loaded.at(1.0);
    ASSERT_THAT(loaded.of(mill.rim), SizeIs(1));
    expectAt(loaded.of(mill.rim)[0].bounds.centre - loaded.home, {6, 5, 5});
}

TEST(IdleObjects, turnAsAWholeByTheirMotionTable) {
    EffectsHut effects;
    dat::MotionTable table;
    table.id = 0x09000050;
    table.defaultStyle = 0x8000003D;
    table.styleDefaults = {{0x8000003D, 0x41000003}};
    dat::MotionData data;
    data.flags = dat::MotionData::kOmega;
    data.omega = {0.0f, 0.0f, 0.5f};
    table.cycles.emplace_back(dat::motionKey(0x8000003D, 0x41000003), data);
    effects.hut.source.portalFile().add(table);
    const std::uint32_t arm =
        effects.hut.source.addModel(test::boxExterior({0.9, -0.1, 0}, {1.1, 0.1, 0.2}, "oak"));
    dat::Setup setup;
    setup.parts = {arm};
    setup.motionTable = table.id;
    effects.hut.source.addObject(effects.hut.source.addSetup(setup), frameAt({5, 5, 2}));
    Loaded loaded(effects.hut);
    ASSERT_THAT(loaded.world.idleObjects, SizeIs(1));
    for (const double seconds : {0.0, 1.0, 100.0}) {
        loaded.at(seconds);
        ASSERT_THAT(loaded.of(arm), SizeIs(1));
        expectAt(loaded.of(arm)[0].bounds.centre - loaded.home,
                 {5 + std::cos(0.5 * seconds), 5 + std::sin(0.5 * seconds), 2.1});
    }
    EXPECT_GE(loaded.world.idleObjects[0].body.bounds.radius, 1.1) << "all turns";
    EXPECT_EQ(loaded.world.idleObjects[0].body.bounds.centre, Vec3(0.0));
}

TEST(IdleObjects, areMembersOfAllTheyReachInAnyPose) {
    Mill mill;
    // Above the hut's inner door its rim swings from one room into the other.
    mill.effects.hut.source.addStatic(mill.effects.hut.front, mill.effects.hut.source.addSetup(mill.setup),
                                      frameAt({13.2, 11.5, 0.5}));
    Loaded loaded(mill.effects.hut);
    loaded.at(0.0, 1.0);
    ASSERT_THAT(loaded.of(mill.rim), SizeIs(1));
    EXPECT_THAT(loaded.membersOf(loaded.of(mill.rim)[0]), SizeIs(2));
    loaded.at(0.0, 0.0);
    EXPECT_THAT(loaded.membersOf(loaded.of(mill.rim)[0]), SizeIs(1)) << "the door is shut";
}

TEST(IdleObjects, carryParticlesOnTheirParts) {
    Mill mill;
    dat::ParticleEmitter record = EffectsHut::emitter(mill.effects.spark);
    record.isParentLocal = 1;
    mill.setup.script =
        mill.effects.addScript({{0.0, EffectsHut::create(mill.effects.add(record), 1, {0, 0, 0})}});
    mill.stand({5, 5, 2});
    Loaded loaded(mill.effects.hut);
    loaded.at(10.0);
    ASSERT_THAT(loaded.of(mill.effects.spark), SizeIs(4));
    expectAt(loaded.place(loaded.of(mill.effects.spark)[0]), {5, 5, 5}); // the hub
}

} // namespace
} // namespace limen::motion
