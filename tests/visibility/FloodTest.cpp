#include "visibility/EyeSpace.h"
#include "visibility/Region.h"
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>

namespace limen::visibility {
namespace {

using Chain = std::vector<std::uint32_t>;

/// Rooms in a row along +y, 10 m deep, a 2 m × 2 m door in every wall: room i spans y in [10 i, 10 i + 10].
/// Each room is a zone of its own, or all are one zone.
TestGraph rowOfRooms(int count, bool oneZone = false) {
    TestGraph world;
    for (int i = 0; i < count; ++i)
        world.addSpace(oneZone ? 0 : static_cast<std::uint32_t>(i));
    for (int i = 0; i + 1 < count; ++i) {
        world.link(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1),
                   uprightRectangle({0, 10.0 * (i + 1), 0}, {0, -1, 0}, 2, 2));
    }
    return world;
}

TEST(Flood, seesOnlyTheRootWithoutPortals) {
    TestGraph world;
    world.addSpace();
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 1u);
    EXPECT_EQ(set.region(set.visits[0]).size(), 4u);
    ASSERT_EQ(set.seen.size(), 1u);
    EXPECT_EQ(set.seen[0].space, 0u);
}

TEST(Flood, followsDoorsInLine) {
    const VisibleSet set = floodOnce(rowOfRooms(4).build(), viewFrom({0, 5, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 4u);
    EXPECT_EQ(chainOf(set, 3), (Chain{0, 1, 2, 3}));
    // The second door, 15 m away and 2 m wide, is seen through the first: ±1/15 of the screen.
    const Rect rect = boundsOf(set.region(set.visits[2]));
    EXPECT_NEAR(rect.maxX, 1.0 / 15.0, 1e-12);
    EXPECT_NEAR(rect.minY, -1.0 / 15.0, 1e-12);
    // Eye-relative entry plane: 5 m ahead, beyond is positive.
    EXPECT_NEAR(set.visits[1].entryPlane.signedDistance({0, 6, 0}), 1.0, 1e-12);
}

TEST(Flood, doesNotSeeDoorsBehindTheEyeOrOffTheScreen) {
    EXPECT_EQ(floodOnce(rowOfRooms(4).build(), viewFrom({0, 5, 0}, 180, 0, 0)).visits.size(), 1u);
    EXPECT_EQ(floodOnce(rowOfRooms(4).build(), viewFrom({0, 5, 0}, 90, 0, 0)).visits.size(), 1u);
}

TEST(Flood, followsTwoOpeningsOfASpaceWithoutDepth) {
    TestGraph world;
    for (int i = 0; i < 3; ++i)
        world.addSpace();
    const std::vector<Vec3> opening = uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2);
    world.link(0, 1, opening);
    world.link(1, 2, opening);
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 5, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 3u);
    EXPECT_EQ(chainOf(set, 2), (Chain{0, 1, 2}));
    EXPECT_EQ(ownerOf(set, {0, 0, 1}), 2u);
}

TEST(Flood, doesNotLeaveByAnotherOpeningInTheSameWall) {
    TestGraph world;
    for (int i = 0; i < 3; ++i)
        world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(1, 2, uprightRectangle({0.5, 10, 0}, {0, 1, 0}, 2, 2));
    EXPECT_EQ(floodOnce(world.build(), viewFrom({0, 5, 0}, 0, 0, 0)).visits.size(), 2u);
}

TEST(Flood, stopsAtAClosedFilling) {
    const Graph graph = rowOfRooms(4).build();
    std::vector<std::uint8_t> closed(graph.portals().size(), 0);
    for (std::size_t i = 0; i < closed.size(); ++i)
        closed[i] = graph.portals()[i].space == 1 && graph.portals()[i].destination == 2;
    const VisibleSet set = floodOnce(graph, viewFrom({0, 5, 0}, 0, 0, 0), {}, closed);
    ASSERT_EQ(set.visits.size(), 3u) << "two rooms, and the door between the second and the third";
    EXPECT_TRUE(set.visits[2].shut && set.visits[2].hole);
    EXPECT_EQ(set.visits[2].parent, 1u);
    EXPECT_EQ(set.seen.size(), 2u);
}

