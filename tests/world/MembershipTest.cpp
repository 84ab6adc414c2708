#include "RoomRow.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;
using testing::ElementsAre;

std::vector<SpaceIndex> membersOf(const World& world, InstanceKind kind) {
    for (const Instance& instance : world.instances) {
        if (instance.kind == kind)
            return {world.members.begin() + instance.firstMember,
                    world.members.begin() + instance.firstMember + instance.memberCount};
    }
    return {};
}

TEST(Membership, anObjectAwayFromPortalsIsInItsSpaceAlone) {
    test::RoomRow row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({16, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(2u));
}

TEST(Membership, anObjectInADoorwayIsInBothSpacesPlacedFirst) {
    test::RoomRow row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({14.1, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(2u, 1u));
}

TEST(Membership, aPictureInADoorwayStopsAnObjectFromItsSide) {
    for (const bool fromWest : {true, false}) {
        TestWorld source;
        const auto west = source.addBox({10, 10, 2}, {14, 14, 5}),
                   east = source.addBox({14, 10, 2}, {18, 14, 5});
        TestWorld::LinkOptions options;
        options.surface = "painted door";
        source.link(west, rectangle({14, 11.5, 2}, {14, 12.5, 4}), east, options);
        const auto sphere = source.addModel(test::boxExterior({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
        source.addStatic(fromWest ? west : east, sphere, test::frameAt({14, 12, 3}));
        const auto members = membersOf(test::loadTestWorld(source), InstanceKind::Static);
        EXPECT_EQ(members.size(), fromWest ? 1u : 2u);
    }
}

TEST(Membership, aWallStopsAnObjectThatPokesThroughIt) {
    test::RoomRow row;
    row.source.addStatic(row.rooms[1], row.sphere, test::frameAt({14.1, 13.5, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(2u));
}

TEST(Membership, reachesAreFollowedTransitively) {
    test::RoomRow row;
    const auto log = row.source.addModel(test::boxExterior({-5, -0.1, -0.1}, {5, 0.1, 0.1}));
    row.source.addStatic(row.rooms[1], log, test::frameAt({15, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static),
                ElementsAre(2u, 1u, 3u, 0u));
}

TEST(Membership, outdoorObjectsReachIn) {
    test::RoomRow row;
    row.source.addObject(row.sphere, test::frameAt({9.9, 12, 3}));
    EXPECT_THAT(membersOf(test::loadTestWorld(row.source), InstanceKind::Static), ElementsAre(0u, 1u));
}

TEST(Membership, partsOfOneObjectShareItsMembers) {
    test::RoomRow row;
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
    test::RoomRow row;
    const World world = test::loadTestWorld(row.source);
    EXPECT_THAT(membersOf(world, InstanceKind::Exterior), ElementsAre(0u));
    EXPECT_THAT(membersOf(world, InstanceKind::Terrain), ElementsAre(0u));
    EXPECT_THAT(membersOf(world, InstanceKind::Shell), ElementsAre(1u));
}

TEST(Membership, everySpaceListsItsMembersShellFirst) {
    test::RoomRow row;
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
