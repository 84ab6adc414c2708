#include "support/BentRooms.h"
#include "support/LoadTestWorld.h"
#include "world/OpeningParts.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;

struct DoorRooms {
    TestWorld source;
    TestWorld::Cell a = source.addBox({0, 0, 0}, {4, 4, 3}), b = source.addBox({4, 0, 0}, {8, 4, 3});
};

/// A doorway between the rooms with one corner `off` metres off the plane of the others.
std::vector<Vec3> bentDoor(double off) {
    return {{4, 1, 0}, {4, 2, 0}, {4 + off, 2, 2}, {4, 1, 2}};
}

double farthestFromPlane(const World& world, const Portal& portal) {
    double most = 0.0;
    for (const Vec3& corner : cornersOf(world, portal))
        most = std::max(most, std::abs(portal.plane.signedDistance(corner)));
    return most;
}

TEST(BentOpenings, areTrianglesThatLieInTheirPlanes) {
    TestWorld source;
    const test::BentRooms rooms(source, 4.0, 0.003);
    const World world = test::loadTestWorld(source);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    for (const SpaceIndex space : {1u, 2u}) {
        ASSERT_EQ(world.spaces[space].portalCount, 2u);
        for (std::uint32_t i = 0; i < 2; ++i) {
            const PortalIndex p = world.spaces[space].firstPortal + i;
            const Portal& part = world.portals[p];
            EXPECT_EQ(part.cornerCount, 3u);
            EXPECT_LT(farthestFromPlane(world, part), 1e-9);
            EXPECT_EQ(part.part, i);
            EXPECT_EQ(part.partCount, 2u);
            EXPECT_EQ(part.recordIndex, 0u);
            EXPECT_EQ(part.destination, 3u - space);
            EXPECT_EQ(openingOf(world, p).cornerCount, 4u);
        }
    }
}

TEST(BentOpenings, haveTheSameTrianglesFromBothSides) {
    DoorRooms rooms;
    rooms.source.link(rooms.a, bentDoor(-0.001), rooms.b);
    const World world = test::loadTestWorld(rooms.source);
    for (PortalIndex p = 0; p < world.portals.size(); ++p) {
        const Portal &there = world.portals[p], &back = world.portals[there.reciprocal];
        EXPECT_EQ(back.reciprocal, p);
        EXPECT_EQ(back.part, there.part);
        EXPECT_LT(glm::length(there.plane.n + back.plane.n), 1e-9);
        const auto corners = cornersOf(world, there), others = cornersOf(world, back);
        for (const Vec3& corner : corners)
            EXPECT_NE(std::find(others.begin(), others.end(), corner), others.end()) << "to the bit";
    }
}

TEST(BentOpenings, stayWholeIfFloatsAreNoMoreAccurate) {
    DoorRooms rooms;
    rooms.source.link(rooms.a, bentDoor(1e-6), rooms.b);
    const World world = test::loadTestWorld(rooms.source);
    ASSERT_EQ(world.spaces[1].portalCount, 1u);
    EXPECT_EQ(world.portals[world.spaces[1].firstPortal].whole, kNone);
    EXPECT_TRUE(world.wholes.empty());
}

TEST(BentOpenings, areTrianglesIfACornerIsOffByMoreThanRounding) {
    DoorRooms rooms;
    rooms.source.link(rooms.a, bentDoor(2e-5), rooms.b);
    EXPECT_EQ(test::loadTestWorld(rooms.source).spaces[1].portalCount, 2u);
}

TEST(BentOpenings, mayBeOffMoreInACellThatReachesFar) {
    for (const double away : {0.0, 80.0}) { // metres from the origin of the cells' records
        TestWorld source;
        const test::BentRooms rooms(source, 84.0, 6e-5, {80, 80, 0}, "grey", "grey", {},
                                    Vec3(80 - away, 80, 0));
        EXPECT_EQ(test::loadTestWorld(source).spaces[1].portalCount, away > 0.0 ? 1u : 2u);
    }
}

TEST(BentOpenings, withAWallOnTheFarSideAreTrianglesOfOneWay) {
    TestWorld source;
    TestWorld::LinkOptions options;
    options.surfaceInB = "grey";
    const test::BentRooms rooms(source, 4.0, 0.003, {0, 0, 0}, "grey", "grey", options);
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.spaces[1].portalCount, 2u);
    for (std::uint32_t i = 0; i < 2; ++i) {
        const Portal& part = world.portals[world.spaces[1].firstPortal + i];
        EXPECT_LT(farthestFromPlane(world, part), 1e-9);
        EXPECT_EQ(part.part, i);
        EXPECT_EQ(part.reciprocal, kNone);
        EXPECT_EQ(part.destination, 2u);
    }
    ASSERT_EQ(world.spaces[2].portalCount, 1u) << "no ray leaves by the wall";
    EXPECT_TRUE(world.portals[world.spaces[2].firstPortal].walled);
}

/// The portals of a space that lead somewhere or nowhere.
std::ptrdiff_t portalsOf(const World& world, SpaceIndex space, bool leadSomewhere) {
    const auto first = world.portals.begin() + world.spaces[space].firstPortal;
    return std::count_if(first, first + world.spaces[space].portalCount, [&](const Portal& portal) {
        return (portal.destination != kNone) == leadSomewhere;
    });
}

