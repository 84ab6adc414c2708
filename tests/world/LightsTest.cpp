#include "RoomRow.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// Rooms with lamps; the fourth has no door.
struct Lit : test::RoomRow {
    Lit() : RoomRow(4) {}

    std::uint32_t lamp(float falloff, float intensity = 2.0f, std::uint32_t argb = 0xFFFFFFFF) {
        dat::Setup setup;
        setup.parts = {sphere};
        dat::LightInfo light;
        light.colour.argb = argb;
        light.intensity = intensity;
        light.falloff = falloff;
        light.coneAngle = -431602080.0f; // 0xCDCDCDCD, a value that occurs in files
        setup.lights = {{0, light}};
        return source.addSetup(setup);
    }
    void addLamp(std::size_t room, std::uint32_t setup, const Vec3& at) {
        source.addStatic(rooms[room], setup, test::frameAt(at));
    }
};

std::vector<std::uint32_t> lampsOf(const World& world, std::uint32_t set) {
    const LightSet& lights = world.lightSets[set];
    return {world.lampRefs.begin() + lights.firstLamp,
            world.lampRefs.begin() + lights.firstLamp + lights.lampCount};
}

std::vector<std::uint32_t> lampsOnWalls(const World& world, SpaceIndex space) {
    return lampsOf(world, world.instanceLightSets[world.spaces[space].shell]);
}

TEST(Lights, haveColourIntensityAndFalloffOfTheirRecords) {
    Lit lit;
    lit.addLamp(1, lit.lamp(3.0f, 100.0f, 0xFFFF9650), {15, 12, 3});
    const World world = test::loadTestWorld(lit.source);
    ASSERT_EQ(world.lights.size(), 1u);
    const Light& light = world.lights.front();
    EXPECT_EQ(light.colour, Vec3f(1.0f, 150.0f / 255.0f, 80.0f / 255.0f));
    EXPECT_EQ(light.intensity, 100.0f);
    EXPECT_EQ(light.falloff, 3.0f);
    EXPECT_NEAR(light.position.x - world.blocks[0].origin().x, 15.0, 1e-6);
}

TEST(Lights, reachWallsWithin1point3OfTheirFalloff_throughWallsOfConnectedCells) {
    Lit lit;
    lit.addLamp(0, lit.lamp(4.0f), {12.9, 10.5, 3}); // 5.1 m from the third room, no line through the doors
    lit.addLamp(0, lit.lamp(3.8f), {12.9, 10.5, 3}); // reaches 4.94 m
    const World world = test::loadTestWorld(lit.source);
    EXPECT_THAT(lampsOnWalls(world, 1), ElementsAre(0, 1));
    EXPECT_THAT(lampsOnWalls(world, 2), ElementsAre(0, 1));
    EXPECT_THAT(lampsOnWalls(world, 3), ElementsAre(0));
    EXPECT_EQ(world.lightSets[world.instanceLightSets[world.spaces[1].shell]].kind, LightSet::Kind::Walls);
}

TEST(Lights, leaveCellsAloneThatNoPortalsConnect) {
    Lit lit;
    lit.addLamp(2, lit.lamp(9.0f), {21, 12, 3});
    const World world = test::loadTestWorld(lit.source);
    EXPECT_THAT(lampsOnWalls(world, 3), ElementsAre(0));
    EXPECT_THAT(lampsOnWalls(world, 4), ElementsAre()) << "one metre away, in a house of its own";
    EXPECT_THAT(lampsOf(world, world.spaces[4].lightSet), ElementsAre());
}

TEST(Lights, outdoorsLightNothing) {
    Lit lit;
    lit.source.addObject(lit.lamp(9.0f), test::frameAt({9, 12, 3}));
    const World world = test::loadTestWorld(lit.source);
    EXPECT_TRUE(world.lights.empty());
    const LightSet& outside = world.lightSets[world.spaces[kOutside].lightSet];
    EXPECT_EQ(outside.kind, LightSet::Kind::Outdoors);
    EXPECT_FALSE(outside.sealed);
    EXPECT_EQ(outside.lampCount, 0u);
}

/// The light set of the only static object of a model.
std::uint32_t setOfObject(const World& world, dat::RecordId gfxObj) {
    for (InstanceIndex i = 0; i < world.instances.size(); ++i)
        if (world.instances[i].record == gfxObj)
            return world.instanceLightSets[i];
    return kNone;
}

TEST(Lights, reachThingsWithinTheirFalloffAndTheThingsRadius) {
    Lit lit;
    const std::uint32_t thing =
        lit.source.addModel(test::boxExterior({-1, -1, -1}, {1, 1, 1})); // radius 1.732
    lit.source.addStatic(lit.rooms[0], thing, test::frameAt({12, 12, 3}));
    lit.addLamp(0, lit.lamp(0.2f), {13.9, 12, 3}); // 1.9 m away
    lit.addLamp(0, lit.lamp(0.1f), {13.9, 12, 3});
    const World world = test::loadTestWorld(lit.source);
    const std::uint32_t set = setOfObject(world, thing);
    ASSERT_NE(set, kNone);
    EXPECT_EQ(world.lightSets[set].kind, LightSet::Kind::Thing);
    EXPECT_THAT(lampsOf(world, set), ElementsAre(0));
}

TEST(Lights, theEightNearestLightAThing) {
    Lit lit;
    const std::uint32_t thing = lit.source.addModel(test::boxExterior({-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}));
    lit.source.addStatic(lit.rooms[0], thing, test::frameAt({10.5, 12, 3}));
    const std::uint32_t lamp = lit.lamp(9.0f);
    for (int i = 0; i < 12; ++i)
        lit.addLamp(0, lamp, {13.5 - 0.2 * i, 12, 3});
    const World world = test::loadTestWorld(lit.source);
    EXPECT_THAT(lampsOf(world, setOfObject(world, thing)), ElementsAre(11, 10, 9, 8, 7, 6, 5, 4));
    EXPECT_EQ(lampsOnWalls(world, 1).size(), 12u) << "walls have no such limit";
}

TEST(Lights, ofCellsForMovingThings_areWithinReachOfThem) {
    Lit lit;
    lit.addLamp(1, lit.lamp(1.5f), {15, 12, 3}); // 1 m from the first room, 3 m from the third
    const World world = test::loadTestWorld(lit.source);
    EXPECT_EQ(world.lightSets[world.spaces[1].lightSet].kind, LightSet::Kind::Moving);
    EXPECT_THAT(lampsOf(world, world.spaces[1].lightSet), ElementsAre(0));
    EXPECT_THAT(lampsOf(world, world.spaces[3].lightSet), ElementsAre());
}

TEST(Lights, cellsThatSeeNoOutsideAreSealed) {
    Lit lit;
    lit.source.record(lit.rooms[0]).flags |= dat::EnvCell::kSeenOutside;
    const World world = test::loadTestWorld(lit.source);
    EXPECT_FALSE(world.lightSets[world.spaces[1].lightSet].sealed);
    EXPECT_TRUE(world.lightSets[world.spaces[2].lightSet].sealed);
    EXPECT_FALSE(world.lightSets[world.instanceLightSets[world.spaces[1].shell]].sealed);
    EXPECT_TRUE(world.lightSets[world.instanceLightSets[world.spaces[2].shell]].sealed);
}

} // namespace
} // namespace limen::world