TEST(Flood, aShutOpeningWithinAZoneIsAVisitToo) {
    const Graph graph = rowOfRooms(4, true).build();
    std::vector<std::uint8_t> closed(graph.portals().size(), 0);
    EXPECT_EQ(floodOnce(graph, viewFrom({0, 5, 0}, 0, 0, 0), {}, closed).visits.size(), 1u);
    for (std::size_t i = 0; i < closed.size(); ++i) {
        closed[i] =
            graph.portals()[i].space + graph.portals()[i].destination == 3; // between 1 and 2, both ways
    }
    const VisibleSet set = floodOnce(graph, viewFrom({0, 5, 0}, 0, 0, 0), {}, closed);
    ASSERT_EQ(set.visits.size(), 2u);
    EXPECT_TRUE(set.visits[1].shut);
    EXPECT_EQ(set.seen.size(), 2u) << "the space behind it is not seen";
}

TEST(Flood, hasNoDistanceCutOff) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.link(0, 1, uprightRectangle({0, 40000.0, 0}, {0, -1, 0}, 2, 2));
    EXPECT_EQ(floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0)).visits.size(), 2u);
}

TEST(Flood, takesOnlyOnePathRoundALoop) {
    // Two rooms joined by two adjacent doors: each door shows the other room once, none leads back.
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.link(0, 1, uprightRectangle({-2, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(0, 1, uprightRectangle({2, 10, 0}, {0, -1, 0}, 2, 2));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_EQ(set.visits.size(), 3u);
}

/// Two rooms of one zone joined by two doors 2 m wide, with `apart` metres between their centres.
FloodCounts countsOfTwoDoors(double apart) {
    TestGraph world;
    world.addSpace(0);
    world.addSpace(0);
    world.link(0, 1, uprightRectangle({-apart / 2, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(0, 1, uprightRectangle({apart / 2, 10, 0}, {0, -1, 0}, 2, 2));
    return floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0)).counts;
}

TEST(Flood, insideAZoneOpeningsSideBySideAreFollowedAsOne) {
    EXPECT_EQ(countsOfTwoDoors(2.0).spaceVisits, 2u);
    EXPECT_EQ(countsOfTwoDoors(2.0).revisits, 0u);
}

TEST(Flood, insideAZoneOpeningsFarApartAreFollowedEachByItself) {
    EXPECT_EQ(countsOfTwoDoors(12.0).spaceVisits, 3u);
    EXPECT_EQ(countsOfTwoDoors(12.0).revisits, 1u);
}

TEST(Flood, inThePlaneInsideTheOpeningTheFarHalfBelongsToTheSpaceBehind) {
    const Graph graph = rowOfRooms(2).build();
    for (const double offset : {-0.0001, -0.0000004, 0.0, 0.0000004}) {
        const VisibleSet set = floodOnce(graph, viewFrom({0.2, 10 + offset, 0.1}, 90, 0, 0));
        ASSERT_EQ(set.visits.size(), 2u) << offset;
        EXPECT_EQ(set.visits[1].inPlane, offset > -0.0000005)
            << "from before the plane, rays leave where they cross it";
        EXPECT_EQ(chainOf(set, ownerOf(set, {-0.1, 0.3, 1})), (Chain{0, 1})) << "left of the view is north";
        EXPECT_EQ(chainOf(set, ownerOf(set, {0.1, 0.3, 1})), (Chain{0}));
    }
}

TEST(Flood, anEyeThatHasPassedAnOpeningBeginsBehindIt) {
    const Graph graph = rowOfRooms(3).build();
    for (const double past : {0.0000006, 0.0001, 0.00019}) {
        const View view = viewFrom({0.2, 10 + past, 0.1}, 90, 0, 0);
        EXPECT_EQ(spaceOfEye(graph, view.eye, 0), 1u);
        const VisibleSet set = floodOnce(graph, view);
        ASSERT_EQ(set.visits.size(), 2u) << past;
        EXPECT_EQ(set.visits[0].space, 1u);
        EXPECT_EQ(chainOf(set, ownerOf(set, {-0.1, 0.3, 1})), (Chain{1})) << "left of the view is north";
        EXPECT_EQ(chainOf(set, ownerOf(set, {0.1, 0.3, 1})), (Chain{1, 0}));
    }
}

TEST(Flood, anEyeStaysInItsRootInThePlaneTooFarPastItAndBesideIt) {
    const Graph graph = rowOfRooms(2).build();
    for (const double past : {-0.0001, 0.0, 0.0000004, 0.00021})
        EXPECT_EQ(spaceOfEye(graph, {0.2, 10 + past, 0.1}, 0), 0u) << past;
    EXPECT_EQ(spaceOfEye(graph, {3, 10.0001, 0.1}, 0), 0u);
}

TEST(Flood, anEyeThatHasPassedOneOpeningOfAnInexactPairBeginsBehindItOnlyIfThroughBoth) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2),
                      uprightRectangle({1, 10, 0}, {0, 1, 0}, 4, 2));
    const Graph graph = world.build();
    EXPECT_EQ(spaceOfEye(graph, {0.5, 10.0001, 0}, 0), 1u);
    EXPECT_EQ(spaceOfEye(graph, {-1.5, 10.0001, 0}, 0), 0u);
}

TEST(Flood, leavesNothingOutOfAViewOfSevenThousandCells) {
    TestGraph world;
    world.addSpace();
    for (std::uint32_t i = 0; i < 7000; ++i) {
        world.addSpace();
        world.link(
            0, i + 1,
            uprightRectangle({-7.0 + 0.2 * (i % 70), 10, -5.0 + 0.1 * (i / 70)}, {0, -1, 0}, 0.1, 0.05));
    }
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_EQ(set.counts.visitsCut, 0u);
    EXPECT_EQ(set.visits.size(), 7001u);
}

TEST(Flood, anOpeningInWhosePlaneTheEyeLiesIsNearerThanAnyOther) {
    // To the north, 0.3 micrometres ahead, an opening whose plane counts as containing the eye; to the east, 0.2
    // micrometres ahead, one that begins beside the eye.
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(0, 2, uprightRectangle({0.5000002, 10.9999998, 0}, {-1, 0, 0}, 2, 2));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0.5, 9.9999997, 0}, 30, 0, 0));
    ASSERT_GE(set.visits.size(), 2u);
    EXPECT_EQ(chainOf(set, ownerOf(set, {0, 0, 1})), (Chain{0, 1}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {-0.2, 0.1, 1})), (Chain{0, 1}));
}

