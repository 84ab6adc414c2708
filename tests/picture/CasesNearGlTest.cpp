// Hard cases 45 to 52 of docs/cases.md: cells that overlap in a loop, walls a millimetre apart, bent openings, holes of
// inexact pairs, a wall below a shut door, a cell without depth,
// inexact pairs that are not flat.
#include "motion/Locate.h"
#include "picture/CaseHelp.h"
#include "picture/Naming.h"
#include "support/BentRooms.h"

#include <algorithm>
#include <random>

namespace limen::test {
namespace {

struct CasesNear : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesNear);

/// Eight rooms around an axis. The way round it closes after two turns, so each room has another in its place.
struct Loop {
    TestWorld world;
    std::vector<TestWorld::Cell> rooms;
    static constexpr double kX = 90.0, kY = 90.0; ///< the axis

    Loop() {
        constexpr std::array<std::array<double, 2>, 4> kQuadrants{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
        constexpr std::array kColours{"brown", "blue", "red", "grey"};
        for (std::size_t k = 0; k < 8; ++k) {
            const double x = kQuadrants[k % 4][0] * (4.0 + 0.25 * static_cast<double>(k)),
                         y = kQuadrants[k % 4][1] * 5.0;
            rooms.push_back(world.addBox({kX + std::min(x, 0.0), kY + std::min(y, 0.0), -12},
                                         {kX + std::max(x, 0.0), kY + std::max(y, 0.0), -9},
                                         kColours[(k + k / 4) % 4]));
        }
        for (std::size_t k = 0; k < 8; ++k)
            world.link(rooms[k], opening(k), rooms[(k + 1) % 8]);
    }
    /// In the plane between a room and the next; wider in the first turn than in the second.
    static std::vector<Vec3> opening(std::size_t k) {
        const double width = k < 4 ? 2.0 : 1.25;
        const Vec3 along = k % 4 == 0   ? Vec3(0, 1, 0)
                           : k % 4 == 1 ? Vec3(-1, 0, 0)
                           : k % 4 == 2 ? Vec3(0, -1, 0)
                                        : Vec3(1, 0, 0);
        const Vec3 axis(kX, kY, -12);
        return rectangle(axis + along * 0.25, axis + along * (0.25 + width) + Vec3(0, 0, 2));
    }
};

TEST_P(CasesNear, case45_roomsOverlapInALoop) {
    Loop loop;
    PictureWorld pictures(loop.world, options());
    for (std::size_t k = 0; k < 8; ++k) {
        const std::vector<Vec3> opening = Loop::opening(k);
        const Vec3 middle = (opening[0] + opening[2]) * 0.5;
        const Vec3 before = middle + (k % 4 == 0   ? Vec3(3, 0, 0)
                                      : k % 4 == 1 ? Vec3(0, 3, 0)
                                      : k % 4 == 2 ? Vec3(-3, 0, 0)
                                                   : Vec3(0, -3, 0));
        const Vec3 through = glm::normalize(middle - before);
        const double yaw = glm::degrees(std::atan2(through.x, through.y));
        const world::SpaceIndex space = pictures.space(loop.world.id(loop.rooms[k]));
        for (const double turned : {-25.0, 0.0, 25.0})
            pictures.expectClean(pictures.look(before, yaw + turned, -5, space));
        for (const double past : {-0.01, -4e-6, 4e-6, 1e-4}) // metres behind the opening's plane
            for (const double turned : {0.0, 90.0, 180.0, 270.0})
                pictures.expectClean(pictures.look(middle + through * past, yaw + turned + 5.0, -20, space));
    }
}

TEST_P(CasesNear, case45_aHatchLeadsDownIntoARoomWithinTheRoomBelow) {
    TestWorld world;
    const auto room = world.addBox({80, 80, -12}, {86, 86, -9}, "brown"),
               loft = world.addBox({80, 80, -9}, {86, 86, -6}, "blue"),
               closet = world.addBox({82, 82, -12}, {84, 84, -9}, "red");
    world.link(room, rectangle({80.25, 80.25, -9}, {81.25, 81.25, -9}), loft);
    world.link(loft, rectangle({82.5, 82.5, -9}, {83.5, 83.5, -9}), closet);
    PictureWorld pictures(world, options());
    // The ceiling of the room is in the plane of the hatch. It is not in the way up from the closet.
    const Picture up =
        pictures.expectClean(pictures.look({83, 83, -11}, 30, 80, pictures.space(world.id(closet))));
    EXPECT_GT(pixelsOfRecord(pictures, up, world.id(loft)), 300u);
    EXPECT_EQ(pixelsOfRecord(pictures, up, world.id(room)), 0u);
}

/// A turn and a half around a vertical line, back to where another room is. Each opening has the line for an edge.
struct Turn {
    TestWorld world;
    // This order puts the last three rooms into one zone.
    TestWorld::Cell fifth = world.addBox({79, 79, -12}, {85, 85, -9}, "red"),
                    fourth = world.addBox({79, 85, -12}, {85, 90, -9}, "green"),
                    third = world.addBox({85, 85, -12}, {90, 90, -9}, "blue"),
                    second = world.addBox({85, 79, -12}, {90, 85, -9}, "brown"),
                    first = world.addBox({80, 80, -12}, {85, 85, -9}, "grey");

