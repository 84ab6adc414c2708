#include "visibility/Viewcone.h"
#include "visibility/GraphBuilder.h"

#include <gtest/gtest.h>

namespace limen::visibility {
namespace {

constexpr double kPixel = 0.002;

/// Looking north from (0,0,0) through a 2 m door 10 m away.
struct DoorView : ::testing::Test {
    DoorView() {
        GraphBuilder world;
        world.addSpace();
        world.addSpace();
        world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
        view = viewFrom({0, 0, 0}, 0, 0, 0);
        set = floodOnce(world.build(), view);
        cones.prepare(view, set, kPixel);
    }
    [[nodiscard]] Containment classify(std::uint32_t visit, const Sphere& ball) const {
        const SeenBall seen = cones.ballOf(ball);
        const Containment found = cones.classify(visit, seen);
        EXPECT_TRUE(found == Containment::Outside || cones.touches(visit, seen));
        return found;
    }
    View view;
    VisibleSet set;
    Viewcones cones;
};

TEST_F(DoorView, ABallBehindTheEyeIsOutsideEveryVisit) {
    EXPECT_EQ(classify(0, {{0, -5, 0}, 1.0}), Containment::Outside);
    EXPECT_EQ(classify(1, {{0, -5, 0}, 1.0}), Containment::Outside);
}

TEST_F(DoorView, ABallInTheRoomClearOfTheDoorIsInside) {
    EXPECT_EQ(classify(0, {{3, 5, 0}, 0.5}), Containment::Inside);
    EXPECT_EQ(classify(1, {{3, 5, 0}, 0.5}), Containment::Outside);
}

TEST_F(DoorView, ABallBeforeTheDoorIsInsideUnlessItReachesTheDoorsPlane) {
    EXPECT_EQ(classify(0, {{0, 5, 0}, 0.5}), Containment::Inside);
    EXPECT_EQ(classify(0, {{0, 9.7, 0}, 0.5}), Containment::Partial);
}

TEST_F(DoorView, ABallBehindTheDoorIsInsideTheSecondVisitOnlyIfWhollyFramed) {
    EXPECT_EQ(classify(1, {{0, 20, 0}, 0.5}), Containment::Inside);
    EXPECT_EQ(classify(1, {{2, 20, 0}, 0.5}), Containment::Partial);
    EXPECT_EQ(classify(1, {{4, 20, 0}, 0.5}), Containment::Outside);
    EXPECT_EQ(classify(1, {{0, 9, 0}, 0.5}), Containment::Outside) << "it lies before the entry plane";
}

TEST_F(DoorView, WhatTouchesNoVisitIsOutside) {
    EXPECT_FALSE(cones.touches(0, cones.ballOf({{0, -5, 0}, 1.0})));
    EXPECT_FALSE(cones.touches(1, cones.ballOf({{4, 20, 0}, 0.5})));
    EXPECT_FALSE(cones.touches(1, cones.ballOf({{0, 9, 0}, 0.5})));
}

TEST_F(DoorView, ABallLiesToARectangleAsToARegion) {
    const FourEdges left = cones.edgesOf({-1, -1, 0, 1});
    const auto at = [&](const Vec3& centre) {
        return Viewcones::classify(left, cones.ballOf({centre, 0.5}));
    };
    EXPECT_EQ(at({-4, 10, 0}), Containment::Inside);
    EXPECT_EQ(at({-0.4, 10, 0}), Containment::Partial);
    EXPECT_EQ(at({0.4, 10, 0}), Containment::Partial);
    EXPECT_EQ(at({2, 10, 0}), Containment::Outside);
    EXPECT_EQ(at({-4, -10, 0}), Containment::Outside);
    EXPECT_TRUE(Viewcones::touches(left, cones.ballOf({{0.4, 10, 0}, 0.5})));
    EXPECT_FALSE(Viewcones::touches(left, cones.ballOf({{2, 10, 0}, 0.5})));
}

} // namespace
} // namespace limen::visibility