TEST(Flood, ofAnotherSpaceOfTheZoneAnOpeningIsNotLeftAtTheEye) {
    // The eye is 5 micrometres past an opening of the space to the east, and in no opening of its own space.
    TestGraph world;
    world.addSpace(0);
    world.addSpace(0);
    world.addSpace(1);
    world.link(0, 1, uprightRectangle({1, 9, 0}, {-1, 0, 0}, 4, 2));
    world.link(1, 2, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 10.000005, 0}, 45, 0, 0));
    EXPECT_EQ(set.visits.size(), 1u);
    EXPECT_EQ(set.seen.size(), 2u);
}

TEST(Flood, raysLeaveAZoneAtTheEyeByWayOfItsInnerOpenings) {
    // The eye is in the plane of an opening to the north within the zone, and of one behind it to the east, out of the zone.
    TestGraph world;
    world.addSpace(0);
    world.addSpace(0);
    world.addSpace(1);
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(1, 2, uprightRectangle({0.5, 10, 0}, {-1, 0, 0}, 2, 2));
    const Vec3 eye(0.4999999, 9.9999999, 0);
    const VisibleSet north = floodOnce(world.build(), viewFrom(eye, 0, 0, 0)),
                     east = floodOnce(world.build(), viewFrom(eye, 90, 0, 0));
    EXPECT_EQ(chainOf(north, ownerOf(north, {0.5, 0, 1})), (Chain{0, 2}));
    EXPECT_EQ(chainOf(north, ownerOf(north, {-0.5, 0, 1})), Chain{0});
    EXPECT_EQ(chainOf(east, ownerOf(east, {-0.5, 0, 1})), (Chain{0, 2}));
}

