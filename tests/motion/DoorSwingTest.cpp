// Door leaves as solids: they stop bodies, push them, and are stopped by them.
#include "motion/ChaseCamera.h"
#include "motion/DoorUse.h"
#include "motion/Hut.h"
#include "motion/Walker.h"
#include "support/PlacedHut.h"

#include <random>

namespace limen::motion {
namespace {

using test::boxExterior;
using test::frameAt;
using test::Hut;
using test::kYawEast;
using test::kYawNorth;
using test::kYawSouth;
using test::Walker;
using world::kOutside;

constexpr double kNearLeaf = 0.02, kBodyRadius = 0.3, kHalfLeaf = 0.03;
constexpr double kSwingFrame = 1.0 / 30.0;

/// A hut with a front door in the wall x = 10, from y = 11 to 12. The hinge is at y = 11; the door opens
/// outwards or inwards by a right angle.
struct DoorHut : Hut {
    std::uint32_t leaf = source.addModel(boxExterior({-kHalfLeaf, 0, 0}, {kHalfLeaf, 1, 2}));
    world::MovingEntries moving;
    explicit DoorHut(double swing = -90.0) {
        moving.doors.push_back(
            {"front", source.id(front), this->door.index, true, 0.0, {{leaf, at({10, 11, 2}), 0.0, swing}}});
    }
    [[nodiscard]] Vec3 at(const Vec3& local) const { return toGlobal(source, local); }
};

struct Swung {
    explicit Swung(DoorHut& of) : hut(of), walker(of.source, of.moving) { walker.doors = {0.0}; }
    /// Swings the door frame by frame; the body stands.
    void swingTo(double to, double seconds = 1.5) {
        for (double t = 0.0; t < seconds; t += kSwingFrame) {
            const double way = std::clamp(to - walker.doors[0], -kSwingFrame, kSwingFrame);
            swing(0, walker.doors[0] + way, walker.doors, walker.body, walker.collisions());
            walker.body = moved(walker.body, {}, kSwingFrame, walker.collisions(), walker.doors);
            deepest = std::max(
                deepest, glm::length(walker.collisions().wayOut({}, walker.body.standing, walker.doors)));
        }
    }
    void put(const Vec3& local, world::SpaceIndex space) {
        walker.put(local, space);
        walker.stand(0.2);
    }
    DoorHut& hut;
    Walker walker;
    double deepest = 0.0; ///< deepest overlap of the body so far; metres
};

TEST(DoorLeaf, aShutOneStopsABodyAtItsFace) {
    DoorHut hut;
    Swung s(hut);
    s.put({7, 11.5, 2.01}, kOutside);
    s.walker.go(kYawEast, 2.0);
    EXPECT_NEAR(s.walker.feet().x, 10.0 - kHalfLeaf - kBodyRadius, kNearLeaf);
}

TEST(DoorLeaf, anOpenOneLeavesTheDoorwayFreeAndStopsWhoWalksIntoItsFace) {
    DoorHut hut;
    Swung s(hut);
    s.walker.doors = {1.0}; // along the line y = 11, from x = 9 to 10
    s.put({7, 11.5, 2.01}, kOutside);
    s.walker.go(kYawEast, 2.5);
    EXPECT_EQ(s.walker.body.standing.space, s.walker.space(hut.front));
    for (const double from : {-1.0, 1.0}) {
        s.put({9.4, 11.0 + 1.5 * from, 2.01}, kOutside);
        s.walker.go(from < 0.0 ? kYawNorth : kYawSouth, 2.0);
        EXPECT_NEAR(s.walker.feet().y, 11.0 + from * (kHalfLeaf + kBodyRadius), kNearLeaf);
    }
    s.walker.doors = {0.5};
    s.put({9.5, 10.0, 2.01}, kOutside); // half open, the leaf is oblique before the doorway
    s.walker.go(kYawNorth, 1.0);
    EXPECT_LT(s.walker.feet().y, 12.0) << "it slides along it";
    EXPECT_LT(s.walker.feet().x, 9.4);
}

TEST(DoorLeaf, isMetFromTheRoomThatItSwingsInto) {
    DoorHut hut(90.0);
    Swung s(hut);
    s.walker.doors = {1.0}; // along y = 11, from x = 10 to 11
    s.put({10.6, 12.5, 2.01}, s.walker.space(hut.front));
    s.walker.go(kYawSouth, 2.0);
    EXPECT_NEAR(s.walker.feet().y, 11.0 + kHalfLeaf + kBodyRadius, kNearLeaf);
}

TEST(DoorLeaf, aShutPaneStopsABodyThoughItStopsNoRay) {
    Hut hut;
    world::MovingEntries moving;
    moving.doors.push_back({"glass", hut.source.id(hut.front), hut.door.index, false, 0.0, {}});
    Walker walker(hut.source, moving);
    walker.put({7, 11.5, 2.01}, kOutside);
    walker.go(kYawEast, 2.0);
    EXPECT_NEAR(walker.feet().x, 10.0 - kBodyRadius, kNearLeaf);
}

/// The same hut with the same door, from a world database.
struct PlacedDoorHut : DoorHut {
    explicit PlacedDoorHut(double swing = -90.0) {
        dat::Setup setup;
        setup.parts = {leaf};
        world::PlacedEntry entry;
        entry.kind = world::PlacedEntry::Kind::Door;
        entry.id = 1;
        entry.name = "front";
        entry.model = source.addSetup(setup);
        entry.motionTable = test::addSwingTable(source, 0x09000101, 0x03000101, swing);
        entry.block = source.home();
        entry.position = at({10, 11, 2});
        moving.doors.clear();
        moving.placed = {entry};
    }
};

TEST(DoorLeaf, ofADatabaseStopsABodyAtItsFace) {
    PlacedDoorHut hut;
    Swung s(hut);
    s.put({7, 11.5, 2.01}, kOutside);
    s.walker.go(kYawEast, 2.0);
    EXPECT_NEAR(s.walker.feet().x, 10.0 - kHalfLeaf - kBodyRadius, kNearLeaf) << "shut";
    s.walker.doors = {1.0}; // along the line y = 11, from x = 9 to 10
    s.put({7, 11.5, 2.01}, kOutside);
    s.walker.go(kYawEast, 2.5);
    EXPECT_EQ(s.walker.body.standing.space, s.walker.space(hut.front)) << "open";
    s.put({9.4, 9.5, 2.01}, kOutside);
    s.walker.go(kYawNorth, 2.0);
    EXPECT_NEAR(s.walker.feet().y, 11.0 - kHalfLeaf - kBodyRadius, kNearLeaf) << "the open leaf";
}

TEST(DoorSwing, ofADatabasePushesABodyAsTheSameDoorOfWorldJson) {
    for (const Vec3& at : {Vec3(9.5, 11.5, 2.01), Vec3(9.2, 11.9, 2.01), Vec3(9.6, 11.2, 2.01)}) {
        DoorHut json;
        PlacedDoorHut placed;
        Swung a(json), b(placed);
        a.put(at, kOutside);
        b.put(at, kOutside);
        a.swingTo(1.0);
        b.swingTo(1.0);
        EXPECT_NEAR(a.walker.doors[0], b.walker.doors[0], 1e-9);
        EXPECT_LT(glm::length(a.walker.feet() - b.walker.feet()), 0.01);
        EXPECT_LT(b.deepest, 0.002);
    }
}

TEST(DoorSwing, pushesABodyBeforeIt) {
    DoorHut hut;
    Swung s(hut);
    s.put({9.5, 11.5, 2.01}, kOutside);
    s.swingTo(1.0);
    EXPECT_EQ(s.walker.doors[0], 1.0);
    EXPECT_LT(s.deepest, 0.002);
    const Vec3 feet = s.walker.feet();
    EXPECT_TRUE(feet.y < 11.0 - kHalfLeaf - kBodyRadius + kNearLeaf || feet.x < 9.0)
        << feet.x << " " << feet.y;
    EXPECT_EQ(s.walker.body.standing.space, kOutside);
}

TEST(DoorSwing, pushesABodyOutOfTheDoorwayThatItShuts) {
    for (const double x : {9.7, 9.9, 10.1, 10.3}) {
        SCOPED_TRACE(x);
        DoorHut hut;
        Swung s(hut);
        s.walker.doors = {1.0};
        s.put({x, 11.5, 2.01}, x < 10.0 ? kOutside : s.walker.space(hut.front));
        s.swingTo(0.0, 2.0);
        EXPECT_EQ(s.walker.doors[0], 0.0);
        EXPECT_LT(s.deepest, 0.002);
        EXPECT_GT(std::abs(s.walker.feet().x - 10.0), kHalfLeaf + kBodyRadius - kNearLeaf);
    }
}

TEST(DoorSwing, stopsAtABodyThatCannotGiveWay) {
    DoorHut hut;
    const std::uint32_t wall = hut.source.addModel(boxExterior({-0.05, -3, 0}, {0.05, 3, 3}));
    const std::uint32_t side = hut.source.addModel(boxExterior({-1, -0.05, 0}, {1, 0.05, 3}));
    hut.source.addObject(wall, frameAt({9.1, 11, 2}));
    hut.source.addObject(side, frameAt({9.9, 11.0, 2}));
    hut.source.addObject(side, frameAt({9.9, 12.1, 2}));
    Swung s(hut);
    s.put({9.5, 11.55, 2.01}, kOutside); // between door, wall and sides
    const Vec3 before = s.walker.feet();
    s.swingTo(1.0);
    EXPECT_LT(s.walker.doors[0], 0.4);
    EXPECT_LT(s.deepest, 0.002);
    EXPECT_LT(glm::length(s.walker.feet() - before), 0.4);
    const double stopped = s.walker.doors[0];
    const Vec3 rest = s.walker.body.standing.feet;
    s.swingTo(1.0, 0.5);
    EXPECT_EQ(s.walker.doors[0], stopped);
    EXPECT_EQ(s.walker.body.standing.feet, rest) << "to the bit";
    s.swingTo(0.0);
    EXPECT_EQ(s.walker.doors[0], 0.0) << "back it may";
}

TEST(DoorSwing, doesNotShutOnWhomNoLeafPushes) {
    Hut hut;
    world::MovingEntries moving;
    moving.doors.push_back({"front", hut.source.id(hut.front), hut.door.index, true, 0.0, {}});
    Walker walker(hut.source, moving);
    walker.doors = {1.0};
    walker.put({10.1, 11.5, 2.01}, walker.space(hut.front));
    walker.stand(0.2);
    swing(0, 0.0, walker.doors, walker.body, walker.collisions());
    EXPECT_GT(walker.doors[0], 0.0);
    walker.put({11.0, 11.5, 2.01}, walker.space(hut.front));
    swing(0, 0.0, walker.doors, walker.body, walker.collisions());
    EXPECT_EQ(walker.doors[0], 0.0);
}

TEST(DoorSwing, allSwingAsFarAsTheFirstThatIsHeldUp) {
    Hut hut;
    world::MovingEntries moving;
    moving.doors.push_back({"front", hut.source.id(hut.front), hut.door.index, true, 0.0, {}});
    Walker walker(hut.source, moving);
    std::vector<double> scratch;
    walker.put({10.1, 11.5, 2.01}, walker.space(hut.front));
    EXPECT_GT(swingAll(1.0, 0.0, walker.body, walker.collisions(), scratch), 0.0);
    walker.put({12.0, 13.0, 2.01}, walker.space(hut.front));
    EXPECT_EQ(swingAll(1.0, 0.0, walker.body, walker.collisions(), scratch), 0.0);
}

TEST(DoorSwing, isUsedDoorByDoorAndTheSameAgain) {
    Vec3 end(0.0);
    for (int time = 0; time < 2; ++time) {
        DoorHut hut;
        Swung s(hut);
        DoorUse use;
        use.use(s.walker.world().doors[0]);
        s.put({9.5, 11.6, 2.01}, kOutside);
        for (int i = 0; i < 45; ++i) {
            use.pass(kSwingFrame, s.walker.collisions(), s.walker.body);
            use.write(s.walker.world(), s.walker.doors);
            s.walker.body = moved(s.walker.body, {.forward = 0.3, .yaw = kYawEast}, kSwingFrame,
                                  s.walker.collisions(), s.walker.doors);
        }
        EXPECT_EQ(s.walker.doors[0], 1.0);
        EXPECT_TRUE(time == 0 || s.walker.body.standing.feet == end);
        end = s.walker.body.standing.feet;
    }
}

TEST(DoorSwing, theChaseCamerasBallKeepsOffAnOpenLeaf) {
    DoorHut hut;
    Swung s(hut);
    s.walker.doors = {1.0}; // along y = 11, from x = 9 to 10
    s.put({9.5, 11.5, 2.01}, kOutside);
    ChaseState camera;
    for (int i = 0; i < 100; ++i)
        camera = chased(camera, s.walker.body, {0, 1, 0}, kSwingFrame, s.walker.collisions(), s.walker.doors);
    EXPECT_GE(camera.eye.position.y - s.walker.at(0, 0, 0).y, 11.0 + kHalfLeaf + ChaseShape().radius - 0.002);
    s.walker.doors = {0.0};
    for (int i = 0; i < 100; ++i)
        camera = chased(camera, s.walker.body, {0, 1, 0}, kSwingFrame, s.walker.collisions(), s.walker.doors);
    EXPECT_NEAR(camera.eye.position.y - s.walker.at(0, 0, 0).y, 8.5, 0.01) << "out of the way";
}

// A body near a swinging door is never inside a leaf or a wall.
TEST(DoorSwing, neverPushesABodyIntoAnything) {
    for (const double swingBy : {-90.0, 90.0}) {
        DoorHut hut(swingBy);
        const std::uint32_t table = hut.source.addModel(boxExterior({-0.3, -0.3, 0}, {0.3, 0.3, 0.8}));
        hut.source.addObject(table, frameAt({9.1, 10.3, 2}, 20));
        hut.source.addStatic(hut.front, table, frameAt({10.8, 10.6, 2}, 20));
        Swung s(hut);
        std::mt19937 generator(5);
        const auto random = [&](double least, double most) {
            return std::uniform_real_distribution<>(least, most)(generator);
        };
        for (int life = 0; life < 10; ++life) {
            s.walker.doors = {0.0};
            s.put({random(8.0, 9.5), random(10.8, 12.5), 2.05}, kOutside);
            for (int i = 0; i < 30; ++i) {
                const BodyInput input{.forward = 1.0, .yaw = random(60, 120) + (i % 2 == 0 ? 0.0 : 180.0)};
                const double to = random(0, 1) < 0.5 ? 0.0 : 1.0;
                for (int f = 0; f < 15; ++f) {
                    const double way = std::clamp(to - s.walker.doors[0], -kSwingFrame, kSwingFrame);
                    swing(0, s.walker.doors[0] + way, s.walker.doors, s.walker.body, s.walker.collisions());
                    s.walker.body =
                        moved(s.walker.body, input, kSwingFrame, s.walker.collisions(), s.walker.doors);
                    const Standing& at = s.walker.body.standing;
                    ASSERT_LT(glm::length(s.walker.collisions().wayOut({}, at, s.walker.doors)), 0.01)
                        << life << " " << i << " at " << s.walker.feet().x << " " << s.walker.feet().y;
                }
            }
        }
    }
}

} // namespace
} // namespace limen::motion
