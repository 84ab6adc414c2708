#include "play/RootTracker.h"

#include <gtest/gtest.h>

namespace limen::play {
namespace {

/// One building cell, the box 0..4 m each way, with a door of 1 x 2 m in the middle of its south wall.
world::World houseWorld() {
    world::World world;
    world.spaces.resize(2);
    world::Space& room = world.spaces[1];
    room.cellId = 0xA9B40100;
    room.ofBuilding = true;
    room.bounds.min = Vec3(0.0);
    room.bounds.max = Vec3(4.0);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 n(0.0);
        n[axis] = 1.0;
        const auto next = static_cast<std::uint32_t>(world.cellBspNodes.size() + 1);
        world.cellBspNodes.push_back({{n, 0.0}, next});
        world.cellBspNodes.push_back({{-n, 4.0}, axis == 2 ? world::kNone : next + 1});
    }
    room.bspNodeCount = 6;
    world.portalCorners = {{1.5, 0, 0}, {1.5, 0, 2}, {2.5, 0, 2}, {2.5, 0, 0}};
    world.portals.resize(2);
    world::Portal &out = world.portals[0], &in = world.portals[1];
    out.space = 1;
    out.destination = 0;
    out.reciprocal = 1;
    out.cornerCount = 4;
    out.plane = {{0, 1, 0}, 0.0};
    in = out;
    in.space = 0;
    in.destination = 1;
    in.reciprocal = 0;
    in.firstCorner = 4;
    in.plane = {{0, -1, 0}, 0.0};
    for (std::size_t i = 4; i > 0; --i)
        world.portalCorners.push_back(world.portalCorners[i - 1]);
    room.portalCount = 1;
    world.spaces[0].firstPortal = 1;
    world.spaces[0].portalCount = 1;
    return world;
}

constexpr double kFrame = 0.05; // seconds

TEST(RootTracker, followsTheEyeThroughTheDoorAtOnce) {
    const world::World world = houseWorld();
    RootTracker tracker(world::kOutside);
    EXPECT_EQ(tracker.move(world, {2, -2, 1}, {2, 1, 1}, kFrame), 1u);
    EXPECT_EQ(tracker.move(world, {2, 1, 1}, {2, -2, 1}, kFrame), world::kOutside);
}

TEST(RootTracker, findsAnEyeThatFlewThroughTheWallAfterItsGrace) {
    const world::World world = houseWorld();
    RootTracker tracker(1);
    EXPECT_EQ(tracker.move(world, {2, 2, 1}, {9, 2, 1}, kFrame), 1u); // lost, within the grace time
    double seconds = kFrame;
    while (seconds < RootTracker::kGraceSeconds + 2 * kFrame) {
        (void)tracker.move(world, {9, 2, 1}, {9, 2, 1}, kFrame);
        seconds += kFrame;
    }
    EXPECT_EQ(tracker.root(), world::kOutside);
    for (int i = 0; i < 10; ++i) // and back in through the wall
        (void)tracker.move(world, {9, 2, 1}, {2, 2, 1}, kFrame);
    EXPECT_EQ(tracker.root(), 1u);
}

TEST(RootTracker, keepsTheSpaceWhileNothingIsWrong) {
    const world::World world = houseWorld();
    RootTracker tracker(1);
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(tracker.move(world, {2, 2, 1}, {1, 3, 2}, 1.0), 1u);
}

TEST(RootTracker, keepsARoomThatIsNotConvex) {
    world::World world = houseWorld();
    world.spaces[1].bspNodeCount = 2;
    world.cellBspNodes = {{{{-1, 0, 0}, 2.0}, world::kNone, 1},
                          {{{0, -1, 0}, 2.0}, world::kNone, world::kNone}};
    RootTracker tracker(1);
    EXPECT_EQ(tracker.move(world, {1, 3, 1}, {3, 1, 1}, 1.0), 1u);
    EXPECT_EQ(tracker.move(world, {3, 1, 1}, {3.5, 1, 1}, 1.0), 1u);
}

TEST(RootTracker, trustsTheSweepWhereACellHasNoTree) {
    world::World world = houseWorld();
    world.spaces[1].bspNodeCount = 0;
    RootTracker tracker(1);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(tracker.move(world, {2, 2, 1}, {2, 2, 1}, 1.0), 1u);
}

} // namespace
} // namespace limen::play
