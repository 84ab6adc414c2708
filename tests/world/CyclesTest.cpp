#include "world/assemble/Cycles.h"

#include "support/Puppet.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using test::findingsOf;
using test::kPuppetRuns;
using test::kPuppetStands;
using test::kPuppetStyle;
using test::kPuppetWalks;
using test::Puppet;
using testing::ElementsAre;
using testing::HasSubstr;

const Cycle& cycleOf(const World& world, Gait gait) {
    return world.cycles.at(world.villagers.at(0).body.cycles[static_cast<std::size_t>(gait)]);
}
/// The number of a frame of Puppet::sliding: the distance of its leg from the origin, in tenths of a metre.
long numberOf(const World& world, const Stretch& stretch, std::uint32_t frame) {
    return std::lround(world.partFrames.at(stretch.firstPartFrame + frame * stretch.partCount + 1).origin.y *
                       10.0);
}

TEST(Cycles, passTheirHooksWhenTheNextFrameBegins) {
    Puppet puppet;
    dat::Animation steps;
    steps.id = 0x03000070;
    steps.partCount = 2;
    steps.frames.resize(4, {{test::frameAt({0, 0, 0}), test::frameAt({0, 0, 0.9})}, {}});
    // Directions: both, forward, backward, both.
    const std::vector<std::uint8_t> word(4, 0);
    steps.frames[0].hooks = {{0x0E, 0, word}};
    steps.frames[1].hooks = {{0x0F, 1, word}};
    steps.frames[2].hooks = {{0x10, -1, word}};
    steps.frames[3].hooks = {{0x11, 0, {}}};
    dat::MotionData forward, back;
    forward.animations = {{steps.id, 0, 1, 2.0f}, {steps.id, 1, 3, 4.0f}};
    back.animations = {{steps.id, 0, 3, -2.0f}};
    const test::TempDir directory;
    puppet.hut.source.portalFile().add(steps);
    puppet.table.cycles = {{dat::motionKey(kPuppetStyle, kPuppetStands), forward},
                           {dat::motionKey(kPuppetStyle, kPuppetWalks), back}};
    puppet.hut.source.portalFile().add(puppet.table);
    const std::uint32_t setup = puppet.hut.source.addSetup(puppet.setup);
    ASSERT_TRUE(puppet.hut.source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Records records(*archive);
    World world;
    Cycles cycles(records, world);
    using Passed = std::vector<std::tuple<std::uint32_t, double, double>>;
    const auto passed = [&](Gait gait) {
        Passed out;
        for (const Cycles::Hook& hook : cycles.hooksOf(cycles.of(setup)[static_cast<std::size_t>(gait)]))
            out.emplace_back(hook.hook->type, hook.seconds, hook.period);
        return out;
    };
    // Frames 0 and 1 once, at 2 a second; then 1, 2 and 3 repeatedly, at 4 a second.
    EXPECT_EQ(passed(Gait::Stand),
              (Passed{{0x0E, 0.5, 0.0}, {0x0F, 1.0, 0.0}, {0x0F, 1.25, 0.75}, {0x11, 1.75, 0.75}}));
    EXPECT_EQ(passed(Gait::Walk), (Passed{{0x11, 0.5, 2.0}, {0x10, 1.0, 2.0}, {0x0E, 2.0, 2.0}}));
}

TEST(Cycles, areThoseOfTheDefaultStyle) {
    Puppet puppet;
    const std::uint32_t animation = puppet.sliding(4);
    puppet.cycle(kPuppetStands, {{animation, 0, 0, 10.0f}});
    puppet.cycle(kPuppetWalks, {{animation, 1, 3, 30.0f}}, {0.0f, 1.5f, 0.0f});
    dat::MotionData other;
    other.animations = {{animation, 2, 2, 5.0f}};
    puppet.table.styleDefaults.insert(puppet.table.styleDefaults.begin(), {0x8000003Cu, kPuppetWalks});
    puppet.table.cycles.insert(puppet.table.cycles.begin(),
                               {dat::motionKey(0x8000003Cu, kPuppetWalks), other});
    const World world = puppet.load();
    EXPECT_TRUE(world.findings.empty()) << findingsOf(world);
    const Cycle& stand = cycleOf(world, Gait::Stand);
    ASSERT_EQ(stand.stretchCount, 1u);
    EXPECT_EQ(world.stretches[stand.firstStretch].frameCount, 1u);
    EXPECT_EQ(stand.velocity, Vec3(0.0));
    const Cycle& walk = cycleOf(world, Gait::Walk);
    const Stretch& stretch = world.stretches[walk.firstStretch];
    EXPECT_EQ(stretch.frameCount, 3u);
    EXPECT_EQ(stretch.partCount, 2u);
    EXPECT_EQ(stretch.rate, 30.0);
    EXPECT_EQ(numberOf(world, stretch, 0), 1);
    EXPECT_EQ(walk.velocity, Vec3(0, 1.5, 0));
    EXPECT_EQ(world.villagers[0].body.cycles[static_cast<std::size_t>(Gait::Run)], kNone);
    EXPECT_EQ(world.partFrames.size(), 8u) << "four frames of two parts, once";
}

TEST(Cycles, takeTheStretchOfAnAnimationThatTheRangeMeans) {
    struct Case {
        std::int32_t low, high;
        std::uint32_t count;
        long first;
    };
    // Of five frames: -1 is the last, both ends are clamped, and a range that ends before it begins has one
    // frame.
    for (const Case& c :
         {Case{0, -1, 5, 0}, Case{2, 9, 3, 2}, Case{9, 9, 1, 4}, Case{3, 1, 1, 3}, Case{-4, 2, 3, 0},
          Case{7, -1, 1, 4}, Case{2, -7, 1, 2}, Case{1, 3, 3, 1}, Case{-2147483647 - 1, 2147483647, 5, 0}}) {
        Puppet puppet;
        puppet.cycle(kPuppetStands, {{puppet.sliding(5), c.low, c.high, 10.0f}});
        const World world = puppet.load();
        const Stretch& stretch = world.stretches.at(cycleOf(world, Gait::Stand).firstStretch);
        EXPECT_EQ(stretch.frameCount, c.count) << c.low << " to " << c.high;
        EXPECT_EQ(numberOf(world, stretch, 0), c.first) << c.low << " to " << c.high;
    }
}

TEST(Cycles, keepTheOrderOfASequenceAndTheSignOfItsRates) {
    Puppet puppet;
    const std::uint32_t first = puppet.sliding(2), second = puppet.sliding(3);
    puppet.cycle(kPuppetStands, {{first, 0, -1, 10.0f}, {second, 0, -1, -20.0f}});
    const World world = puppet.load();
    const Cycle& cycle = cycleOf(world, Gait::Stand);
    ASSERT_EQ(cycle.stretchCount, 2u);
    const Stretch &a = world.stretches[cycle.firstStretch], &b = world.stretches[cycle.firstStretch + 1];
    EXPECT_EQ(a.frameCount, 2u);
    EXPECT_EQ(b.frameCount, 3u);
    EXPECT_EQ(b.rate, -20.0);
    EXPECT_EQ(numberOf(world, b, frameAt(b, 0)), 2) << "backwards";
    EXPECT_EQ(numberOf(world, b, frameAt(b, 2)), 0);
}

TEST(Cycles, standByTheSetupsOwnAnimationWithoutAMotionTable) {
    for (const bool withTable : {false, true}) {
        Puppet puppet;
        const std::uint32_t animation = puppet.sliding(3);
        puppet.setup.animation = animation;
        if (withTable)
            puppet.cycle(kPuppetWalks, {{animation, 0, -1, 10.0f}});
        else
            puppet.setup.motionTable = 0;
        const World world = puppet.load();
        EXPECT_TRUE(world.findings.empty()) << findingsOf(world);
        const Stretch& stretch = world.stretches.at(cycleOf(world, Gait::Stand).firstStretch);
        EXPECT_EQ(stretch.frameCount, 3u);
        EXPECT_EQ(stretch.rate, 30.0);
    }
}

TEST(Cycles, ofAMissingTableAreNoneWithAFinding) {
    Puppet puppet;
    puppet.setup.motionTable = 0x09000077;
    const World world = puppet.load();
    EXPECT_THAT(findingsOf(world), HasSubstr("09000077"));
    const MovingBody& body = world.villagers.at(0).body;
    EXPECT_THAT(body.cycles, ElementsAre(kNone, kNone, kNone));
    EXPECT_EQ(body.firstPosed, kNone);
    EXPECT_TRUE(world.partFrames.empty());
}

TEST(Cycles, leaveOutAnimationsThatAreMissingOrEmptyAndSayIt) {
    Puppet puppet;
    const std::uint32_t good = puppet.sliding(2), empty = puppet.animation({});
    puppet.cycle(kPuppetStands, {{0x03000077, 0, -1, 10.0f}, {good, 0, -1, 10.0f}, {empty, 0, -1, 10.0f}});
    puppet.cycle(kPuppetWalks, {{empty, 0, -1, 10.0f}}, {0.0f, 1.0f, 0.0f});
    puppet.cycle(kPuppetRuns, {});
    const World world = puppet.load();
    EXPECT_THAT(findingsOf(world), HasSubstr("03000077"));
    EXPECT_THAT(findingsOf(world), HasSubstr("the animation has no frames"));
    EXPECT_EQ(cycleOf(world, Gait::Stand).stretchCount, 1u);
    EXPECT_EQ(world.villagers[0].body.cycles[static_cast<std::size_t>(Gait::Walk)], kNone);
    EXPECT_EQ(world.villagers[0].body.cycles[static_cast<std::size_t>(Gait::Run)], kNone);
}

TEST(Cycles, areReadDespiteNumbersThatAreNone) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    Puppet puppet;
    const std::uint32_t animation =
        puppet.animation({{test::frameAt({0, 0, 0}), {Vec3f(kNan), Quatf(kNan, 0.0f, 0.0f, 0.0f)}},
                          {test::frameAt({0, 0, 0}), {Vec3f(1.0f), Quatf(0.0f, 0.0f, 0.0f, 2.0f)}}});
    puppet.cycle(kPuppetWalks, {{animation, 0, -1, kNan}}, {0.0f, kNan, 0.0f});
    const World world = puppet.load();
    EXPECT_THAT(findingsOf(world), HasSubstr("a rate that is not a number"));
    const Cycle& cycle = cycleOf(world, Gait::Walk);
    EXPECT_EQ(cycle.velocity, Vec3(0.0));
    EXPECT_EQ(world.stretches[cycle.firstStretch].rate, 0.0);
    EXPECT_EQ(world.partFrames.at(1).origin, Vec3(0.0));
    EXPECT_EQ(world.partFrames.at(1).orientation, Quat(1.0, 0.0, 0.0, 0.0));
    EXPECT_EQ(world.partFrames.at(3).orientation, Quat(0.0, 0.0, 0.0, 1.0)) << "normalised";
    EXPECT_TRUE(std::isfinite(world.villagers[0].body.bounds.radius));
}

