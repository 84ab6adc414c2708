#include "motion/DynamicStateBuilder.h"
#include "motion/Villagers.h"

#include "support/Puppet.h"
#include "world/Loader.h"
#include "world/assemble/BodyAssembler.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace limen::motion {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;
using world::kOutside;
using world::SpaceIndex;

struct Fixture {
    test::MovingHut hut;
    world::World world = hut.load();
    SpaceIndex front = world::findCell(world, hut.source.id(hut.front)),
               rear = world::findCell(world, hut.source.id(hut.rear));
    DynamicStateBuilder dynamicsBuilder{world};
    world::DynamicState dynamics;

    void at(double seconds, std::optional<double> doors, bool rain = false) {
        DynamicStateInput input;
        input.seconds = seconds;
        input.allDoors = doors;
        input.rain = rain;
        input.eye = hut.at({12, 12, 3.7});
        dynamicsBuilder.build(input, dynamics);
    }
    [[nodiscard]] std::vector<world::Instance> of(std::uint32_t record) const {
        std::vector<world::Instance> found;
        for (const world::Instance& i : dynamics.instances)
            if (i.record == record)
                found.push_back(i);
        return found;
    }
    [[nodiscard]] std::vector<SpaceIndex> membersOf(const world::Instance& i) const {
        const auto begin = dynamics.members.begin() + i.firstMember;
        return {begin, begin + i.memberCount};
    }
    [[nodiscard]] Vec3 local(const Vec3& global) const { return global - hut.at(Vec3(0.0)); }
};

TEST(DynamicStateBuilder, closedOpaqueDoorsShutBothWays) {
    Fixture f;
    f.at(0, 0.0);
    const auto& doors = f.world.doors;
    for (const std::size_t door : {0u, 1u}) {
        EXPECT_TRUE(f.dynamics.isClosed(doors[door].portal));
        EXPECT_TRUE(f.dynamics.isClosed(doors[door].reciprocal));
        const world::InstanceIndex filling = f.dynamics.fillings[doors[door].portal];
        ASSERT_NE(filling, world::kNone);
        EXPECT_EQ(f.dynamics.instances[filling].kind, world::InstanceKind::Filling);
        EXPECT_EQ(f.dynamics.fillings[doors[door].reciprocal], filling);
    }
    EXPECT_FALSE(f.dynamics.isClosed(doors[2].portal)) << "glass";
    f.at(0, 0.001);
    EXPECT_FALSE(f.dynamics.isClosed(doors[0].portal)) << "shut only when exactly closed";
    EXPECT_EQ(f.dynamics.fillings[doors[0].portal], world::kNone);
}

TEST(DynamicStateBuilder, drawsThePartsOfABodysSetupAndNoShadow) {
    test::Puppet puppet;
    const world::World world = puppet.load();
    DynamicStateBuilder builder(world);
    world::DynamicState dynamics;
    builder.build({}, dynamics);
    std::vector<std::uint32_t> records;
    for (const world::Instance& instance : dynamics.instances)
        if (instance.object == world::dynamicObject(world::DynamicObject::Villager, 0))
            records.push_back(instance.record);
    EXPECT_THAT(records, UnorderedElementsAre(puppet.trunk, puppet.leg));
}

TEST(DynamicStateBuilder, doorsRestAsTheWorldFileSaysUnlessTold) {
    Fixture f;
    f.at(0, std::nullopt);
    EXPECT_TRUE(f.dynamics.isClosed(f.world.doors[0].portal)) << "open: 0";
    EXPECT_FALSE(f.dynamics.isClosed(f.world.doors[1].portal)) << "open: 0.5";
    DynamicStateInput input;
    const double told[] = {1.0, 0.0};
    input.doors = told;
    f.dynamicsBuilder.build(input, f.dynamics);
    EXPECT_FALSE(f.dynamics.isClosed(f.world.doors[0].portal));
    EXPECT_TRUE(f.dynamics.isClosed(f.world.doors[1].portal));
}

