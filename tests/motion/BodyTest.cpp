#include "motion/Hut.h"
#include "motion/Walker.h"

#include "motion/Locate.h"

#include <random>

namespace limen::motion {
namespace {

using test::boxExterior;
using test::frameAt;
using test::Hut;
using test::kYawEast;
using test::kYawNorth;
using test::kYawWest;
using test::TestWorld;
using test::Walker;
using world::kOutside;

constexpr double kNear = 0.02; // metres: the skin, and Bullet's rounding

TEST(Body, fallsOntoTheFloorAndStands) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({11.5, 12.5, 3.2}, walker.space(hut.front));
    EXPECT_FALSE(walker.body.isOnGround);
    walker.stand(1.0);
    EXPECT_TRUE(walker.body.isOnGround);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
    const Vec3 before = walker.body.standing.feet;
    walker.stand(3.0);
    EXPECT_EQ(walker.body.standing.feet, before) << "motionless, to the bit";
}

TEST(Body, doesNotWade) {
    constexpr std::uint8_t kHeight = 1; // 2 m
    std::vector<double> heights;
    for (const std::uint8_t type : {std::uint8_t{1}, std::uint8_t{16}, std::uint8_t{18}, std::uint8_t{20}}) {
        test::TestWorld source;
        source.setFlatTerrain(source.home(), kHeight, type);
        Walker walker(source);
        walker.put({60, 60, 2.5}, world::kOutside);
        walker.stand(1.0);
        EXPECT_TRUE(walker.body.isOnGround);
        heights.push_back(walker.feet().z);
    }
    EXPECT_NEAR(heights.front(), 2.0, kNear);
    EXPECT_EQ(heights, std::vector<double>(4, heights.front())) << "grass, and types of water";
}

TEST(Body, goesAsFastAsItIsAskedTo) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({40, 40, 2.01}, kOutside);
    walker.stand(0.2);
    const Vec3 start = walker.feet();
    walker.go(kYawEast, 1.0);
    const Vec3 walked = walker.feet() - start;
    EXPECT_NEAR(walked.x, 2.2, 0.1);
    EXPECT_NEAR(walked.y, 0.0, 1e-6);
    walker.go(kYawNorth, 1.0, true);
    EXPECT_NEAR((walker.feet() - start - walked).y, 5.0, 0.2);
}

TEST(Body, stopsAtWallsAndSlidesAlongThem) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({11, 13, 2.01}, walker.space(hut.front));
    walker.go(kYawNorth, 2.0);
    EXPECT_NEAR(walker.feet().y, 14.0 - 0.3, kNear);
    EXPECT_NEAR(walker.feet().x, 11.0, kNear);
    walker.go(45.0, 1.0);
    EXPECT_NEAR(walker.feet().y, 14.0 - 0.3, kNear);
    EXPECT_NEAR(walker.feet().x, 11.0 + 2.2 * std::sqrt(0.5), 0.1) << "along the wall";
    walker.go(45.0, 3.0);
    EXPECT_NEAR(walker.feet().x, 14.0 - 0.3, kNear) << "into the corner";
    EXPECT_EQ(walker.body.standing.space, walker.space(hut.front));
}

TEST(Body, goesThroughOpenDoorsAndKnowsWhereItIs) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({6, 11.5, 2.01}, kOutside);
    walker.go(kYawEast, 1.5);
    EXPECT_NEAR(walker.feet().x, 9.3, 0.2);
    EXPECT_EQ(walker.body.standing.space, kOutside);
    walker.go(kYawEast, 1.0);
    EXPECT_EQ(walker.body.standing.space, walker.space(hut.front));
    walker.go(kYawEast, 2.0);
    EXPECT_EQ(walker.body.standing.space, walker.space(hut.rear));
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
    walker.go(kYawWest, 6.0);
    EXPECT_EQ(walker.body.standing.space, kOutside) << "and out again";
}

TEST(Body, isStoppedByTheWallAroundTheSmallerOfTwoOpeningsThatAreNotAlike) {
    TestWorld source;
    const auto west = source.addBox({10, 10, 2}, {14, 14, 5}), east = source.addBox({14, 10, 2}, {18, 14, 5});
    TestWorld::LinkOptions options;
    options.exact = false;
    options.polygonInB = test::rectangle({14, 11, 2}, {14, 12, 4});
    source.link(west, test::rectangle({14, 10.2, 2}, {14, 13.5, 4.8}), east, options);
    Walker walker(source);
    for (const double y : {10.6, 12.9}) {
        walker.put({12, y, 2.01}, walker.space(west));
        walker.go(kYawEast, 2.0);
        EXPECT_NEAR(walker.feet().x, 14.0 - 0.3, kNear) << y;
        EXPECT_EQ(walker.body.standing.space, walker.space(west));
    }
    walker.put({12, 11.5, 2.01}, walker.space(west));
    walker.go(kYawEast, 2.0);
    EXPECT_EQ(walker.body.standing.space, walker.space(east));
}