TEST(Flood, inThePlaneBesideTheOpeningNothingIsLostOrFlooded) {
    const VisibleSet set = floodOnce(rowOfRooms(2).build(), viewFrom({3, 10, 0}, 270, 0, 0));
    EXPECT_EQ(set.visits.size(), 1u);
    for (const Vec3& v : set.regionVertices)
        EXPECT_TRUE(isFinite(v));
}

TEST(Flood, justBeforeADoorTheRegionIsTheWholeScreen) {
    for (const double distance : {0.03, 0.001, 0.00021}) {
        const VisibleSet set = floodOnce(rowOfRooms(2).build(), viewFrom({0, 10 - distance, 0}, 0, 0, 0));
        ASSERT_EQ(set.visits.size(), 2u);
        const Rect rect = boundsOf(set.region(set.visits[1]));
        EXPECT_NEAR(rect.minX, -1.0, 1e-12);
        EXPECT_NEAR(rect.maxY, 1.0, 1e-12);
    }
}

TEST(Flood, behindThePlaneOfItsOwnDoorTheEyeSeesNothingThroughIt) {
    EXPECT_EQ(floodOnce(rowOfRooms(2).build(), viewFrom({0, 10.01, 0}, 0, 0, 0)).visits.size(), 1u);
}

TEST(Flood, opensInexactPairsWhereBothPolygonsAre) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2),
                      uprightRectangle({1, 10, 0}, {0, 1, 0}, 4, 2));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 3u);
    EXPECT_TRUE(set.visits[2].narrowed);
    const Rect rect = boundsOf(set.region(set.visits[2]));
    EXPECT_NEAR(rect.minX, -0.1, 1e-12);
    EXPECT_NEAR(rect.maxX, 0.2, 1e-12);
    // The hole around it, within the portal's own polygon, is painted before.
    const Visit& hole = set.visits[1];
    EXPECT_TRUE(hole.hole);
    EXPECT_EQ(hole.zone, kNoZone);
    EXPECT_EQ(hole.space, kNone);
    EXPECT_EQ(hole.portal, set.visits[2].portal);
    EXPECT_NEAR(boundsOf(set.region(hole)).minX, -0.2, 1e-12);
    EXPECT_EQ(chainOf(set, ownerOf(set, {-0.15, 0, 1})), (Chain{0, kNone}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {0, 0, 1})), (Chain{0, 1}));
}

TEST(Flood, leavesNoHoleWhereTheWayBackIsLarger) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2),
                      uprightRectangle({0, 10, 0}, {0, 1, 0}, 5, 3));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 2u);
    EXPECT_FALSE(set.visits[1].hole || set.visits[1].narrowed);
}

TEST(Flood, aPortalThatLeadsNowhereIsAHoleAndHidesWhatLiesBehind) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkOneWay(0, kNone, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(0, 1, uprightRectangle({1, 20, 0}, {0, -1, 0}, 4, 2));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 3u);
    EXPECT_EQ(chainOf(set, ownerOf(set, {0.03, 0, 1})), (Chain{0, kNone}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {0.12, 0, 1})), (Chain{0, 1}));
    ASSERT_EQ(set.seen.size(), 2u) << "nothing is seen in a hole";
}