TEST(Cycles, oneSetupsAreReadOnce) {
    Puppet puppet;
    puppet.cycle(kPuppetStands, {{puppet.sliding(2), 0, -1, 10.0f}});
    puppet.hut.moving.villagers.push_back(puppet.hut.moving.villagers[0]);
    puppet.hut.source.portalFile().add(puppet.table);
    const std::uint32_t model = puppet.hut.source.addSetup(puppet.setup);
    for (VillagerEntry& villager : puppet.hut.moving.villagers)
        villager.model = model;
    const World world = puppet.hut.load();
    ASSERT_EQ(world.villagers.size(), 2u);
    EXPECT_EQ(world.cycles.size(), 1u);
    EXPECT_EQ(world.villagers[0].body.cycles, world.villagers[1].body.cycles);
    EXPECT_NE(world.villagers[0].body.firstPosed, world.villagers[1].body.firstPosed);
}

TEST(Cycles, areNotForDoors) {
    Puppet puppet;
    puppet.cycle(kPuppetStands, {{puppet.sliding(2), 0, -1, 10.0f}});
    puppet.hut.source.portalFile().add(puppet.table);
    const std::uint32_t model = puppet.hut.source.addSetup(puppet.setup);
    puppet.hut.moving.doors[0].leaves[0].model = model;
    puppet.hut.moving.villagers.clear();
    puppet.hut.moving.emitters.clear();
    const World world = puppet.hut.load();
    EXPECT_EQ(world.leaves.at(0).body.partCount, 2u);
    EXPECT_EQ(world.leaves.at(0).body.firstPosed, kNone);
    EXPECT_TRUE(world.cycles.empty());
}