    Turn() {
        world.link(first, rectangle({85, 83, -12}, {85, 85, -10}), second);
        world.link(second, rectangle({85, 85, -12}, {87, 85, -10}), third);
        world.link(third, rectangle({85, 85, -12}, {85, 87, -10}), fourth);
        world.link(fourth, rectangle({83, 85, -12}, {85, 85, -10}), fifth);
    }
};

TEST_P(CasesNear, case45_aRoomTouchesAnOpeningOfItsZoneFromBefore) {
    Turn turn;
    PictureWorld pictures(turn.world, options());
    const world::SpaceIndex first = pictures.space(turn.world.id(turn.first));
    // Rays that graze the common edge pass the east wall of the fifth room, which overlaps the first.
    for (const double pitch : {0.0, -30.0, -60.0})
        for (const double aside : {0.006, 0.012, 0.03})
            pictures.expectClean(pictures.look({85 - aside * 1.33, 85 - aside, -10.5}, 45, pitch, first));
}

/// Two rooms whose walls are `gap` apart: the second has reveals from its wall to the opening in the first one's.
struct ThinRooms {
    TestWorld world;
    TestWorld::Cell first = world.addBox({80, 80, -12}, {84, 84, -9}, "brown"), second;

    explicit ThinRooms(double gap) {
        const double wall = 84.0 + gap;
        Walls walls = boxWalls({wall, 80, -12}, {88, 84, -9}, "blue");
        const Walls reveals = boxWalls({84, 81, -12}, {wall, 82, -10}, "red");
        cutOpening(walls, rectangle({wall, 81, -12}, {wall, 82, -10}));
        for (const BoxWall side : {kFloor, kCeiling, kSouth, kNorth, kWest})
            walls.push_back(reveals[side]);
        second = world.addCell(std::move(walls));
        world.link(first, rectangle({84, 81, -12}, {84, 82, -10}), second);
    }
};

TEST_P(CasesNear, case46_revealsAMillimetreDeep) {
    ThinRooms rooms(0.0015);
    PictureWorld pictures(rooms.world, options());
    const world::SpaceIndex first = pictures.space(rooms.world.id(rooms.first)),
                            second = pictures.space(rooms.world.id(rooms.second));
    for (const double aside : {0.0004, 0.002, 0.01}) {
        for (const double past : {-0.001, 0.0003, 0.0009, 0.003}) {
            const Vec3 eye(84.0 + past, 81.0 + aside, -11);
            for (const double yaw : {90.0, 135.0, 175.0, 225.0})
                pictures.expectClean(pictures.look(eye, yaw, 10, past > 0.0 ? second : first));
        }
    }
}

TEST_P(CasesNear, case47_anOpeningWhoseCornersAreOffItsPlane) {
    // Records with coarse corners have such openings. The eye is nearer to the plane than the corners.
    TestWorld world;
    const auto a = world.addBox({80, 80, -12}, {84, 84, -9}, "brown"),
               b = world.addBox({84, 80, -12}, {88, 84, -9}, "blue");
    std::vector<Vec3> opening = rectangle({84, 81, -11.5}, {84, 83, -9.5});
    for (std::size_t i = 0; i < 4; ++i)
        opening[i].x += i % 2 == 0 ? 0.0004 : -0.0004;
    TestWorld::LinkOptions bent;
    bent.exact = false;
    world.link(a, opening, b, bent);
    PictureWorld pictures(world, options());
    const world::SpaceIndex space = pictures.space(world.id(a));
    for (const double before : {2.5e-4, 3.5e-4, 1e-3}) {
        for (const double yaw : {60.0, 90.0, 120.0}) {
            const Picture picture = pictures.shoot(pictures.look({84 - before, 82.1, -10.4}, yaw, 4, space));
            const check::Comparison verdict = pictures.judge(picture);
            EXPECT_EQ(verdict.findings(), 0u) << before << " " << yaw;
            EXPECT_GT(pixelsOfRecord(pictures, picture, world.id(b)), 5000u) << before << " " << yaw;
        }
    }
}

TEST_P(CasesNear, case48_anInexactPairBehindTwoOpeningsWithACommonEdge) {
    TestWorld world;
    const auto a = world.addBox({80, 80, -12}, {84, 84, -9}, "brown"),
               b = world.addBox({84, 80, -12}, {88, 84, -9}, "blue"),
               c = world.addBox({88, 80, -12}, {92, 84, -9}, "red");
    const Vec3 low(84, 80.5, -11.9), right(84, 83.4, -11.8), high(84, 83.3, -9.2), left(84, 80.6, -9.3);
    world.link(a, {low, right, high}, b);
    world.link(a, {low, high, left}, b);
    TestWorld::LinkOptions inexact;
    inexact.exact = false;
    inexact.polygonInB = regularPolygon({88, 82.03, -10.48}, {1, 0, 0}, 1.1, 7);
    world.link(b, regularPolygon({88, 82, -10.5}, {1, 0, 0}, 1.1, 7), c, inexact);
    PictureWorld pictures(world, options());
    pictures.width = 160;
    pictures.height = 90;
    pictures.fov = 9;
    const world::SpaceIndex space = pictures.space(world.id(a));
    for (int i = 0; i < 60; ++i) { // along the common edge, from eyes all over the room
        const Vec3 eye(80.5 + 0.05 * i, 80.6 + 0.0531 * (i * 7 % 60), -11.7 + 0.0411 * (i * 11 % 60));
        const Vec3 to = glm::mix(low, high, 0.2 + 0.6 * (i * 13 % 60) / 60.0) - eye;
        const frame::FrameView view =
            pictures.look(eye, glm::degrees(std::atan2(to.x, to.y)),
                          glm::degrees(std::atan2(to.z, std::hypot(to.x, to.y))), space);
        EXPECT_EQ(pictures.judge(pictures.shoot(view)).findings(), 0u) << "view " << i;
    }
}

// The eye is between the planes of the opening's two triangles: before one of them, behind the other.
TEST_P(CasesNear, case49_anEyeAtAnOpeningThatIsNotFlat) {
    for (const double off : {-0.003, 0.003}) {
        TestWorld world;
        const BentRooms rooms(world, 84, off, {80, 80, -12}, "brown", "blue");
        PictureWorld pictures(world, options());
        const Vec3 home = pictures.homeOrigin(), start(83, 81.9, -10.6);
        const world::SpaceIndex space = pictures.space(world.id(rooms.a));
        for (const double y : {80.7, 82.02, 83.3}) {
            for (const double past : {-2e-3, -8e-4, -3e-4, -5e-5, 5e-5, 3e-4, 8e-4, 2e-3}) {
                const Vec3 eye(84 + past, y, -10.7);
                const world::SpaceIndex root =
                    motion::sweep(pictures.world(), space, home + start, home + eye);
                for (const double yaw : {2.0, 88.0, 179.0, 271.0})
                    pictures.expectClean(pictures.look(eye, yaw, 3, root));
            }
        }
    }
}

// A corner is off by less than a hair. The eye is as near to the plane and to a corner: past the edges of the walls beside
// the corner, or before them.
TEST_P(CasesNear, case49_anEyeAtAnOpeningThatIsAlmostFlat) {
    for (const double off : {-4e-5, 4e-5}) {
        TestWorld world;
        const BentRooms rooms(world, 84, off, {80, 80, -12}, "brown", "blue");
        PictureWorld pictures(world, options());
        const world::SpaceIndex a = pictures.space(world.id(rooms.a));
        for (const Vec3& corner : rooms.opening) {
            const double left = corner.y < 82 ? 1.0 : -1.0, up = corner.z < -11 ? 1.0 : -1.0;
            for (const double past : {-9e-6, -3e-6, 3e-6, 9e-6}) { // of the mean plane
                const Vec3 eye(84 + off / 4 + past, corner.y + left * 2e-5, corner.z + up * 3e-5);
                for (const double yaw : {2.0, 178.0, 268.0})
                    pictures.expectClean(pictures.look(eye, yaw, -50 * up, a));
            }
        }
    }
}

TEST_P(CasesNear, case49_anEyeAtAnOpeningOfOneWayThatIsNotFlat) {
    TestWorld::LinkOptions walled;
    walled.surfaceInB = "red";
    for (const double off : {-0.003, 0.003}) {
        TestWorld world;
        const BentRooms rooms(world, 84, off, {80, 80, -12}, "brown", "blue", walled);
        PictureWorld pictures(world, options());
        const world::SpaceIndex space = pictures.space(world.id(rooms.a));
        for (const double y : {80.7, 82.02, 83.3}) {
            for (const double before : {5e-5, 3e-4, 8e-4, 2e-3}) {
                const Vec3 eye(84 - before + std::min(off, 0.0), y, -10.7);
                for (const double yaw : {2.0, 88.0, 179.0, 271.0})
                    pictures.expectClean(pictures.look(eye, yaw, 3, space));
            }
        }
    }
}

/// A room above a cellar, as one zone. A wall of the cellar is in the plane of the room's shut door, whose leaf keeps a
/// centimetre from the opening's edges.
struct DoorOverCellar {
    static constexpr double kWall = 84.0, kCeiling = -9.0; ///< y of the door; z of its lower edge
    TestWorld world;
    TestWorld::Cell front = world.addBox({80, 80, -9}, {87, 84, -6}, "brown"),
                    back = world.addBox({80, 84, -9}, {87, 88, -6}, "blue"),
                    cellar = world.addBox({80, 84, -12}, {87, 88, -9}, "red");
    PictureOptions options;