TEST(Flood, anEyePastTheOtherPlaneOfAnInexactPairButInItIsThroughThatPolygon) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2),
                      uprightRectangle({0, 9.9996, 0}, {0, 1, 0}, 4, 2));
    // 0.3 mm before the portal's plane, 0.1 mm behind the reciprocal's, whose edges are seen from the wrong
    // side.
    const VisibleSet set = floodOnce(world.build(), viewFrom({1.9999, 9.9997, 0.5}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 2u);
    EXPECT_EQ(set.visits[1].space, 1u);
    EXPECT_EQ(chainOf(set, ownerOf(set, {-0.9, 0, 1})), (Chain{0, 1}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {0.2, 0.5, 1})), (Chain{0, 1}));
}

TEST(Flood, partsOpeningsThatOverlapInACircleWithAHole) {
    // The hole is painted before its opening. A slanted third opening is behind the hole's middle and before
    // the opening.
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 8, 2),
                      uprightRectangle({3, 10, 0}, {0, 1, 0}, 1, 2));
    world.link(0, 2, {{-4, 14, -0.2}, {4, 8, -0.2}, {4, 8, 0.2}, {-4, 14, 0.2}});
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_GT(set.counts.cyclesSplit, 0u);
    EXPECT_EQ(chainOf(set, ownerOf(set, {-0.2, 0, 1})), (Chain{0, kNone}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {0.3, 0, 1})), (Chain{0, 2}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {0.3, 0.08, 1})), (Chain{0, 1}));
}

TEST(Flood, inThePlaneOfAnInexactPairBothPolygonsMustHoldTheEye) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2),
                      uprightRectangle({1, 10, 0}, {0, 1, 0}, 4, 2));
    const Graph graph = world.build();
    const VisibleSet inBoth = floodOnce(graph, viewFrom({0.5, 10, 0}, 0, 0, 0));
    ASSERT_EQ(inBoth.visits.size(), 2u);
    EXPECT_EQ(inBoth.visits[1].space, 1u);
    const VisibleSet inOne = floodOnce(graph, viewFrom({-1.5, 10, 0}, 0, 0, 0));
    ASSERT_EQ(inOne.visits.size(), 2u);
    EXPECT_TRUE(inOne.visits[1].hole && inOne.visits[1].inPlane);
}

TEST(Flood, drawsFarSiblingsAndAllTheirSubtreesFirst) {
    // From outside: a near house with a door, and behind it, on the same line of sight, a far house with two
    // rooms in a row. The near opening is drawn last.
    TestGraph world;
    const std::uint32_t outside = world.addSpace();
    const std::uint32_t nearRoom = world.addSpace();
    const std::uint32_t farRoom = world.addSpace();
    const std::uint32_t farCloset = world.addSpace();
    world.link(outside, nearRoom, uprightRectangle({0.5, 10, 0}, {0, -1, 0}, 2, 2));
    world.link(outside, farRoom, uprightRectangle({0, 30, 0}, {0, -1, 0}, 8, 8));
    world.link(farRoom, farCloset, uprightRectangle({0, 35, 0}, {0, -1, 0}, 8, 8));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, outside));
    ASSERT_EQ(set.visits.size(), 4u);
    EXPECT_EQ(set.visits[1].space, farRoom);
    EXPECT_EQ(set.visits[2].space, farCloset);
    EXPECT_EQ(set.visits[3].space, nearRoom);
    EXPECT_EQ(chainOf(set, ownerOf(set, {0.01, 0.01, 1})), (Chain{outside, nearRoom}));
    EXPECT_EQ(chainOf(set, ownerOf(set, {-0.1, 0.0, 1})), (Chain{outside, farRoom, farCloset}));
}

TEST(Flood, dropsASiblingWhollyCoveredByANearerOne) {
    TestGraph world;
    const std::uint32_t outside = world.addSpace();
    world.addSpace();
    world.addSpace();
    world.link(outside, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 6, 6));
    world.link(outside, 2, uprightRectangle({0, 30, 0}, {0, -1, 0}, 2, 2));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, outside));
    EXPECT_EQ(set.visits.size(), 2u);
}