TEST(BentOpenings, ofInexactPairsAreExactPairsAndHoles) {
    for (const double aside : {0.0, 0.03}) {
        DoorRooms rooms;
        TestWorld::LinkOptions options;
        options.exact = false;
        options.polygonInB = bentDoor(0.002);
        for (Vec3& corner : options.polygonInB)
            corner += Vec3(0, aside, aside);
        rooms.source.link(rooms.a, bentDoor(0.002), rooms.b, options);
        const World world = test::loadTestWorld(rooms.source);
        for (const SpaceIndex space : {1u, 2u}) {
            EXPECT_GE(portalsOf(world, space, true), 2);
            EXPECT_EQ(portalsOf(world, space, false) > 0, aside > 0.0);
            EXPECT_EQ(portalsOf(world, space, true), portalsOf(world, 3 - space, true));
        }
        for (PortalIndex p = 0; p < world.portals.size(); ++p) {
            const Portal& portal = world.portals[p];
            EXPECT_TRUE(portal.exact);
            EXPECT_LT(farthestFromPlane(world, portal), 1e-9);
            EXPECT_EQ(portal.reciprocal == kNone, portal.destination == kNone);
            if (portal.reciprocal == kNone)
                continue;
            EXPECT_EQ(world.portals[portal.reciprocal].part, portal.part);
            EXPECT_LT(glm::length(portal.plane.n + world.portals[portal.reciprocal].plane.n), 1e-9);
        }
    }
}

TEST(BentOpenings, ofInexactPairsThatAreFlatStayWhole) {
    DoorRooms rooms;
    TestWorld::LinkOptions options;
    options.exact = false;
    options.polygonInB = rectangle({4, 1.03, 0.03}, {4, 2.03, 2.03});
    rooms.source.link(rooms.a, rectangle({4, 1, 0}, {4, 2, 2}), rooms.b, options);
    const World world = test::loadTestWorld(rooms.source);
    ASSERT_EQ(world.spaces[1].portalCount, 1u);
    EXPECT_FALSE(world.portals[world.spaces[1].firstPortal].exact);
}

/// Two corners are stitched into the edge of an opening, from the openings beside it, a tenth of a millimetre beside the edge.
TEST(BentOpenings, includeThoseWithAVertexBesideAnEdge) {
    for (const auto& [beside, isBent] : {std::pair{0.0, false}, {1e-4, true}}) {
        DoorRooms rooms;
        rooms.source.link(rooms.a, rectangle({4, 1, 0}, {4, 2, 2}), rooms.b);
        rooms.source.link(rooms.a, rectangle({4, 2 + beside, 0.5}, {4, 3, 1.5}), rooms.b);
        const World world = test::loadTestWorld(rooms.source);
        const Portal& first = world.portals[world.spaces[1].firstPortal];
        EXPECT_EQ(first.partCount > 1, isBent);
        EXPECT_EQ(openingOf(world, world.spaces[1].firstPortal).cornerCount, 4u);
    }
}

/// One side has a corner 2 mm beyond another, on the extension of an edge: stitching leaves it out.
TEST(BentOpenings, withASpikeOnOneSideAreExactPairs) {
    DoorRooms rooms;
    TestWorld::LinkOptions options;
    options.polygonInB = bentDoor(0.001);
    const Vec3 along = glm::normalize(options.polygonInB[2] - options.polygonInB[1]);
    std::vector<Vec3> spiked = options.polygonInB;
    spiked.insert(spiked.begin() + 2, spiked[2] + along * 0.002);
    rooms.source.link(rooms.a, spiked, rooms.b, options);
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_THAT(test::findingsOf(world), testing::Not(testing::HasSubstr("another polygon")));
    EXPECT_EQ(world.spaces[1].portalCount, 2u);
    EXPECT_EQ(openingOf(world, world.spaces[1].firstPortal).cornerCount, 4u);
}

TEST(BentOpenings, leaveIndicesOfOtherPortalsRight) {
    DoorRooms rooms;
    rooms.source.link(rooms.a, rectangle({4, 3, 0}, {4, 3.5, 2}), rooms.b);
    rooms.source.link(rooms.a, bentDoor(0.002), rooms.b);
    rooms.source.link(rooms.a, rectangle({4, 0.2, 0}, {4, 0.6, 2}), rooms.b);
    const TestWorld::Portal exit = rooms.source.openOutside(rooms.b, rectangle({8, 1, 0}, {8, 2, 2}));
    rooms.source.addBuilding(test::boxExterior({0, 0, 0}, {8, 4, 3}), {exit});
    const World world = test::loadTestWorld(rooms.source);
    std::vector<std::uint16_t> records;
    const Space& b = world.spaces[2];
    for (PortalIndex p = b.firstPortal; p < b.firstPortal + b.portalCount; ++p) {
        const Portal& portal = world.portals[p];
        EXPECT_EQ(portal.space, 2u);
        EXPECT_EQ(world.portals[portal.reciprocal].reciprocal, p);
        EXPECT_EQ(world.portals[portal.reciprocal].space, portal.destination);
        records.push_back(portal.recordIndex);
    }
    EXPECT_EQ(records, (std::vector<std::uint16_t>{0, 1, 1, 2, 3}));
    ASSERT_EQ(world.spaces[kOutside].portalCount, 1u);
    EXPECT_EQ(world.portals[world.portals[0].reciprocal].recordIndex, 3u);
}

TEST(BentOpenings, leadOutside) {
    DoorRooms rooms;
    const TestWorld::Portal exit =
        rooms.source.openOutside(rooms.b, {{8, 1, 0}, {8, 2, 0}, {8.002, 2, 2}, {8, 1, 2}});
    rooms.source.addBuilding(test::boxExterior({0, 0, 0}, {8, 4, 3}), {exit});
    const World world = test::loadTestWorld(rooms.source);
    ASSERT_EQ(world.spaces[kOutside].portalCount, 2u);
    for (PortalIndex p = 0; p < 2; ++p) {
        EXPECT_EQ(world.portals[p].destination, 2u);
        EXPECT_EQ(world.portals[world.portals[p].reciprocal].destination, kOutside);
    }
}

} // namespace
} // namespace limen::world