    explicit DoorOverCellar(const PictureOptions& from) : options(from) {
        world.link(back, rectangle({81.3, kWall, -9}, {82.4, kWall, -7}), front);
        world.link(back, rectangle({84.8, 86, -9}, {86, 87.3, -9}), cellar);
        const std::uint32_t leaf = world.addModel(boxExterior({0.01, -0.03, 0.01}, {1.09, 0.03, 2}, "wood"));
        const Vec3 origin(world.home().x * 192.0, world.home().y * 192.0, 0.0);
        options.moving.doors.push_back(
            {"door", world.id(back), 0, true, 0.0, {{leaf, origin + Vec3(81.3, kWall, -9), 0.0, 90.0}}});
    }
};

TEST_P(CasesNear, case50_aWallBelowAShutDoorInTheDoorsPlane) {
    DoorOverCellar rooms(options());
    PictureWorld pictures(rooms.world, rooms.options);
    motion::DynamicStateInput shut;
    shut.allDoors = 0.0;
    pictures.setDynamics(shut);
    const world::SpaceIndex cellar = pictures.space(rooms.world.id(rooms.cellar));
    std::mt19937 random(50);
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::size_t views = 0, wrong = 0;
    while (views < 300) {
        // A pixel's ray meets the common edge, to within rounding.
        const Vec3 met(between(81.35, 82.35), DoorOverCellar::kWall, DoorOverCellar::kCeiling);
        const double yaw = between(100, 260), pitch = between(-20, 30);
        const auto column = static_cast<double>(random() % pictures.width),
                   row = static_cast<double>(random() % pictures.height);
        const Vec3 ray = rayThrough(pictures.look(met, yaw, pitch, cellar), column, row).direction;
        const Vec3 eye = met - glm::normalize(ray) * between(0.3, 3.0);
        if (eye.y < 84.2 || eye.z > -9.2 || eye.x < 80.2 || eye.x > 86.8 || eye.y > 87.8)
            continue;
        ++views;
        const Picture picture = pictures.shoot(pictures.look(eye, yaw, pitch, cellar));
        // The leaf behind the edge can show on it (docs/cases.md). Nothing else can.
        EXPECT_EQ(std::ranges::count(picture.ids, frame::gpu::kVoidId), 0)
            << eye.x << " " << eye.y << " " << eye.z;
        wrong += pictures.judge(picture).findings();
    }
    EXPECT_LE(wrong, GetParam() ? 2u : 0u); // of 1,843,200 pixels, in views chosen for this edge
}

// Rounded corners can fold a room, so that two of its openings are in one plane. Rays come in by one and leave by the other.
TEST_P(CasesNear, case51_aRoomWithoutDepthBetweenTwoOpenings) {
    TestWorld world;
    const auto near = world.addBox({80, 80, -12}, {84, 84, -9}, "brown"),
               folded = world.addBox({82, 80, 20}, {88, 84, 23}, "red"),
               far = world.addBox({84, 80, -12}, {88, 84, -9}, "blue");
    const std::vector<Vec3> opening = rectangle({84, 81, -11.5}, {84, 83, -9.5});
    world.link(near, opening, folded);
    world.link(folded, opening, far);
    PictureWorld pictures(world, options());
    const world::SpaceIndex space = pictures.space(world.id(near));
    for (const Vec3& eye : {Vec3(81, 82, -10.5), Vec3(83, 80.5, -11), Vec3(83.9999, 81.0001, -11.4)}) {
        for (const double yaw : {60.0, 90.0}) {
            const Picture picture = pictures.expectClean(pictures.look(eye, yaw, 3, space));
            EXPECT_GT(pixelsOfRecord(pictures, picture, world.id(far)), 200u) << eye.x << " " << yaw;
        }
    }
}

/// Two rooms with an inexact pair between them. Its corners are off their planes, each side's by other amounts.
struct BentInexactRooms {
    TestWorld world;
    TestWorld::Cell a = world.addBox({80, 80, -12}, {84, 84, -9}, "brown"),
                    b = world.addBox({84, 80, -12}, {88, 84, -9}, "blue");
    std::array<std::vector<Vec3>, 2> opening{regularPolygon({84, 82, -10.5}, {1, 0, 0}, 1.1, 5),
                                             regularPolygon({84, 82.03, -10.48}, {1, 0, 0}, 1.1, 5)};