TEST(Flood, cutsACircleOfOverlaps) {
    // Three long strips, each in front of the next: no order of whole strips is right.
    TestGraph world;
    const std::uint32_t outside = world.addSpace();
    const double turn = 2.0 * 3.14159265358979 / 3.0;
    for (int i = 0; i < 3; ++i) {
        world.addSpace();
        const double a = turn * i;
        const Vec3 along(std::cos(a), 0.15, std::sin(a)); // tilts away along its length
        const Vec3 across(-std::sin(a), 0, std::cos(a));
        const Vec3 centre = Vec3(0, 10, 0) + across * 1.5;
        world.linkOneWay(outside, static_cast<std::uint32_t>(i + 1),
                         {centre - along * 5.0 - across * 0.5, centre + along * 5.0 - across * 0.5,
                          centre + along * 5.0 + across * 0.5, centre - along * 5.0 + across * 0.5});
    }
    const View view = viewFrom({0, 0, 0}, 0, 0, outside);
    const VisibleSet set = floodOnce(world.build(), view);
    EXPECT_GT(set.counts.cyclesSplit, 0u);
    EXPECT_GT(set.visits.size(), 4u);
}

TEST(Flood, keepsTheLargestRegionsWhenTheBudgetIsReached) {
    TestGraph world;
    const std::uint32_t outside = world.addSpace();
    for (int i = 0; i < 9; ++i) {
        const double size = i == 4 ? 1.0 : 0.2;
        world.link(outside, world.addSpace(), uprightRectangle({-4.0 + i, 10, 0}, {0, -1, 0}, size, size));
    }
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, outside), Limits{2, {}});
    ASSERT_EQ(set.visits.size(), 2u);
    EXPECT_EQ(set.visits[1].space, 5u);
    EXPECT_EQ(set.counts.visitsCut, 8u);
}

TEST(Flood, mergesCellsOfOneZoneIntoOneVisit) {
    TestGraph world;
    for (int i = 0; i < 4; ++i)
        world.addSpace(7);
    for (std::uint32_t i = 0; i < 3; ++i)
        world.link(i, i + 1, uprightRectangle({0, 10.0 * (i + 1), 0}, {0, -1, 0}, 2, 2));
    const Graph graph = world.build();
    const VisibleSet ahead = floodOnce(graph, viewFrom({0, 5, 0}, 0, 0, 0));
    EXPECT_EQ(ahead.visits.size(), 1u);
    EXPECT_EQ(ahead.seen.size(), 4u);
    const VisibleSet away = floodOnce(graph, viewFrom({0, 5, 0}, 180, 0, 0));
    EXPECT_EQ(away.seen.size(), 1u) << "cells out of sight are culled inside a zone, too";
}

TEST(Flood, doesNotLeakThroughTheScreensEdgeInsideAZone) {
    // Looking past the door: it is off the screen to the right, half of it behind the eye.
    TestGraph world;
    for (int i = 0; i < 6; ++i)
        world.addSpace(0);
    for (std::uint32_t i = 0; i < 5; ++i)
        world.link(i, i + 1, uprightRectangle({0, 10.0 * (i + 1), 0}, {0, -1, 0}, 2, 2));
    EXPECT_EQ(floodOnce(world.build(), viewFrom({3, 9.5, 0}, 225, 0, 0)).seen.size(), 1u);
}

TEST(Flood, survivesSelfPortalsAndPolygonsWithoutArea) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkOneWay(0, 0, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.linkOneWay(0, 1, {{0, 5, 0}, {1, 5, 0}, {2, 5, 0}});
    world.linkOneWay(0, 1, {{0, 5, 0}, {1, 5, 0}});
    world.linkOneWay(0, 1, {});
    EXPECT_EQ(floodOnce(world.build(), viewFrom({0, 0, 0}, 0, 0, 0)).visits.size(), 1u);
}

} // namespace
} // namespace limen::visibility
