#include "play/CameraPath.h"

#include <gtest/gtest.h>

namespace limen::play {
namespace {

world::Place wayPoint(const Vec3& eye, double yaw, double pitch = 0.0) {
    world::Place place;
    place.eye = eye;
    place.yaw = yaw;
    place.pitch = pitch;
    return place;
}

TEST(CameraPath, startsAndEndsAtItsWayPoints) {
    const std::vector<world::Place> points{wayPoint({0, 0, 0}, 10), wayPoint({6, 0, 0}, 20),
                                           wayPoint({6, 9, 0}, 350, -30)};
    const CameraPath path(points);
    EXPECT_DOUBLE_EQ(path.seconds(), 15.0 / CameraPath::kWalkingSpeed);
    EXPECT_EQ(path.at(0.0).eye, points.front().eye);
    EXPECT_EQ(path.at(path.seconds()).eye, points.back().eye);
    EXPECT_EQ(path.at(path.seconds()).heading.pitch, -30.0);
    EXPECT_EQ(path.at(-5.0).eye, points.front().eye);
    EXPECT_EQ(path.at(1e9).eye, points.back().eye);
}

TEST(CameraPath, walksStraightAtOnePace) {
    const CameraPath path(std::vector<world::Place>{wayPoint({0, 0, 0}, 0), wayPoint({30, 0, 0}, 0)});
    for (double t = 0.0; t < path.seconds(); t += 0.5)
        EXPECT_NEAR(path.at(t).eye.x, t * CameraPath::kWalkingSpeed, 1e-9);
}

TEST(CameraPath, turnsTheShortWayRound) {
    const CameraPath path(std::vector<world::Place>{wayPoint({0, 0, 0}, 350), wayPoint({30, 0, 0}, 10)});
    EXPECT_NEAR(path.at(path.seconds() / 2).heading.yaw, 360.0, 1e-9);
    EXPECT_DOUBLE_EQ(shortTurn(350, 10), 20.0);
    EXPECT_DOUBLE_EQ(shortTurn(10, 350), -20.0);
}

TEST(CameraPath, takesTimeToTurnOnTheSpot) {
    const CameraPath path(std::vector<world::Place>{wayPoint({0, 0, 0}, 0), wayPoint({0, 0, 0}, 140)});
    EXPECT_DOUBLE_EQ(path.seconds(), 140.0 / CameraPath::kTurningSpeed);
}

TEST(CameraPath, namesTheCornersAStepCutsOff) {
    const CameraPath path(
        std::vector<world::Place>{wayPoint({0, 0, 0}, 0), wayPoint({3, 0, 0}, 0), wayPoint({3, 3, 0}, 0)});
    std::vector<CameraPath::Corner> corners;
    path.cornersBetween(0.5, 1.5, corners);
    ASSERT_EQ(corners.size(), 1u);
    EXPECT_EQ(corners[0].eye, Vec3(3, 0, 0));
    EXPECT_FALSE(corners[0].isJump);
    path.cornersBetween(1.0, 2.0, corners);
    EXPECT_TRUE(corners.empty());
}

TEST(CameraPath, restsBeforeAJumpIntoADungeonAndPassesNothingBetween) {
    world::Place dungeon = wayPoint({9000, 9000, 5}, 90);
    dungeon.cell = 0x01020100;
    const CameraPath path(std::vector<world::Place>{wayPoint({0, 0, 0}, 0), wayPoint({3, 0, 0}, 0), dungeon});
    EXPECT_DOUBLE_EQ(path.seconds(), 1.0 + CameraPath::kJumpSeconds);
    EXPECT_EQ(path.at(1.0 + 0.9 * CameraPath::kJumpSeconds).eye, Vec3(3, 0, 0));
    EXPECT_EQ(path.at(path.seconds()).eye, dungeon.eye);
    std::vector<CameraPath::Corner> corners;
    path.cornersBetween(1.5, path.seconds(), corners);
    ASSERT_EQ(corners.size(), 1u);
    EXPECT_TRUE(corners[0].isJump);
    EXPECT_EQ(corners[0].cell, dungeon.cell);
}

TEST(CameraPath, keepsThePaceOfARecording) {
    std::vector<world::Place> points;
    for (int i = 0; i < 100; ++i)
        points.push_back(wayPoint({i < 50 ? i * 1.0 : 49.0 + (i - 49) * 0.01, 0, 0}, i * 3.0));
    EXPECT_NEAR(CameraPath(points).seconds(), 99 * CameraPath::kRecordedStep, 1e-9);
    points.back().eye.x += 20.0; // one long step makes it an ordinary path
    EXPECT_GT(CameraPath(points).seconds(), 99 * CameraPath::kRecordedStep + 1.0);
}

TEST(CameraPath, copesWithNoneAndOneWayPoint) {
    EXPECT_TRUE(CameraPath({}).empty());
    const CameraPath one(std::vector<world::Place>{wayPoint({1, 2, 3}, 45)});
    EXPECT_EQ(one.seconds(), 0.0);
    EXPECT_EQ(one.at(3.0).eye, Vec3(1, 2, 3));
    EXPECT_EQ(one.timeOfFrame(5, 10), 0.0);
}

} // namespace
} // namespace limen::play
