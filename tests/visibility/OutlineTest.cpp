#include "visibility/Outline.h"

#include "visibility/Region.h"
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>

namespace limen::visibility {
namespace {

/// A square of 2 m at y = 10, counter-clockwise from the origin.
const std::vector<Vec3> kSquare{{-1, 10, -1}, {1, 10, -1}, {1, 10, 1}, {-1, 10, 1}};

std::vector<Vec3> hullOf(const std::vector<Vec3>& outline) {
    std::vector<Vec3> hull, swap;
    hullSeenFrom(Vec3(0.0), outline, {0, -1, 0}, hull, swap);
    return hull;
}

TEST(Outline, aConvexPolygonStaysAsItIs) {
    EXPECT_EQ(hullOf(kSquare), kSquare);
}

TEST(Outline, ofAPolygonBentAroundTheEyeOnlyWhatLiesAheadIsLeft) {
    const auto hull = hullOf({{-1, 0.001, -1}, {1, 0.001, -1}, {1, 0.001, 0}, {0, -0.001, 1}});
    ASSERT_EQ(hull.size(), 5u);
    for (const Vec3& v : hull)
        EXPECT_GE(v.y, 0.0);
}

TEST(Outline, keepsWhatBulgesAndDropsWhatDents) {
    const Vec3 bulge(0, 10, -1.0002), dent(0, 10, 0.9998);
    const auto hull = hullOf({kSquare[0], bulge, kSquare[1], kSquare[2], dent, kSquare[3]});
    EXPECT_EQ(hull, (std::vector<Vec3>{kSquare[0], bulge, kSquare[1], kSquare[2], kSquare[3]}));
}

TEST(Outline, keepsTheHullOfSeveralOnOneEdge) {
    const Vec3 first(-1.0002, 10, 0.6), second(-1.0001, 10, 0.2), third(-1.0002, 10, -0.6);
    const auto hull = hullOf({kSquare[0], kSquare[1], kSquare[2], kSquare[3], first, second, third});
    EXPECT_EQ(hull, (std::vector<Vec3>{kSquare[0], kSquare[1], kSquare[2], kSquare[3], first, third}));
}

TEST(Outline, bulgesAreSeenWhereTheyAppear) {
    // A vertex moved off the plane towards the eye appears farther out; moved away from the eye, farther in.
    const Vec3 before(0, 9.9998, -1), behind(0, 10.0002, -1);
    EXPECT_EQ(hullOf({kSquare[0], before, kSquare[1], kSquare[2], kSquare[3]}).size(), 5u);
    EXPECT_EQ(hullOf({kSquare[0], behind, kSquare[1], kSquare[2], kSquare[3]}).size(), 4u);
}

TEST(Outline, aCornerOffThePlaneLeavesNoDent) {
    // Nearly collinear with its neighbours. Behind the plane it appears inside the line between them.
    const Vec3 corner(-1.00001, 10.0005, 0);
    EXPECT_EQ(hullOf({kSquare[0], kSquare[1], kSquare[2], kSquare[3], corner}), kSquare);
}

TEST(Outline, theFloodsRegionHoldsWhatBulges) {
    std::vector<Vec3> vertices = kSquare;
    for (const Vec3& v : {kSquare[0], Vec3(0, 10, -1.0002), kSquare[1], kSquare[2], kSquare[3]})
        vertices.push_back(v);
    const std::vector<SpaceDesc> spaces{{0, 1, 0}, {1, 0, 1}};
    const std::vector<PortalDesc> portals{{0, 1, kNone, 0, 4, true, 4, 5}};
    const auto graph = Graph::build(spaces, portals, vertices);
    ASSERT_TRUE(graph.has_value());
    const VisibleSet set = floodOnce(*graph, viewFrom({0, 0, 0}, 0, 0, 0));
    ASSERT_EQ(set.visits.size(), 2u);
    EXPECT_NEAR(boundsOf(set.region(set.visits[1])).minY, -0.10002, 1e-12);
    EXPECT_NEAR(boundsOf(set.region(set.visits[1])).maxY, 0.1, 1e-12);
}

} // namespace
} // namespace limen::visibility