    explicit BentInexactRooms(double off) {
        constexpr std::array kOff{1.0, -0.7, 0.2, 0.9, -1.0};
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t i = 0; i < 5; ++i)
                opening[side][i].x += off * kOff[(i + 2 * side) % 5];
        TestWorld::LinkOptions options;
        options.exact = false;
        options.polygonInB = opening[1];
        world.link(a, opening[0], b, options);
    }
};

// The eye is nearer to the plane than the corners, inside and outside of an edge: of the opening, or of the other side's.
TEST_P(CasesNear, case52_anEyeAtAnInexactPairThatIsNotFlat) {
    for (const double off : {1e-4, 1e-3}) {
        BentInexactRooms rooms(off);
        PictureWorld pictures(rooms.world, options());
        const Vec3 home = pictures.homeOrigin(), start(82, 82, -10.5);
        const world::SpaceIndex a = pictures.space(rooms.world.id(rooms.a));
        std::uint64_t wrong = 0;
        for (const std::vector<Vec3>& opening : rooms.opening) {
            for (std::size_t i = 0; i < opening.size(); i += 2) {
                const Vec3 &from = opening[i], &to = opening[(i + 1) % opening.size()];
                for (const double aside : {-2e-5, 2e-5, 3e-3}) {
                    const Vec3 on = from + (to - from) * 0.3,
                               inwards = glm::normalize(Vec3(0, 82.01, -10.49) - Vec3(0, on.y, on.z));
                    for (const double past : {-0.6, -0.05, 0.05, 0.6}) {
                        const Vec3 eye = Vec3(84 + off * past, on.y, on.z) + inwards * aside;
                        const world::SpaceIndex root =
                            motion::sweep(pictures.world(), a, home + start, home + eye);
                        for (const double yaw : {2.0, 88.0, 179.0, 271.0})
                            wrong +=
                                pictures.judge(pictures.shoot(pictures.look(eye, yaw, 3, root))).findings();
                    }
                }
            }
        }
        EXPECT_EQ(wrong, 0u) << off;
    }
}

} // namespace
} // namespace limen::test