TEST(Body, isStoppedByAWallHalfAMillimetreBehindAnOpening) {
    TestWorld source;
    test::Walls niche = test::boxWalls({14, 10, 2}, {15, 14, 5});
    // Slightly rotated: in a parallel plane the opening would be cut out of it as well.
    niche.push_back({{{14.0004, 10, 2}, {14.0004, 10, 5}, {14.0012, 14, 5}, {14.0012, 14, 2}}});
    const auto room = source.addBox({10, 10, 2}, {14, 14, 5}), beyond = source.addCell(niche);
    source.link(room, test::rectangle({14, 10, 2}, {14, 14, 5}), beyond);
    Walker walker(source);
    for (const double y : {10.5, 12.0}) {
        walker.put({12, y, 2.01}, walker.space(room));
        walker.go(kYawEast, 2.0);
        EXPECT_NEAR(walker.feet().x, 14.0 - 0.3, kNear) << y;
    }
}

TEST(Body, isStoppedByShutDoors) {
    Hut hut;
    world::MovingEntries moving;
    moving.doors.push_back({"front", hut.source.id(hut.front), hut.door.index, true, 0.0, {}});
    Walker walker(hut.source, moving);
    for (const bool shut : {true, false}) {
        walker.doors.assign(1, shut ? 0.0 : 1.0);
        walker.put({7, 11.5, 2.01}, kOutside);
        walker.go(kYawEast, 2.0);
        EXPECT_EQ(walker.body.standing.space, shut ? kOutside : walker.space(hut.front));
        EXPECT_EQ(walker.feet().x < 10.0, shut);
        walker.put({12, 11.5, 2.01}, walker.space(hut.front));
        walker.go(kYawWest, 2.0);
        EXPECT_EQ(walker.body.standing.space, shut ? walker.space(hut.front) : kOutside);
        walker.put({12, 11.5, 2.01}, walker.space(hut.front));
        walker.go(kYawEast, 2.0);
        EXPECT_EQ(walker.body.standing.space, walker.space(hut.rear)) << "no door is known there";
    }
}

TEST(Body, isNotBlockedByTheGroundThatACellarLiesUnder) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({12.5, 12.5, 0.0}, walker.space(hut.cellar));
    walker.stand(0.5);
    EXPECT_NEAR(walker.feet().z, -1.0, kNear);
    walker.go(kYawWest, 4.0); // under the meadow
    EXPECT_NEAR(walker.feet().x, 6.3, kNear);
    EXPECT_NEAR(walker.feet().z, -1.0, kNear);
    EXPECT_EQ(walker.body.standing.space, walker.space(hut.cellar));
}

TEST(Body, isNotBlockedOutdoorsByTheCellarBelow) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({5, 12, 2.01}, kOutside);
    walker.go(kYawEast, 1.5);
    EXPECT_NEAR(walker.feet().x, 5 + 2.2 * 1.5, 0.15);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
}

TEST(Body, fallsThroughATrapdoor) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({12.5, 12.5, 2.2}, walker.space(hut.front));
    walker.stand(1.5);
    EXPECT_NEAR(walker.feet().z, -1.0, kNear);
    EXPECT_EQ(walker.body.standing.space, walker.space(hut.cellar));
}

TEST(Body, climbsStepsUpToItsHeightAndNoHigher) {
    for (const double step : {0.2, 0.55, 0.7}) {
        SCOPED_TRACE(step);
        Hut hut;
        const std::uint32_t block = hut.source.addModel(boxExterior({0, -2, 0}, {3, 2, step}));
        hut.source.addObject(block, frameAt({32, 40, 2}));
        Walker walker(hut.source);
        walker.put({30, 40, 2.01}, kOutside);
        walker.go(kYawEast, 1.8);
        if (step < 0.6) {
            EXPECT_NEAR(walker.feet().z, 2.0 + step, kNear);
            EXPECT_NEAR(walker.feet().x, 30 + 2.2 * 1.8, 0.2) << "no slower";
            walker.go(kYawWest, 2.0);
            EXPECT_NEAR(walker.feet().z, 2.0, kNear) << "and down again";
        } else {
            EXPECT_NEAR(walker.feet().x, 32 - 0.3, kNear);
            EXPECT_NEAR(walker.feet().z, 2.0, kNear);
        }
    }
}

