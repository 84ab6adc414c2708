// Hard cases 23 and 27 of docs/cases.md: a third-person camera behind a body that walks through doors, backs
// against walls and stands still.
#include "motion/ChaseCamera.h"

#include "geometry/Compass.h"
#include "geometry/Tolerances.h"
#include "motion/Hut.h"
#include "motion/Locate.h"
#include "motion/Walker.h"

#include <random>

namespace limen::motion {
namespace {

using test::boxExterior;
using test::frameAt;
using test::Hut;
using test::kYawEast;
using test::kYawNorth;
using test::kYawWest;
using test::Walker;
using world::kOutside;

constexpr double kCameraFrame = 0.03;
constexpr double kCameraRadius = ChaseShape().radius;

Vec3 direction(double yaw, double pitch = 0.0) {
    return turnedTo(yaw) * Vec3(0.0, std::cos(glm::radians(pitch)), std::sin(glm::radians(pitch)));
}

/// A body with a camera behind it.
struct Chase {
    explicit Chase(Hut& of, const world::MovingEntries& moving = {}) : hut(of), walker(of.source, moving) {}

    void put(const Vec3& local, world::SpaceIndex space) {
        walker.put(local, space);
        camera = {};
    }
    void frame(double yaw, double pitch = 0.0, double walks = 0.0) {
        const BodyInput input{.forward = walks, .yaw = yaw};
        walker.body = moved(walker.body, input, kCameraFrame, walker.collisions(), walker.doors);
        camera = chased(camera, walker.body, direction(yaw, pitch), kCameraFrame, walker.collisions(),
                        walker.doors);
    }
    void go(double yaw, double seconds, double pitch = 0.0, double walks = 0.0) {
        for (double t = 0.0; t < seconds; t += kCameraFrame)
            frame(yaw, pitch, walks);
    }
    [[nodiscard]] Vec3 eye() const { return camera.eye.position - walker.at(0, 0, 0); }
    [[nodiscard]] Vec3 head() const { return walker.feet() + Vec3(0.0, 0.0, BodyShape().eyeHeight); }
    /// Whether the camera's sphere overlaps nothing, up to Bullet's rounding.
    [[nodiscard]] bool isInNothing() const {
        const Capsule sphere{kCameraRadius, 2.0 * kCameraRadius};
        const Standing at{camera.eye.position - Vec3(0.0, 0.0, kCameraRadius), camera.eye.space};
        return glm::length(walker.collisions().wayOut(sphere, at, walker.doors)) < 0.002;
    }
    /// Whether the camera is in its space. It changes its space at the plane of an opening, but `locate` has a point up to
    /// kInPlaneTolerance outside a cell inside: between the two, both spaces are right.
    [[nodiscard]] bool isWhereItSays() const {
        constexpr double kBeside = 1.01 * kInPlaneTolerance;
        for (const Vec3& beside : {Vec3(0.0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
            if (locate(walker.world(), camera.eye.position + kBeside * beside).space == camera.eye.space)
                return true;
        return false;
    }

    Hut& hut;
    Walker walker;
    ChaseState camera;
};

TEST(ChaseCamera, goesBehindAndAboveTheHead) {
    Hut hut;
    Chase chase(hut);
    chase.put({40, 40, 2.01}, kOutside);
    chase.go(kYawEast, 5.0);
    EXPECT_LT(glm::length(chase.eye() - (chase.head() + Vec3(-3.0, 0.0, 0.4))), 1e-6);
    EXPECT_EQ(chase.camera.eye.space, kOutside);
}

TEST(ChaseCamera, comesOutByAndBy) {
    Hut hut;
    Chase chase(hut);
    chase.put({40, 40, 2.01}, kOutside);
    double before = -1.0;
    for (int i = 0; i < 20; ++i) {
        chase.frame(kYawNorth);
        EXPECT_GT(chase.camera.arm, before);
        EXPECT_LT(chase.camera.arm - before, 1.5);
        before = chase.camera.arm;
    }
    EXPECT_LT(before, 3.0);
}

TEST(ChaseCamera, case27_comesToRestToTheBit) {
    Hut hut;
    Chase chase(hut);
    for (const Vec3& place : {Vec3(40, 40, 2.5), Vec3(12, 11, 2.5), Vec3(10.4, 11.5, 2.01)}) {
        for (const double yaw : {kYawNorth, kYawWest, 33.0, 200.0}) {
            SCOPED_TRACE(testing::Message() << place.x << " " << yaw);
            chase.put(place, place.x == 40 ? kOutside : chase.walker.space(hut.front));
            chase.go(yaw, 4.0, -7.0);
            const ChaseState rest = chase.camera;
            const Vec3 feet = chase.walker.body.standing.feet;
            for (int i = 0; i < 100; ++i) {
                chase.frame(yaw, -7.0);
                ASSERT_EQ(chase.camera.eye.position, rest.eye.position);
                ASSERT_EQ(chase.camera.arm, rest.arm);
                ASSERT_EQ(chase.walker.body.standing.feet, feet);
            }
        }
    }
}

TEST(ChaseCamera, isPushedInByAWallAndKeepsOffIt) {
    Hut hut;
    Chase chase(hut);
    chase.put({10.4, 13.0, 2.01}, chase.walker.space(hut.front)); // its back to the western wall
    for (int i = 0; i < 100; ++i) {
        chase.frame(kYawEast);
        ASSERT_GE(chase.eye().x, 10.0 + kCameraRadius - 1e-3);
        ASSERT_EQ(chase.camera.eye.space, chase.walker.space(hut.front));
    }
    EXPECT_LT(chase.eye().x, 10.0 + kCameraRadius + 0.02) << "as far back as there is room";
}

TEST(ChaseCamera, isPushedInAtOnce) {
    Hut hut;
    const std::uint32_t wall = hut.source.addModel(boxExterior({-0.1, -3, 0}, {0.1, 3, 4}));
    hut.source.addObject(wall, frameAt({30, 40, 2}));
    Chase chase(hut);
    chase.put({31.0, 36.0, 2.01}, kOutside); // beside the wall's end
    chase.go(kYawNorth, 3.0);
    ASSERT_EQ(chase.camera.arm, 3.0);
    chase.put({31.0, 40.0, 2.01}, kOutside);
    chase.camera.arm = 3.0;
    chase.frame(kYawEast);
    EXPECT_GE(chase.eye().x, 30.1 + kCameraRadius - 1e-3);
}

TEST(ChaseCamera, case23_isPulledThroughADoorAfterTheBody) {
    Hut hut;
    Chase chase(hut);
    chase.put({5, 11.5, 2.01}, kOutside);
    chase.go(kYawEast, 3.0);
    const world::SpaceIndex front = chase.walker.space(hut.front), rear = chase.walker.space(hut.rear);
    bool bodyAlone = false;
    for (int i = 0; i < 140 && chase.walker.body.standing.space != rear; ++i) {
        chase.frame(kYawEast, 0.0, 1.0);
        ASSERT_TRUE(chase.isWhereItSays()) << chase.eye().x;
        ASSERT_TRUE(chase.isInNothing()) << chase.eye().x << " " << chase.eye().z;
        bodyAlone =
            bodyAlone || (chase.walker.body.standing.space == front && chase.camera.eye.space == kOutside);
    }
    EXPECT_TRUE(bodyAlone) << "the body inside, the eye outside";
    EXPECT_EQ(chase.camera.eye.space, front) << "and the eye after it";
}

TEST(ChaseCamera, case23_looksOutOfTheDoorThatTheBodyLeft) {
    Hut hut;
    Chase chase(hut);
    const world::SpaceIndex front = chase.walker.space(hut.front);
    chase.put({13, 11.5, 2.01}, front);
    bool eyeAlone = false;
    for (int i = 0; i < 90; ++i) {
        chase.frame(kYawWest, 0.0, 1.0);
        ASSERT_TRUE(chase.isWhereItSays()) << chase.eye().x;
        eyeAlone =
            eyeAlone || (chase.walker.body.standing.space == kOutside && chase.camera.eye.space == front);
    }
    EXPECT_TRUE(eyeAlone) << "the body outside, the eye inside";
}

TEST(ChaseCamera, staysOnTheBodysSideOfAShutDoor) {
    Hut hut;
    world::MovingEntries moving;
    moving.doors.push_back({"front", hut.source.id(hut.front), hut.door.index, true, 0.0, {}});
    Chase chase(hut, moving);
    for (const bool shut : {true, false}) {
        SCOPED_TRACE(shut);
        chase.walker.doors.assign(1, shut ? 0.0 : 1.0);
        chase.put({10.6, 11.5, 2.01}, chase.walker.space(hut.front));
        chase.go(kYawEast, 3.0);
        EXPECT_EQ(chase.camera.eye.space, shut ? chase.walker.space(hut.front) : kOutside);
        EXPECT_EQ(chase.eye().x > 10.0, shut);
    }
}

TEST(ChaseCamera, goesUnderTheGroundInACellarAndNotOutside) {
    Hut hut;
    Chase chase(hut);
    chase.put({12.5, 12.5, -0.99}, chase.walker.space(hut.cellar));
    chase.go(kYawEast, 3.0);
    EXPECT_NEAR(chase.eye().x, 9.5, 0.1) << "under the meadow";
    EXPECT_EQ(chase.camera.eye.space, chase.walker.space(hut.cellar));
    chase.put({40, 40, 2.01}, kOutside);
    chase.go(kYawEast, 3.0, 60.0); // gaze upwards: the camera would be below the ground
    EXPECT_GE(chase.eye().z, 2.0 + kCameraRadius - 1e-3);
    EXPECT_EQ(chase.camera.eye.space, kOutside);
}

TEST(ChaseCamera, bendsDownUnderALowCeiling) {
    Hut hut;
    const std::uint32_t board = hut.source.addModel(boxExterior({-5, -5, 0}, {5, 5, 0.1}));
    hut.source.addObject(board, frameAt({40, 40, 2 + 1.8}));
    Chase chase(hut);
    chase.put({40, 40, 2.01}, kOutside);
    chase.go(kYawEast, 1.0);
    EXPECT_TRUE(chase.isInNothing());
    EXPECT_LE(chase.eye().z, 2.0 + 1.8 - kCameraRadius + 1e-3);
}

// On a random walk the camera overlaps nothing, and its space fits its position.
TEST(ChaseCamera, isNeverInAnything) {
    Hut hut;
    const std::uint32_t table = hut.source.addModel(boxExterior({-0.6, -0.4, 0}, {0.6, 0.4, 0.8}));
    hut.source.addStatic(hut.rear, table, frameAt({16, 12.5, 2}, 30));
    Chase chase(hut);
    std::mt19937 generator(11);
    const auto random = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(generator);
    };
    int apart = 0;
    for (int life = 0; life < 8; ++life) {
        chase.put({random(10.4, 13.6), random(10.4, 11.5), 2.05}, chase.walker.space(hut.front));
        for (int i = 0; i < 25 && std::min(chase.walker.feet().x, chase.walker.feet().y) > 4.0; ++i) {
            const double yaw = random(0, 360), pitch = random(-60, 60);
            const int frames = static_cast<int>(random(3, 30));
            for (int f = 0; f < frames; ++f) {
                chase.frame(yaw, pitch, 1.0);
                ASSERT_TRUE(chase.isInNothing())
                    << chase.eye().x << " " << chase.eye().y << " " << chase.eye().z;
                ASSERT_TRUE(chase.isWhereItSays());
                apart += chase.camera.eye.space != chase.walker.body.standing.space ? 1 : 0;
            }
        }
    }
    EXPECT_GT(apart, 50) << "of the body's space and the eye's, often two";
}

TEST(ChaseCamera, isTheSameForTheSameInput) {
    Hut hut;
    Chase a(hut), b(hut);
    for (Chase* chase : {&a, &b}) {
        chase->put({12, 11, 2.5}, chase->walker.space(hut.front));
        for (int i = 0; i < 12; ++i)
            chase->go(37.0 * i, 0.4, 5.0 * i - 30.0, 1.0);
    }
    EXPECT_EQ(a.camera.eye.position, b.camera.eye.position);
    EXPECT_EQ(a.camera.eye.space, b.camera.eye.space);
}

} // namespace
} // namespace limen::motion
