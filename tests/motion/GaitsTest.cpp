// Bodies that stand, walk and run, in the dynamic state of a loaded world.
#include "geometry/Compass.h"
#include "motion/DynamicStateBuilder.h"
#include "motion/Villagers.h"
#include "support/Puppet.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace limen::motion {
namespace {

using test::frameAt;
using test::kPuppetRuns;
using test::kPuppetStands;
using test::kPuppetWalks;
using test::Puppet;
using test::swungAt;
using testing::Contains;

/// The leg swings 30 degrees each way and back while walking, once in a metre; the trunk nods while standing.
void addSwing(Puppet& puppet) {
    std::vector<std::vector<dat::Frame>> walk;
    for (const double degrees : {30.0, 15.0, 0.0, -15.0, -30.0, -15.0, 0.0, 15.0})
        walk.push_back({frameAt({0, 0, 0}), swungAt({0, 0, 0.9}, degrees)});
    puppet.cycle(kPuppetWalks, {{puppet.animation(walk), 0, -1, 8.0f}}, {0.0f, 1.0f, 0.0f});
    puppet.cycle(kPuppetStands, {{puppet.animation({{frameAt({0, 0, 0}), frameAt({0, 0, 0.9})},
                                                    {frameAt({0, 0, 0.01}), frameAt({0, 0, 0.9})}}),
                                  0, -1, 2.0f}});
}

/// A world with a puppet, and its dynamic state.
struct Stage {
    Puppet& puppet;
    world::World world = puppet.load();
    DynamicStateBuilder dynamicsBuilder{world};
    world::DynamicState dynamics;