TEST(PosedParts, nameTheSetupsPartForEveryLevelOfDetailAndItsSize) {
    Puppet puppet;
    const std::uint32_t coarse = puppet.hut.source.addModel(test::boxExterior({-1, -1, 0}, {1, 1, 1}));
    const std::uint32_t fine =
        puppet.hut.source.addModel(test::boxExterior({-1, -1, 0}, {1, 1, 1}),
                                   {{test::TestWorld::kItself, dat::DegradeLevel::kMesh, 0, 5, 10},
                                    {coarse, dat::DegradeLevel::kMesh, 10, 20, 30}});
    const std::uint32_t absent = 0x01000FFF; // no such record: the part has no mesh
    puppet.setParts({absent, puppet.trunk, fine});
    puppet.setup.flags |= dat::Setup::kScales;
    puppet.setup.scales = {Vec3f(1.0f), Vec3f(1.0f), Vec3f(1.0f, 2.0f, 3.0f)};
    puppet.cycle(kPuppetStands, {{puppet.sliding(2), 0, -1, 10.0f}});
    const World world = puppet.load();
    const MovingBody& body = world.villagers.at(0).body;
    ASSERT_EQ(body.partCount, 3u);
    const auto posed = std::span(world.posedParts).subspan(body.firstPosed, body.partCount);
    EXPECT_EQ(posed[0].part, 1u);
    EXPECT_EQ(posed[1].part, 2u);
    EXPECT_EQ(posed[2].part, 2u) << "the farther level of detail";
    EXPECT_EQ(world.movingParts[body.firstPart + 2].record, coarse);
    EXPECT_EQ(posed[0].scale, Vec3(1.0));
    EXPECT_EQ(posed[2].scale, Vec3(1, 2, 3));
}