// The sill of a house's door: a step under a lintel that leaves no room for a body lifted by a whole step.
TEST(Body, climbsStepsUnderALowLintel) {
    for (const double headroom : {1.81, 2.0}) {
        for (const double step : {0.05, 0.14, 0.25, 0.33, 0.42, 0.55}) {
            SCOPED_TRACE(testing::Message() << step << " m below " << headroom << " m");
            Hut hut;
            const std::uint32_t sill = hut.source.addModel(boxExterior({0, -2, 0}, {4, 2, step}));
            const std::uint32_t lintel = hut.source.addModel(boxExterior({0, -2, 0}, {0.25, 2, 1}));
            hut.source.addObject(sill, frameAt({32, 40, 2}));
            hut.source.addObject(lintel, frameAt({32, 40, 2 + step + headroom}));
            Walker walker(hut.source);
            walker.put({30, 40, 2.01}, kOutside);
            walker.go(kYawEast, 1.8);
            EXPECT_NEAR(walker.feet().z, 2.0 + step, kNear);
            EXPECT_NEAR(walker.feet().x, 30 + 2.2 * 1.8, 0.3);
            walker.go(kYawWest, 2.0);
            EXPECT_NEAR(walker.feet().z, 2.0, kNear) << "and down again";
        }
    }
}

// One that a body does not fit below stays closed.
TEST(Body, climbsNoStepUnderALintelLowerThanItself) {
    Hut hut;
    const std::uint32_t sill = hut.source.addModel(boxExterior({0, -2, 0}, {4, 2, 0.3}));
    const std::uint32_t lintel = hut.source.addModel(boxExterior({0, -2, 0}, {0.25, 2, 1}));
    hut.source.addObject(sill, frameAt({32, 40, 2}));
    hut.source.addObject(lintel, frameAt({32, 40, 2 + 0.3 + 1.7}));
    Walker walker(hut.source);
    walker.put({30, 40, 2.01}, kOutside);
    walker.go(kYawEast, 1.8);
    EXPECT_LT(walker.feet().x, 32.0);
}

TEST(Body, climbsStairs) {
    Hut hut;
    for (int i = 0; i < 10; ++i) {
        const std::uint32_t block = hut.source.addModel(boxExterior({0, -2, 0}, {0.3, 2, 0.2 * (i + 1)}));
        hut.source.addObject(block, frameAt({32 + 0.3 * i, 40, 2}));
    }
    const std::uint32_t landing = hut.source.addModel(boxExterior({0, -2, 0}, {4, 2, 2.0}));
    hut.source.addObject(landing, frameAt({35, 40, 2}));
    Walker walker(hut.source);
    walker.put({30, 40, 2.01}, kOutside);
    walker.go(kYawEast, 3.0);
    EXPECT_NEAR(walker.feet().z, 4.0, kNear);
    walker.go(kYawWest, 3.0);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
    EXPECT_TRUE(walker.body.isOnGround) << "step by step, not in the air";
}

TEST(Body, getsOutOfANotchThatIsTooSteepToStandIn) {
    Hut hut;
    const test::Walls notch{{{{-1, -2, 2}, {0, -2, 0}, {0, 2, 0}, {-1, 2, 2}}},
                            {{{0, -2, 0}, {1, -2, 2}, {1, 2, 2}, {0, 2, 0}}}};
    hut.source.addObject(hut.source.addModel(notch), frameAt({40, 40, 3}));
    Walker walker(hut.source);
    walker.put({40.1, 40, 4.5}, kOutside);
    walker.stand(2.0);
    const Vec3 held = walker.feet();
    EXPECT_GT(held.z, 3.1);
    walker.stand(1.0);
    EXPECT_EQ(walker.feet(), held) << "motionless, to the bit";
    walker.go(kYawNorth, 3.0);
    EXPECT_GT(walker.feet().y, 42.0);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
}

TEST(Body, fallsAlongWhatIsTooSteepAndIsNotHeldByIt) {
    Hut hut;
    const test::Walls slope{{{{-1, -2, 2}, {0, -2, 0}, {0, 2, 0}, {-1, 2, 2}}}};
    hut.source.addObject(hut.source.addModel(slope), frameAt({40, 40, 2}));
    Walker walker(hut.source);
    walker.put({39.6, 40, 4.0}, kOutside);
    walker.stand(2.0);
    EXPECT_GT(walker.feet().x, 40.0);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
}

TEST(Body, jumpsAndLands) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({40, 40, 2.01}, kOutside);
    walker.stand(0.2);
    BodyInput jump;
    jump.jump = true;
    double highest = 0.0;
    for (int i = 0; i < 60; ++i) {
        walker.body = moved(walker.body, jump, 0.02, walker.collisions(), walker.doors);
        jump.jump = false;
        highest = std::max(highest, walker.feet().z);
    }
    EXPECT_NEAR(highest, 2.0 + 4.2 * 4.2 / (2 * 9.81), 0.05);
    EXPECT_TRUE(walker.body.isOnGround);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
}