    explicit Stage(Puppet& p) : puppet(p) {}
    void at(double seconds, double doors = 1.0, const Vec3& eye = Vec3(0.0)) {
        DynamicStateInput input;
        input.eye = eye;
        input.seconds = seconds;
        input.allDoors = doors;
        dynamicsBuilder.build(input, dynamics);
    }
    /// South of the middle of the landcell in which the villager begins.
    [[nodiscard]] Vec3 eyeAt(double metres) const { return puppet.hut.at({12, 12 - metres, 2}); }
    [[nodiscard]] bool has(std::uint32_t record) const {
        return std::any_of(dynamics.instances.begin(), dynamics.instances.end(),
                           [record](const world::Instance& instance) { return instance.record == record; });
    }
    [[nodiscard]] const world::Instance& part(std::uint32_t record) const {
        for (const world::Instance& instance : dynamics.instances)
            if (instance.record == record)
                return instance;
        std::abort(); // a part that the test has added
    }
    [[nodiscard]] Vec3 globalOf(const world::Instance& part, const Vec3& p) const {
        return world.blocks[part.block].origin() + Vec3(part.origin) + Mat3(part.linear) * p;
    }
    /// Forward of the joint, as the body faces; the foot is 0.9 m below the joint.
    [[nodiscard]] double footAhead(double seconds) {
        at(seconds);
        const world::Instance& leg = part(puppet.leg);
        const Vec3 offset = globalOf(leg, {0, 0, -0.9}) - globalOf(leg, {0, 0, 0});
        return glm::dot(offset, turnedTo(placeOf(world, world.villagers[0], seconds).yaw) * Vec3(0, 1, 0));
    }
    /// The largest distance of a part's corner outside its own bounds and outside the body's; negative:
    /// inside.
    [[nodiscard]] double outside(double seconds) {
        at(seconds);
        const world::Villager& villager = world.villagers[0];
        const VillagerPlace place = placeOf(world, villager, seconds);
        const Vec3 centre = place.feet + turnedTo(place.yaw) * villager.body.bounds.centre;
        double worst = -1e300;
        for (const std::uint32_t record : puppet.setup.parts) {
            const world::Instance& instance = part(record);
            const world::Mesh& mesh = world.meshes[instance.mesh];
            for (std::uint32_t v = 0; v < mesh.vertexCount; ++v) {
                const Vec3 p = globalOf(instance, world.vertices[mesh.firstVertex + v].corner());
                worst = std::max({worst, glm::length(p - instance.bounds.centre) - instance.bounds.radius,
                                  glm::length(p - centre) - villager.body.bounds.radius});
            }
        }
        return worst;
    }
};

/// The rounding of floats in a landblock; metres.
constexpr double kFloats = 5e-5;

TEST(Gaits, ofWhatWalksFollowTheWayItWent) {
    Puppet puppet;
    addSwing(puppet);
    Stage stage(puppet);
    const double reach = 0.9 * std::sin(glm::radians(30.0));
    EXPECT_NEAR(stage.footAhead(0.0), reach, kFloats);
    EXPECT_NEAR(stage.footAhead(0.25), 0.0, kFloats);
    EXPECT_NEAR(stage.footAhead(0.5), -reach, kFloats);
    EXPECT_NEAR(stage.footAhead(1.0), reach, kFloats);
    EXPECT_NEAR(stage.footAhead(14.0), reach, kFloats) << "on the way back, which faces the other way";
}

TEST(Gaits, areFasterWhereTheBodyIsFaster) {
    Puppet puppet;
    addSwing(puppet);
    puppet.hut.moving.villagers[0].speed = 1.6;
    Stage stage(puppet);
    EXPECT_NEAR(stage.footAhead(0.25 / 1.6), 0.0, kFloats);
    EXPECT_NEAR(stage.footAhead(0.5 / 1.6), -0.9 * std::sin(glm::radians(30.0)), kFloats);
}

TEST(Gaits, startWhereTheBodyStartsOnItsWay) {
    Puppet puppet;
    addSwing(puppet);
    puppet.hut.moving.villagers[0].start = 2.25;
    Stage stage(puppet);
    EXPECT_NEAR(stage.footAhead(0.0), 0.0, kFloats);
}

TEST(Gaits, ofWhatStandsLeaveItsLegsAlone) {
    Puppet puppet;
    addSwing(puppet);
    puppet.hut.moving.villagers[0].speed = 0.0;
    Stage stage(puppet);
    stage.at(0.0);
    const world::Instance leg = stage.part(puppet.leg), trunk = stage.part(puppet.trunk);
    stage.at(0.5);
    EXPECT_EQ(stage.part(puppet.leg).linear, leg.linear);
    EXPECT_EQ(stage.part(puppet.leg).origin, leg.origin);
    EXPECT_NEAR(stage.part(puppet.trunk).origin.z - trunk.origin.z, 0.01, 1e-6) << "it breathes";
    stage.at(0.25);
    EXPECT_NEAR(stage.part(puppet.trunk).origin.z - trunk.origin.z, 0.005, 1e-6);
}

TEST(Gaits, runWhereTheBodyIsFastEnough) {
    Puppet puppet;
    addSwing(puppet);
    puppet.cycle(kPuppetRuns,
                 {{puppet.animation({{frameAt({0, 0, 0.3}), frameAt({0, 0, 1.2})}}), 0, -1, 1.0f}},
                 {0.0f, 3.0f, 0.0f});
    puppet.hut.moving.villagers[0].speed = 2.5;
    Stage stage(puppet);
    stage.at(0.3);
    EXPECT_NEAR(stage.part(puppet.leg).origin.z, 2.0 + 1.2, 1e-6);
}

/// For half of the cycle the foot is on the ground: relative to the body it moves back as fast as the body
/// advances.
TEST(Gaits, keepFeetWhereTheyAreSetDown) {
    for (const double speed : {0.4, 1.0, 1.9}) {
        Puppet puppet;
        std::vector<std::vector<dat::Frame>> walk;
        for (const double y : {0.25, 0.125, 0.0, -0.125, -0.25, 0.0})
            walk.push_back({frameAt({0, 0, 0}), frameAt({0, y, 0.9})});
        puppet.cycle(kPuppetWalks, {{puppet.animation(walk), 0, -1, 12.0f}}, {0.0f, 1.5f, 0.0f});
        puppet.hut.moving.villagers[0].speed = speed;
        Stage stage(puppet);
        stage.at(0.0);
        const Vec3 foot = stage.globalOf(stage.part(puppet.leg), {0, 0, -0.9});
        for (int k = 1; k <= 10; ++k) {
            stage.at(0.05 * k / speed); // to half a metre
            EXPECT_NEAR(glm::length(stage.globalOf(stage.part(puppet.leg), {0, 0, -0.9}) - foot), 0.0,
                        kFloats)
                << "at " << speed << " m/s";
        }
    }
}

TEST(Gaits, ofATableThatIsDamagedAreAsTheBodyRests) {
    Puppet puppet;
    addSwing(puppet);
    puppet.setup.motionTable = 0x09000077;
    Stage stage(puppet);
    EXPECT_FALSE(stage.world.findings.empty());
    for (const double seconds : {0.0, 0.3, 0.5}) {
        EXPECT_NEAR(stage.footAhead(seconds), 0.0, kFloats);
        EXPECT_NEAR(stage.part(puppet.leg).origin.z, 2.9, 1e-6);
    }
}

TEST(Gaits, moveTheLevelsOfDetailOfAPartAlike) {
    Puppet puppet;
    const std::uint32_t coarse =
        puppet.hut.source.addModel(test::boxExterior({-0.1, -0.1, -0.9}, {0.1, 0.1, 0}));
    puppet.leg = puppet.hut.source.addModel(test::boxExterior({-0.05, -0.1, -0.9}, {0.05, 0.1, 0}),
                                            {{test::TestWorld::kItself, dat::DegradeLevel::kMesh, 0, 5, 10},
                                             {coarse, dat::DegradeLevel::kMesh, 10, 20, 30}});
    puppet.setup.parts[1] = puppet.leg;
    addSwing(puppet);
    Stage stage(puppet);
    for (const double seconds : {0.1, 0.4, 0.7}) {
        stage.at(seconds, 1.0, stage.eyeAt(59.0));
        const world::Instance near = stage.part(puppet.leg);
        EXPECT_FALSE(stage.has(coarse)) << "10 m and the 50 m that are subtracted";
        stage.at(seconds, 1.0, stage.eyeAt(61.0));
        EXPECT_FALSE(stage.has(puppet.leg));
        EXPECT_EQ(near.linear, stage.part(coarse).linear);
        EXPECT_EQ(near.origin, stage.part(coarse).origin);
    }
}

TEST(Gaits, areAPureFunctionOfTheMomentsInput) {
    Puppet puppet;
    addSwing(puppet);
    Stage stage(puppet);
    stage.at(3.377);
    const world::DynamicState first = stage.dynamics;
    stage.at(77.1);
    stage.at(3.377);
    ASSERT_EQ(first.instances.size(), stage.dynamics.instances.size());
    for (std::size_t i = 0; i < first.instances.size(); ++i) {
        EXPECT_EQ(first.instances[i].linear, stage.dynamics.instances[i].linear);
        EXPECT_EQ(first.instances[i].origin, stage.dynamics.instances[i].origin);
        EXPECT_EQ(first.instances[i].bounds.centre, stage.dynamics.instances[i].bounds.centre);
        EXPECT_EQ(first.instances[i].bounds.radius, stage.dynamics.instances[i].bounds.radius);
    }
    EXPECT_EQ(first.members, stage.dynamics.members);
}

TEST(Gaits, membershipFollowsTheBallOfAllPoses) {
    // Two metres before the door. In the resting pose the bounds end a metre before it. The bounds of the
    // whole cycle include a leg that is once stretched out that far, so they reach into the door at any time.
    for (const bool stretches : {false, true}) {
        Puppet puppet;
        puppet.hut.moving.villagers[0].speed = 0.0;
        puppet.hut.moving.villagers[0].start = 4.0;
        if (stretches) {
            puppet.cycle(kPuppetWalks,
                         {{puppet.animation({{frameAt({0, 0, 0}), frameAt({0, 2.5, 0.9})}}), 0, -1, 1.0f}},
                         {0.0f, 1.0f, 0.0f});
        }
        Stage stage(puppet);
        stage.at(0.0);
        const world::Instance& trunk = stage.part(puppet.trunk);
        const auto begin = stage.dynamics.members.begin() + trunk.firstMember;
        const std::vector<world::SpaceIndex> members(begin, begin + trunk.memberCount);
        const world::SpaceIndex front = world::findCell(stage.world, puppet.hut.source.id(puppet.hut.front));
        EXPECT_THAT(members, Contains(world::kOutside));
        EXPECT_EQ(std::count(members.begin(), members.end(), front), stretches ? 1 : 0);
    }
}

TEST(Gaits, stayWithinTheirBoundsAtEveryMoment) {
    Puppet puppet;
    addSwing(puppet);
    Stage stage(puppet);
    for (int k = 0; k < 400; ++k)
        EXPECT_LT(stage.outside(0.005 * k), kFloats) << 0.005 * k;
}

dat::Frame anyFrame() {
    const auto number = [](int most) {
        return static_cast<float>(*rc::gen::inRange(-most, most + 1)) / 100.0f;
    };
    dat::Frame frame;
    frame.origin = {number(100), number(100), number(100)};
    frame.orientation = Quatf(number(100), number(100), number(100), number(100) + 0.005f);
    return frame;
}

RC_GTEST_PROP(Gaits, stayWithinTheirBoundsWhateverTheFrames, ()) {
    Puppet puppet;
    std::vector<dat::AnimationRange> sequence;
    const int stretches = *rc::gen::inRange(1, 4);
    for (int s = 0; s < stretches; ++s) {
        // Some frames have the first part only.
        const std::size_t parts = *rc::gen::inRange<std::size_t>(1, 3);
        std::vector<std::vector<dat::Frame>> frames(*rc::gen::inRange<std::size_t>(1, 5));
        for (auto& frame : frames)
            for (std::size_t p = 0; p < parts; ++p)
                frame.push_back(anyFrame());
        sequence.push_back({puppet.animation(frames), 0, -1, *rc::gen::arbitrary<bool>() ? 4.0f : -4.0f});
    }
    puppet.cycle(kPuppetWalks, sequence);
    puppet.setup.flags |= dat::Setup::kScales;
    puppet.setup.scales = {Vec3f(1.0f), Vec3f(0.5f, 1.0f, 1.5f)};
    Stage stage(puppet);
    for (int k = 0; k < 120; ++k)
        RC_ASSERT(stage.outside(0.03125 * k) < kFloats);
}

} // namespace
} // namespace limen::motion