TEST(DynamicStateBuilder, leavesTurnAboutTheirHingesAndBelongToBothSides) {
    Fixture f;
    f.at(0, 0.0);
    auto leaves = f.of(f.hut.leaf);
    leaves.erase(std::remove_if(leaves.begin(), leaves.end(), // fillings look like their leaf
                                [&](const auto& i) { return f.world.meshes[i.mesh].polygonCount == 2; }),
                 leaves.end());
    ASSERT_EQ(leaves.size(), 2u);
    EXPECT_NEAR(f.local(leaves[0].bounds.centre).x, 10.0, 1e-6);
    EXPECT_NEAR(f.local(leaves[0].bounds.centre).y, 11.5, 1e-6);
    EXPECT_THAT(f.membersOf(leaves[0]), UnorderedElementsAre(f.front, kOutside));
    EXPECT_THAT(f.membersOf(leaves[1]), UnorderedElementsAre(f.front, f.rear));
    f.at(0, 1.0);
    leaves = f.of(f.hut.leaf);
    // -90: counter-clockwise from north: the leaf of the front door stands out to the west.
    EXPECT_NEAR(f.local(leaves[0].bounds.centre).x, 9.5, 1e-6);
    EXPECT_NEAR(f.local(leaves[0].bounds.centre).y, 11.0, 1e-6);
    EXPECT_NEAR(f.local(leaves[1].bounds.centre).x, 14.5, 1e-6);
}

TEST(DynamicStateBuilder, aClosedDoorStopsMembership) {
    Fixture f;
    f.at(0, 1.0);
    ASSERT_EQ(f.of(f.hut.table).size(), 1u);
    EXPECT_THAT(f.membersOf(f.of(f.hut.table)[0]), ElementsAre(f.rear, f.front));
    f.at(0, 0.0);
    EXPECT_THAT(f.membersOf(f.of(f.hut.table)[0]), ElementsAre(f.rear));
}

TEST(DynamicStateBuilder, villagersWalkTheirWayThereAndBackThroughSpaces) {
    Fixture f;
    const world::Villager& anna = f.world.villagers[0];
    const auto at = [&](double seconds) { return placeOf(f.world, anna, seconds); };
    EXPECT_EQ(f.local(at(0).feet), Vec3(4, 11.5, 2));
    EXPECT_EQ(at(0).space, kOutside);
    EXPECT_NEAR(at(0).yaw, 90.0, 1e-9);
    EXPECT_EQ(at(5.9).space, kOutside);
    EXPECT_EQ(at(6.1).space, f.front);
    EXPECT_EQ(at(9.9).space, f.front);
    EXPECT_EQ(at(10.1).space, f.rear);
    EXPECT_EQ(at(14.1).space, f.front) << "on the way back";
    EXPECT_NEAR(at(14.1).yaw, -90.0, 1e-9);
    EXPECT_EQ(f.local(at(24).feet), Vec3(4, 11.5, 2)) << "once there and back";
    EXPECT_NEAR(f.local(at(-1).feet).x, 5.0, 1e-9) << "before time 0 too";
}

TEST(DynamicStateBuilder, aVillagerInADoorwayBelongsToBothSidesWhileItIsOpen) {
    Fixture f;
    f.at(6.0, 1.0);
    ASSERT_EQ(f.of(f.hut.body).size(), 1u);
    EXPECT_THAT(f.membersOf(f.of(f.hut.body)[0]), UnorderedElementsAre(kOutside, f.front));
    f.at(6.0, 0.0);
    EXPECT_EQ(f.membersOf(f.of(f.hut.body)[0]).size(), 1u);
    f.at(1.0, 1.0);
    EXPECT_THAT(f.membersOf(f.of(f.hut.body)[0]), ElementsAre(kOutside));
}

TEST(DynamicStateBuilder, everyInstanceIsListedInAllItsSpacesAndNowhereElse) {
    Fixture f;
    f.at(6.0, 0.5, true);
    ASSERT_GT(f.dynamics.instances.size(), 50u);
    for (world::InstanceIndex i = 0; i < f.dynamics.instances.size(); ++i) {
        const auto members = f.membersOf(f.dynamics.instances[i]);
        EXPECT_EQ(members.front(), f.dynamics.instances[i].placedIn);
        for (SpaceIndex s = 0; s < f.world.spaces.size(); ++s) {
            const auto list = f.dynamics.instancesIn(s);
            EXPECT_EQ(std::count(list.begin(), list.end(), i), std::count(members.begin(), members.end(), s));
        }
    }
}

