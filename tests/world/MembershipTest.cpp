#include "support/LoadTestWorld.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;
using testing::ElementsAre;

/// Three rooms in a row along x with doors in the middle of the walls; a door to the outside in the first.
struct Row {
    TestWorld source;
    std::vector<TestWorld::Cell> rooms;
    std::uint32_t sphere = 0;
    Row() {
        for (int i = 0; i < 3; ++i)
            rooms.push_back(source.addBox({10.0 + 4 * i, 10, 2}, {14.0 + 4 * i, 14, 5}));
        for (std::size_t i = 1; i < 3; ++i) {
            const double x = 10.0 + 4.0 * static_cast<double>(i);
            source.link(rooms[i - 1], rectangle({x, 11.5, 2}, {x, 12.5, 4}), rooms[i]);
        }
        const auto door = source.openOutside(rooms[0], rectangle({10, 11.5, 2}, {10, 12.5, 4}));
        source.addBuilding(test::boxExterior({10, 10, 2}, {22, 14, 5}), {door});
        source.setFlatTerrain(source.home(), 1);
        sphere = source.addModel(test::boxExterior({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
    }
};

std::vector<SpaceIndex> membersOf(const World& world, InstanceKind kind) {
    for (const Instance& instance : world.instances) {
        if (instance.kind == kind)
            return {world.members.begin() + instance.firstMember,
                    world.members.begin() + instance.firstMember + instance.memberCount};
    }
    return {};
}

TEST(Membership, anObjectAwayFromPortalsIsInItsSpaceAlone) {
    Row row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({16, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(2u));
}

TEST(Membership, anObjectInADoorwayIsInBothSpacesPlacedFirst) {
    Row row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({14.1, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(2u, 1u));
}

TEST(Membership, aWallStopsAnObjectThatPokesThroughIt) {
    Row row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({14.1, 13.5, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(2u));
}

TEST(Membership, reachesAreFollowedTransitively) {
    Row row;
    const auto log = row.source.addModel(test::boxExterior({-5, -0.1, -0.1}, {5, 0.1, 0.1}));
    row.source.addStatic(row.rooms[1], log, test::frameAt({15, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static),
                ElementsAre(2u, 1u, 3u, 0u));
}

TEST(Membership, outdoorObjectsReachIn) {
    Row row;
    row.source.addObject(row.sphere, test::frameAt({9.9, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(0u, 1u));
}

TEST(Membership, partsOfOneObjectShareItsMembers) {
    Row row;
    dat::Setup setup;
    setup.parts = {row.sphere, row.sphere};
    dat::AnimationFrame pose;
    pose.parts = {test::frameAt({0, 0, 0}), test::frameAt({1.5, 0, 0})};
    setup.placementFrames = {{0x65, pose}};
    row.source.addStatic(row.rooms[0], row.source.addSetup(setup), test::frameAt({12.5, 12, 3}));
    const World world = test::loadTestWorld(row.source);
    int parts = 0;
    for (const Instance& instance : world.instances) {
        if (instance.kind != InstanceKind::Static)
            continue;
        ++parts;
        EXPECT_EQ(instance.memberCount, 2u);
        EXPECT_EQ(instance.object, static_cast<std::uint64_t>(row.source.id(row.rooms[0])) << 32);
    }
    EXPECT_EQ(parts, 2);
}

TEST(Membership, shellsTerrainAndExteriorsAreNeverMembersElsewhere) {
    Row row;
    const World world = test::loadTestWorld(row.source);
    EXPECT_THAT(membersOf(world, InstanceKind::Exterior), ElementsAre(0u));
    EXPECT_THAT(membersOf(world, InstanceKind::Terrain), ElementsAre(0u));
    EXPECT_THAT(membersOf(world, InstanceKind::Shell), ElementsAre(1u));
}

TEST(Membership, everySpaceListsItsMembersShellFirst) {
    Row row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({14.1, 12, 3}));
    const World world = test::loadTestWorld(row.source);
    std::size_t listed = 0;
    for (SpaceIndex s = 0; s < world.spaces.size(); ++s) {
        const Space& space = world.spaces[s];
        listed += space.instanceCount;
        EXPECT_TRUE(space.shell == kNone || space.shell == world.spaceInstances[space.firstInstance]) << s;
    }
    std::size_t memberships = 0;
    for (const Instance& instance : world.instances)
        memberships += instance.memberCount;
    EXPECT_EQ(listed, memberships);
}

} // namespace
} // namespace limen::world