TEST(Body, bumpsItsHead) {
    Hut hut;
    const std::uint32_t board = hut.source.addModel(boxExterior({-2, -2, 0}, {2, 2, 0.1}));
    hut.source.addObject(board, frameAt({40, 40, 2 + 2.0}));
    Walker walker(hut.source);
    walker.put({40, 40, 2.01}, kOutside);
    walker.stand(0.2);
    BodyInput jump;
    jump.jump = true;
    double highest = 0.0;
    for (int i = 0; i < 60; ++i) {
        walker.body = moved(walker.body, jump, 0.02, walker.collisions(), walker.doors);
        jump.jump = false;
        highest = std::max(highest, walker.feet().z);
    }
    EXPECT_NEAR(highest, 2.0 + 2.0 - 1.75, kNear);
    EXPECT_NEAR(walker.feet().z, 2.0, kNear);
}

TEST(Body, isPutBackWhereItStoodWhenItFallsOutOfTheWorld) {
    TestWorld source;
    source.omitRegion();
    const auto room = source.addBox({0, 0, -12}, {10, 10, -9});
    source.walls(room).erase(source.walls(room).begin()); // any wall: below, six of them are left out in turn
    Walker walker(source);
    walker.put({5, 5, -11.9}, walker.space(room));
    walker.body.safe = {walker.at(5, 5, -11.9), walker.space(room)};
    walker.body.standing.feet.z -= 300.0;
    walker.stand(0.1);
    EXPECT_EQ(walker.body.recoveries, 1u);
    EXPECT_NEAR(walker.feet().z, -12.0, 0.2);
}

TEST(Body, isTheSameForTheSameInput) {
    Hut hut;
    Walker a(hut.source), b(hut.source);
    for (Walker* walker : {&a, &b}) {
        walker->put({12, 11, 2.5}, walker->space(hut.front));
        for (int i = 0; i < 12; ++i)
            walker->go(37.0 * i, 0.4, i % 3 == 0, i % 4 == 1);
    }
    EXPECT_EQ(a.body.standing.feet, b.body.standing.feet);
    EXPECT_EQ(a.body.velocity, b.body.velocity);
    EXPECT_EQ(a.body.standing.space, b.body.standing.space);
}

// On a random walk the body's space fits its position, it overlaps no wall, and it ends on the ground.
TEST(Body, neverLeavesTheWorld) {
    Hut hut;
    const std::uint32_t table = hut.source.addModel(boxExterior({-0.6, -0.4, 0}, {0.6, 0.4, 0.8}));
    hut.source.addStatic(hut.rear, table, frameAt({16, 12.5, 2}, 30));
    Walker walker(hut.source);
    std::mt19937 generator(7);
    const auto random = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(generator);
    };
    for (int life = 0; life < 12; ++life) {
        walker.put({random(10.4, 13.6), random(10.4, 11.5), 2.05}, walker.space(hut.front));
        for (int i = 0; i < 40; ++i) {
            walker.go(random(0, 360), random(0.1, 0.9), i % 2 == 0, i % 5 == 0);
            if (std::min(walker.feet().x, walker.feet().y) < 2.0)
                break; // the land ends there
            const Vec3 middle = Capsule().middle(walker.body.standing.feet);
            const world::SpaceIndex space = walker.body.standing.space;
            ASSERT_EQ(walker.body.recoveries, 0u) << life << " " << i;
            const Vec3 fromHole = glm::abs(walker.feet() - Vec3(12.5, 12.5, 2.0));
            const bool isOverHole = std::max(fromHole.x, fromHole.y) < 0.8;
            ASSERT_GE(walker.feet().z, space == walker.space(hut.cellar) || isOverHole ? -1.01 : 1.99)
                << life << " " << i << ": fell through the ground at " << walker.feet().x << " "
                << walker.feet().y;
            const bool isThere = space == kOutside ? locate(walker.world(), middle).space == kOutside
                                                   : cellContains(walker.world(), space, middle);
            ASSERT_TRUE(isThere) << life << " " << i;
            ASSERT_LT(glm::length(walker.collisions().wayOut({}, walker.body.standing, walker.doors)), 0.01);
        }
    }
}

TEST(Body, hasItsEyeInTheSpaceItsEyeIsIn) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({12.5, 12.5, 0.9}, walker.space(hut.cellar)); // the head is above the trapdoor
    const BodyEye eye = eyeOf(walker.body, walker.world());
    EXPECT_EQ(eye.space, walker.space(hut.front));
    EXPECT_NEAR(eye.position.z, 2.6, 1e-9);
}

} // namespace
} // namespace limen::motion