TEST(DynamicStateBuilder, whatIsListedIsListedWithItsBoundsAndWhetherOtherSpacesListIt) {
    Fixture f;
    f.at(6.0, 0.5, true);
    const world::ListedInstances& listed = f.dynamics.listed;
    for (std::size_t i = 0; i < listed.instance.size(); ++i) {
        const world::Instance& instance = f.dynamics.instances[listed.instance[i]];
        const Vec3 centre = listed.origin + Vec3(listed.x[i], listed.y[i], listed.z[i]);
        EXPECT_LT(glm::length(centre - instance.bounds.centre), 2e-4);
        EXPECT_EQ(listed.radius[i], static_cast<float>(instance.bounds.radius));
        EXPECT_EQ(listed.isListedAgain[i] != 0, instance.memberCount > 1);
        EXPECT_EQ(listed.mesh[i], instance.mesh);
    }
    EXPECT_FALSE(listed.areFar);
    EXPECT_EQ(listed.radius.size(), listed.instance.size() + world::ListedInstances::kSpare);
}

TEST(DynamicStateBuilder, whatLiesTooFarFromTheRestToBeToldInFloatsIsSaid) {
    const auto listedWith = [](const Vec3& centre, double radius) {
        world::DynamicState dynamics;
        world::Instance instance;
        instance.bounds = {{1e4, 2e4, 30.0}, 1.0};
        instance.setMembers(0, 1);
        dynamics.members.push_back(world::kOutside);
        dynamics.instances.assign(2, instance);
        dynamics.instances[1].bounds = {centre, radius};
        world::listBySpace(1, dynamics);
        return dynamics.listed.areFar;
    };
    constexpr double kMost = world::ListedInstances::kMostOffset;
    EXPECT_FALSE(listedWith({1e4 + kMost - 1.0, 2e4, 30.0}, 1.0));
    EXPECT_TRUE(listedWith({1e4 + kMost + 1.0, 2e4, 30.0}, 1.0));
    EXPECT_TRUE(listedWith({1e4, 2e4, 30.0 - kMost - 1.0}, 1.0));
    EXPECT_TRUE(listedWith({1e4, 2e4, 30.0}, 2.0 * kMost));
    EXPECT_TRUE(listedWith({1e4, std::numeric_limits<double>::quiet_NaN(), 30.0}, 1.0));
}

TEST(DynamicStateBuilder, spritesDriftThroughOpenDoorsAndNotThroughClosedOnes) {
    Fixture f;
    const auto spritesIn = [&](SpaceIndex space) {
        const auto list = f.dynamics.instancesIn(space);
        return std::count_if(list.begin(), list.end(),
                             [&](auto i) { return f.dynamics.instances[i].record == 0; });
    };
    f.at(5.7, 1.0); // the lantern is in the doorway
    EXPECT_GT(spritesIn(f.front), 0);
    EXPECT_GT(spritesIn(kOutside), spritesIn(f.front));
    f.at(0.0, 0.0);
    EXPECT_EQ(spritesIn(f.front), 0);
    EXPECT_EQ(spritesIn(kOutside), 20) << "two emitters, 5 a second for 2 seconds";
}

TEST(DynamicStateBuilder, rainBelongsToTheOutsideAloneAndFallsAroundTheEye) {
    Fixture f;
    f.at(0.0, 1.0);
    const std::size_t dry = f.dynamics.instances.size();
    f.at(0.0, 1.0, true);
    ASSERT_GT(f.dynamics.instances.size(), dry + 100);
    double before = 0.0;
    for (std::size_t i = dry; i < f.dynamics.instances.size(); ++i) {
        EXPECT_THAT(f.membersOf(f.dynamics.instances[i]), ElementsAre(kOutside));
        const Vec3 offset = f.dynamics.instances[i].bounds.centre - f.hut.at({12, 12, 3.7});
        EXPECT_LT(std::max(std::abs(offset.x), std::abs(offset.y)), 13.0);
        before += offset.z;
    }
    f.at(0.01, 1.0, true);
    double after = 0.0;
    for (std::size_t i = dry; i < f.dynamics.instances.size(); ++i)
        after += f.dynamics.instances[i].bounds.centre.z - f.hut.at({12, 12, 3.7}).z;
    EXPECT_NE(before, after);
}

TEST(DynamicStateBuilder, areListedTheSameWhateverWasListedBefore) {
    Fixture f;
    f.at(6.3, 0.5);
    const world::ListedInstances first = f.dynamics.listed;
    f.at(6.3, 0.5, true); // many more
    f.at(6.3, 0.5);
    EXPECT_EQ(first, f.dynamics.listed);
}

