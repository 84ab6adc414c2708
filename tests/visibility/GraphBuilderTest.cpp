#include "visibility/GraphBuilder.h"
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>

namespace limen::visibility {
namespace {

using testing::Test;

/// A doorway 2 m wide in a wall y = `y`, counter-clockwise seen from the south.
std::vector<Vec3> doorway(double y) {
    return {{1, y, 0}, {3, y, 0}, {3, y, 2}, {1, y, 2}};
}

TEST(GraphBuilder, makesTheArraysOfAGraph) {
    GraphBuilder builder;
    const std::uint32_t yard = builder.addSpace(), hall = builder.addSpace(), parlour = builder.addSpace();
    const std::uint32_t inner = builder.addOpening({.from = hall, .to = parlour, .polygon = doorway(5)});
    const std::uint32_t front = builder.addOpening({.from = yard, .to = hall, .polygon = doorway(0)});
    const auto built = builder.build();
    ASSERT_TRUE(built) << built.error().message();
    const auto portals = built->graph.portals();
    ASSERT_EQ(portals.size(), 4u);
    const PortalPair door = built->openings[front];
    EXPECT_EQ(portals[door.out].space, yard);
    EXPECT_EQ(portals[door.out].destination, hall);
    EXPECT_EQ(portals[door.out].reciprocal, door.back);
    EXPECT_EQ(portals[door.back].space, hall);
    EXPECT_EQ(portals[door.back].reciprocal, door.out);
    EXPECT_EQ(portals[door.out].plane.n, -portals[door.back].plane.n);
    EXPECT_EQ(portals[built->openings[inner].out].destination, parlour);
    EXPECT_EQ(floodOnce(built->graph, viewFrom({2, -2, 1}, 0, 0, yard)).visits.size(), 3u);
    std::vector<std::uint8_t> closed(portals.size(), 0);
    closed[built->openings[inner].out] = 1;
    const VisibleSet shut = floodOnce(built->graph, viewFrom({2, -2, 1}, 0, 0, yard), {}, closed);
    ASSERT_EQ(shut.visits.size(), 3u);
    EXPECT_TRUE(shut.visits[2].shut);
}

TEST(GraphBuilder, knowsOneWayOpeningsInexactPairsAndZones) {
    GraphBuilder builder;
    const std::uint32_t a = builder.addSpace(), b = builder.addSpaceInZoneOf(a), c = builder.addSpace();
    std::vector<Vec3> larger{{3.5, 0, 0}, {0.5, 0, 0}, {0.5, 0, 2}, {3.5, 0, 2}};
    builder.addOpening({.from = a, .to = b, .polygon = doorway(0), .backPolygon = larger});
    builder.addOpening({.from = b, .to = c, .polygon = doorway(5), .oneWay = true});
    builder.addOpening({.from = c, .polygon = doorway(9)});
    const auto built = builder.build();
    ASSERT_TRUE(built) << built.error().message();
    ASSERT_EQ(built->graph.portals().size(), 4u);
    const auto portal = [&](std::uint32_t i) { return built->graph.portals()[i]; };
    EXPECT_FALSE(portal(built->openings[0].out).exact || portal(built->openings[0].back).exact);
    EXPECT_EQ(built->graph.polygon(portal(built->openings[0].back))[0], larger[0]);
    EXPECT_EQ(built->openings[1].back, kNone);
    EXPECT_EQ(portal(built->openings[1].out).reciprocal, kNone);
    EXPECT_EQ(portal(built->openings[2].out).destination, kNone);
    EXPECT_EQ(built->graph.spaces()[a].zone, built->graph.spaces()[b].zone);
    EXPECT_NE(built->graph.spaces()[a].zone, built->graph.spaces()[c].zone);
}

std::string faultOf(OpeningDesc opening) {
    GraphBuilder builder;
    builder.addSpace();
    builder.addSpace();
    builder.addOpening(std::move(opening));
    const auto built = builder.build();
    EXPECT_FALSE(built);
    return built ? "" : built.error().message();
}

TEST(GraphBuilder, namesTheFaultOfAnOpening) {
    EXPECT_EQ(faultOf({.from = 0, .to = 7, .polygon = doorway(0)}),
              "opening 0, from space 0: there are 2 spaces, and none is number 7");
    EXPECT_EQ(faultOf({.from = kNone, .to = 1, .polygon = doorway(0)}).substr(0, 9), "opening 0");
    EXPECT_EQ(faultOf({.from = 0, .to = 1, .polygon = {{0, 0, 0}, {1, 0, 0}}}),
              "opening 0, from space 0: its polygon has fewer than three corners");
    EXPECT_EQ(faultOf({.from = 0, .to = 1, .polygon = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}),
              "opening 0, from space 0: its polygon has no area");
    EXPECT_EQ(faultOf({.from = 0, .to = 1, .polygon = {{0, 0, 0}, {1, 0, 0}, {1, 0.3, 1}, {0, 0, 1}}}),
              "opening 0, from space 0: its polygon is not flat");
    EXPECT_EQ(faultOf({.from = 0, .to = 1, .polygon = {{0, 0, 0}, {2, 0, 0}, {0.2, 0, 0.2}, {0, 0, 2}}}),
              "opening 0, from space 0: its polygon is not convex");
    EXPECT_EQ(faultOf({.from = 0, .to = 1, .polygon = {{0, 0, 0}, {NAN, 0, 0}, {0, 0, 1}}}),
              "opening 0, from space 0: its polygon has a corner that is not finite");
    EXPECT_EQ(faultOf({.from = 0, .to = 1, .polygon = doorway(0), .backPolygon = doorway(0)}).substr(0, 71),
              "opening 0, from space 0: its two polygons face the same side; list the ");
}

TEST(GraphBuilder, refusesAZoneOfALaterSpace) {
    GraphBuilder builder;
    builder.addSpaceInZoneOf(3);
    EXPECT_FALSE(builder.build());
}

TEST(ViewOf, looksAtTheTarget) {
    const auto view =
        viewOf({.eye = {1, 2, 3}, .target = {1, 9, 3}, .heightDegrees = 90, .aspect = 2, .root = 4});
    ASSERT_TRUE(view);
    EXPECT_EQ(view->root, 4u);
    EXPECT_NEAR(glm::length(view->forward - Vec3(0, 1, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::length(view->right - Vec3(1, 0, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::length(view->up - Vec3(0, 0, 1)), 0, 1e-15);
    EXPECT_NEAR(view->tanHalfY, 1, 1e-15);
    EXPECT_NEAR(view->tanHalfX, 2, 1e-15);
}

TEST(ViewOf, refusesViewsThatHaveNoAxes) {
    EXPECT_FALSE(viewOf({.eye = {0, 1, 0}, .target = {0, 1, 0}}));
    EXPECT_FALSE(viewOf({.target = {0, 0, 5}}));
    EXPECT_FALSE(viewOf({.target = {0, NAN, 0}}));
    EXPECT_FALSE(viewOf({.heightDegrees = 180}));
    EXPECT_FALSE(viewOf({.aspect = 0}));
}

} // namespace
} // namespace limen::visibility
