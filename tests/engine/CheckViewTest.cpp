#include "engine/CheckView.h"

#include "support/SmallWorld.h"

#include <gtest/gtest.h>

namespace limen::engine {
namespace {

world::World worldWithDoors() {
    world::World world = test::smallWorld();
    world.doors.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
        world.doors[i].name = std::string(1, static_cast<char>('a' + i));
    world.doors[1].open = 0.5;
    return world;
}

FrameRequest someEye() {
    FrameRequest eye;
    eye.camera = {{1, 2, 3}, {30, -5}, 75};
    eye.size = {640, 360};
    eye.root = 1;
    eye.scene.player = {4, 5, 6};
    eye.scene.time = 0.25;
    eye.scene.seconds = 7.5;
    eye.scene.dayGroup = 2;
    eye.scene.weather = Weather::Rain;
    eye.scene.look = Look::Enhanced;
    eye.scene.eachDoor = {0.0, 0.5, 0.75};
    return eye;
}

void expectSame(const FrameRequest& a, const FrameRequest& b) {
    EXPECT_EQ(a.camera.eye, b.camera.eye);
    EXPECT_EQ(a.camera.heading.yaw, b.camera.heading.yaw);
    EXPECT_EQ(a.camera.heading.pitch, b.camera.heading.pitch);
    EXPECT_EQ(a.camera.fovDegrees, b.camera.fovDegrees);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.root, b.root);
    EXPECT_EQ(a.scene.body, b.scene.body);
    EXPECT_EQ(a.scene.time, b.scene.time);
    EXPECT_EQ(a.scene.seconds, b.scene.seconds);
    EXPECT_EQ(a.scene.dayGroup, b.scene.dayGroup);
    EXPECT_EQ(a.scene.weather, b.scene.weather);
    EXPECT_EQ(a.scene.look, b.scene.look);
    EXPECT_EQ(a.scene.doors, b.scene.doors);
}

TEST(CheckView, thereAndBackIsTheSame) {
    const world::World world = worldWithDoors();
    FrameRequest eye = someEye();
    expectSame(requestOf(viewOf(eye, world), world, eye.root), eye);
    EXPECT_EQ(requestOf(viewOf(eye, world), world, eye.root).scene.player, eye.scene.player);
    EXPECT_EQ(requestOf(viewOf(eye, world), world, eye.root).scene.eachDoor, eye.scene.eachDoor);
    eye.scene.body = motion::PlayerBody{{7, 8, 9}, 180.0, 1, 0.5};
    expectSame(requestOf(viewOf(eye, world), world, eye.root), eye);
    eye.scene.doors = 0.25;
    expectSame(requestOf(viewOf(eye, world), world, eye.root), eye);
}

TEST(CheckView, namesOnlyDoorsThatDoNotRest) {
    const check::View view = viewOf(someEye(), worldWithDoors());
    ASSERT_EQ(view.eachDoor.size(), 1u);
    EXPECT_EQ(view.eachDoor[0].name, "c");
    EXPECT_EQ(view.eachDoor[0].open, 0.75);
}

TEST(CheckView, shotOptionsSayAllOfIt) {
    FrameRequest eye = someEye();
    eye.scene.body = motion::PlayerBody{{7, 8, 9}, 180.0, 1, 0.5, 2.2, 17.5};
    EXPECT_EQ(
        check::shotOptions(viewOf(eye, worldWithDoors())),
        "--eye=1,2,3 --yaw=30 --pitch=-5 --fov=75 --size=640x360 --root=0xA9B40105 --time=0.25 --seconds=7.5 "
        "--door='c=0.75' --day=2 --weather=rain --look=enhanced --body=7,8,9 --body-yaw=180 "
        "--body-root=0xA9B40105 "
        "--body-opacity=0.5 --body-speed=2.2 --body-metres=17.5");
}

TEST(CheckView, theCommandHasTheReadingsOfItsWorld) {
    world::World world = worldWithDoors();
    EXPECT_EQ(reproduction(world, someEye(), " --dat x").find("readings"), std::string::npos);
    world.readings.cellFog = world::CellFog::None;
    world.readings.levelBias = 0.0;
    EXPECT_TRUE(reproduction(world, someEye(), " --dat x")
                    .starts_with("limen shot --dat x --readings=cell-fog=none,level-bias=0 --eye="));
}

} // namespace
} // namespace limen::engine