TEST(DynamicStateBuilder, areAPureFunctionOfTheirInput) {
    Fixture f;
    f.at(6.3, 0.5, true);
    const world::DynamicState first = f.dynamics;
    f.at(100.0, 0.0);
    f.at(6.3, 0.5, true);
    ASSERT_EQ(first.instances.size(), f.dynamics.instances.size());
    for (std::size_t i = 0; i < first.instances.size(); ++i) {
        EXPECT_EQ(first.instances[i].origin, f.dynamics.instances[i].origin);
        EXPECT_EQ(first.instances[i].linear, f.dynamics.instances[i].linear);
        EXPECT_EQ(first.instances[i].idBase, f.dynamics.instances[i].idBase);
    }
    EXPECT_EQ(first.members, f.dynamics.members);
    EXPECT_EQ(first.listed, f.dynamics.listed);
    EXPECT_EQ(first.closed, f.dynamics.closed);
}

TEST(DynamicStateBuilder, aWorldWithoutMovingThingsHasAnEmptyOne) {
    test::MovingHut hut;
    hut.moving = {};
    hut.source.omitRegion();
    const world::World world = hut.load();
    DynamicStateBuilder dynamicsBuilder(world);
    world::DynamicState dynamics;
    dynamicsBuilder.build({}, dynamics);
    EXPECT_TRUE(dynamics.instances.empty() && dynamics.closed.empty() && dynamics.firstInSpace.empty());
}

TEST(DynamicStateBuilder, thePlayersBodyIsThereWhenItIsSaidTo) {
    Fixture f;
    DynamicStateInput input;
    input.allDoors = 1.0;
    f.dynamicsBuilder.build(input, f.dynamics);
    const std::size_t before = f.of(f.hut.body).size(); // the villager
    input.player = PlayerBody{f.hut.at({16, 12.5, 2}), 90.0, f.rear, 1.0};
    f.dynamicsBuilder.build(input, f.dynamics);
    const std::vector<world::Instance> bodies = f.of(f.hut.body);
    ASSERT_EQ(bodies.size(), before + 1);
    const world::Instance& player = bodies.back();
    EXPECT_NE(player.object, bodies.front().object);
    EXPECT_THAT(f.membersOf(player), ElementsAre(f.rear));
    EXPECT_LT(glm::length(f.local(player.bounds.centre) - Vec3(16, 12.5, 2 + 1.75 / 2)), 0.01);
    EXPECT_GT(
        f.world.meshes[player.mesh].ranges[static_cast<std::size_t>(world::SurfaceClass::Opaque)].indexCount,
        0u);
    EXPECT_EQ(player.opacity, 1.0f);
    input.player->opacity = 0.0;
    f.dynamicsBuilder.build(input, f.dynamics);
    EXPECT_EQ(f.of(f.hut.body).size(), before) << "not seen";
}

TEST(DynamicStateBuilder, aFadedBodyIsGlass) {
    Fixture f;
    DynamicStateInput input;
    input.player = PlayerBody{f.hut.at({16, 12.5, 2}), 0.0, f.rear, 0.25};
    f.dynamicsBuilder.build(input, f.dynamics);
    const world::Instance ghost = f.of(f.hut.body).back();
    const auto& ranges = f.world.meshes[ghost.mesh].ranges;
    EXPECT_EQ(ghost.opacity, 0.25f);
    EXPECT_EQ(ranges[static_cast<std::size_t>(world::SurfaceClass::Opaque)].indexCount, 0u);
    EXPECT_EQ(ranges[static_cast<std::size_t>(world::SurfaceClass::Blended)].indexCount, 36u) << "a box";
    const world::Material& material = f.world.materials[f.world.materialRefs[ghost.firstMaterial]];
    EXPECT_EQ(material.surfaceClass, world::SurfaceClass::Blended);
    EXPECT_EQ(material.flags & world::Material::kSplit, 0u);
}

TEST(DynamicStateBuilder, thePlayersBodyIsInEverySpaceItReaches) {
    Fixture f;
    DynamicStateInput input;
    for (const double doors : {1.0, 0.0}) {
        input.allDoors = doors;
        input.player = PlayerBody{f.hut.at({10.2, 11.5, 2}), 0.0, f.front, 1.0};
        f.dynamicsBuilder.build(input, f.dynamics);
        if (doors > 0.0)
            EXPECT_THAT(f.membersOf(f.of(f.hut.body).back()), UnorderedElementsAre(f.front, kOutside));
        else
            EXPECT_THAT(f.membersOf(f.of(f.hut.body).back()), ElementsAre(f.front)) << "the door is shut";
    }
}

} // namespace
} // namespace limen::motion