TEST(BoundsInMotion, areThoseOfTheRestingBodyWithoutCycles) {
    Puppet puppet;
    const World world = puppet.load();
    const Sphere& bounds = world.villagers.at(0).body.bounds;
    EXPECT_NEAR(bounds.centre.z, 0.875, 1e-6);
    EXPECT_NEAR(bounds.radius, std::sqrt(0.875 * 0.875 + 0.25 * 0.25 + 0.2 * 0.2), 1e-6);
}

TEST(BoundsInMotion, containAPartThatSwingsBetweenTwoFrames) {
    // In one step the leg turns about its joint from straight down to straight up. Half-way it points ahead
    // by 0.9 m, farther than in either frame.
    Puppet puppet;
    puppet.setParts({puppet.leg});
    const std::uint32_t animation =
        puppet.animation({{test::swungAt({0, 0, 0.9}, 0.0)}, {test::swungAt({0, 0, 0.9}, 179.0)}});
    puppet.cycle(kPuppetStands, {{animation, 0, -1, 10.0f}});
    const World world = puppet.load();
    const Sphere& bounds = world.villagers.at(0).body.bounds;
    EXPECT_GE(bounds.radius, glm::length(Vec3(0, 0.9, 0.9) - bounds.centre));
    EXPECT_LT(bounds.radius, 3.0) << "not much larger than necessary";
}

} // namespace
} // namespace limen::world
