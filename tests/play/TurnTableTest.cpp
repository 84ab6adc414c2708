#include "play/TurnTable.h"

#include "support/MovingHut.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limen::play {
namespace {

TEST(TurnTable, theCameraKeepsItsDistanceAndLooksAtTheCentre) {
    const engine::Camera centre{{10.0, 20.0, 3.0}, {40.0, 5.0}, 55.0};
    const TurnTableCircle circle{8.0, 25.0};
    for (const double share : {0.0, 0.25, 0.6, 1.0}) {
        const engine::Camera camera = turnTableCamera(centre, circle, share);
        EXPECT_NEAR(glm::length(camera.eye - centre.eye), 8.0, 1e-9);
        const Vec3 forward = engine::basisOf(camera.heading).forward;
        EXPECT_NEAR(glm::dot(forward, glm::normalize(centre.eye - camera.eye)), 1.0, 1e-9);
        EXPECT_NEAR(camera.eye.z - centre.eye.z, 8.0 * std::sin(25.0 * 0.017453292519943295), 1e-9);
        EXPECT_EQ(camera.fovDegrees, 55.0);
    }
    EXPECT_NEAR(turnTableCamera(centre, circle, 0.0).heading.yaw, 40.0, 1e-9);
    EXPECT_NEAR(turnTableCamera(centre, circle, 0.25).heading.yaw, 130.0, 1e-9);
}

TEST(TurnTable, withoutDistanceTheCameraTurnsAtThePlace) {
    const engine::Camera centre{{10.0, 20.0, 3.0}, {40.0, 5.0}, 55.0};
    const engine::Camera camera = turnTableCamera(centre, {}, 0.5);
    EXPECT_EQ(camera.eye, centre.eye);
    EXPECT_EQ(camera.heading.pitch, 5.0);
    EXPECT_NEAR(std::abs(camera.heading.yaw), 140.0, 1e-9);
}

TEST(TurnTable, theCircleIsTheLargestThatNoWallCrosses) {
    test::MovingHut hut;
    const world::World world = hut.load();
    const TurnTableCircle meadow = chooseCircle(world, world::kOutside, hut.at({60, 60, 4}), {});
    EXPECT_EQ(meadow.distance, 24.0);
    EXPECT_EQ(meadow.elevation, 12.0);
    // Beside the hut's wall, a steeper circle looks over the roof, which is 1.5 m above the centre.
    const TurnTableCircle beside = chooseCircle(world, world::kOutside, hut.at({8, 12, 3.7}), {});
    EXPECT_GT(beside.distance, 0.0);
    EXPECT_GT(beside.elevation, 12.0);
    // The rooms have 4 m by 4 m: no circle of 3 m fits.
    world::SpaceIndex room = world::kOutside;
    while (world.spaces[room].cellId != hut.source.id(hut.front))
        ++room;
    EXPECT_EQ(chooseCircle(world, room, hut.at({12, 12, 3.5}), {}).distance, 0.0);
    EXPECT_EQ(chooseCircle(world, room, hut.at({12, 12, 3.5}), 1.5).distance, 1.5);
    // A camera around the hut is outside, although a wall is between it and the centre.
    EXPECT_EQ(turnTableRoot(world, room, hut.at({12, 12, 3.5}), hut.at({30, 12, 6})), world::kOutside);
    EXPECT_EQ(turnTableRoot(world, room, hut.at({12, 12, 3.5}), hut.at({11, 12, 3.5})), room);
}

} // namespace
} // namespace limen::play
