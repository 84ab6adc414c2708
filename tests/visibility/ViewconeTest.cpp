#include "visibility/Viewcone.h"
#include "visibility/GraphBuilder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

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
        return cones.classify(visit, seen);
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
}

/// Balls in arrays, as many as a block has.
struct Block {
    std::array<double, BallBlock::kCount> x{}, y{}, z{}, radius{};
    [[nodiscard]] BallBlock view() const { return {x.data(), y.data(), z.data(), radius.data()}; }
};

/// Looking somewhere from a place whose coordinates floats would round, at balls all around: every fourth just touches an edge
/// of the picture or of the rectangle, or just does not.
struct Crowd : ::testing::Test {
    Crowd() {
        GraphBuilder world;
        world.addSpace();
        view = viewFrom(eye, 40, -10, 0);
        set = floodOnce(world.build(), view);
        cones.prepare(view, set, kPixel);
        rect = cones.edgesOf({-0.4, -0.9, 0.3, 0.2});
    }
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(dice); }
    Sphere ball() { return {{between(-1, 1), between(-1, 1), between(-1, 1)}, between(0.0, 2.0)}; }
    /// Moves it so that, up to roundings, it reaches one of the rectangle's edges and no farther.
    Sphere atAnEdge(Sphere ball) {
        const Vec3 edge = rect.edge(std::uniform_int_distribution<std::size_t>(0, 3)(dice));
        for (int i = 0; i < 20; ++i) {
            const SeenBall seen = cones.ballOf(ball);
            ball.centre -= edge * (glm::dot(edge, ball.centre) + seen.radius + seen.reach);
        }
        ball.centre += edge * between(-1e-9, 1e-9);
        return ball;
    }
    const Vec3 eye{19200.1, 7300.7, 84.3};
    std::mt19937 dice{7};
    View view;
    VisibleSet set;
    Viewcones cones;
    FourEdges rect;
};

TEST_F(Crowd, IsToldApartSideBySideAsOneByOne) {
    int seen = 0, few = 0;
    for (int round = 0; round < 5000; ++round) {
        Block block;
        for (std::size_t i = 0; i < BallBlock::kCount; ++i) {
            Sphere one = ball();
            one.centre *= std::pow(10.0, between(0.0, 3.5));
            if (i % 4 == 0 && round % 2 == 0) {
                one = atAnEdge(one);
            }
            block.x[i] = eye.x + one.centre.x;
            block.y[i] = eye.y + one.centre.y;
            block.z[i] = eye.z + one.centre.z;
            block.radius[i] = one.radius;
        }
        const Viewcones::Within all = cones.within(block.view(), eye, nullptr);
        const Viewcones::Within some = cones.within(block.view(), eye, &rect);
        for (std::size_t i = 0; i < BallBlock::kCount; ++i) {
            const SeenBall one =
                cones.ballOf({Vec3(block.x[i], block.y[i], block.z[i]) - eye, block.radius[i]});
            const bool isSeen = cones.classify(0, one) != Containment::Outside;
            const bool isWithin = isSeen && Viewcones::classify(rect, one) != Containment::Outside;
            ASSERT_EQ(all[i] >= 0.0f, isSeen) << round << ' ' << i;
            ASSERT_EQ(some[i] >= 0.0f, isWithin) << round << ' ' << i;
            seen += isSeen ? 1 : 0;
            few += isWithin ? 1 : 0;
        }
    }
    EXPECT_GT(few, 1000);
    EXPECT_GT(seen, few);
}

} // namespace
} // namespace limen::visibility
