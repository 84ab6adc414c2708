#include "visibility/ZoneCheck.h"
#include "visibility/GraphBuilder.h"

#include <gtest/gtest.h>

#include <ctime>
#include <limits>

namespace limen::visibility {
namespace {

/// An upright rectangle from (x1, y1) to (x2, y2), 2 m high, counter-clockwise as seen from its right-hand side.
std::vector<Vec3> upright(double x1, double y1, double x2, double y2) {
    return {{x1, y1, 0}, {x2, y2, 0}, {x2, y2, 2}, {x1, y1, 2}};
}

/// Two rooms side by side, a south of y = 4 and b north of it, joined by a corridor along x = 4, all in one zone. A door in
/// y = 4 leads from a into an attic, which has a zone of its own and overlaps b.
struct Rooms {
    GraphBuilder builder;
    std::uint32_t a = builder.addSpace(), corridor = builder.addSpaceInZoneOf(a),
                  b = builder.addSpaceInZoneOf(a), attic = builder.addSpace();

    Rooms() {
        builder.addOpening({.from = a, .to = corridor, .polygon = upright(4, 3, 4, 1)});
        builder.addOpening({.from = b, .to = corridor, .polygon = upright(4, 7, 4, 5)});
        builder.addOpening({.from = a, .to = attic, .polygon = upright(1, 4, 3, 4)});
    }
    [[nodiscard]] std::string
    fault(const std::vector<std::pair<std::uint32_t, std::vector<Vec3>>>& walls = {}) const {
        const auto built = builder.build();
        if (!built)
            return built.error().message();
        std::vector<WallDesc> descs;
        std::vector<Vec3> vertices;
        for (const auto& [space, polygon] : walls) {
            descs.push_back({space, static_cast<std::uint32_t>(vertices.size()),
                             static_cast<std::uint32_t>(polygon.size())});
            vertices.insert(vertices.end(), polygon.begin(), polygon.end());
        }
        const Result<void> checked = checkZones(built->graph, descs, vertices);
        return checked ? "" : checked.error().message();
    }
};

TEST(ZoneCheck, findsAWallBehindAnOpeningThatLeadsOut) {
    const Rooms rooms;
    EXPECT_EQ(rooms.fault(), "") << "the wall is not known";
    EXPECT_EQ(rooms.fault({{rooms.b, upright(0, 4, 4, 4)}}),
              "portal 1, from space 0 to space 3: leads out of the zone, and a wall of space 2, which is in "
              "the same zone, is "
              "right behind it; give space 2 a zone of its own");
    EXPECT_NE(rooms.fault({{rooms.b, upright(4, 4, 0, 4)}}), "") << "in either winding";
    EXPECT_NE(rooms.fault({{rooms.corridor, upright(2.9, 4, 9, 4)}}), "") << "a part of it";
    // An L with its inner corner at the lower right of the door: only its upper part covers the door.
    EXPECT_NE(
        rooms.fault({{rooms.b, {{3, 4, 0}, {5, 4, 0}, {5, 4, 3}, {0, 4, 3}, {0, 4, 1.5}, {3, 4, 1.5}}}}), "");
}

TEST(ZoneCheck, letsOtherWallsBe) {
    const Rooms rooms;
    EXPECT_EQ(rooms.fault({{rooms.a, upright(3, 4, 4, 4)}, {rooms.a, upright(0, 4, 4, 4)}}), "")
        << "of the space itself";
    EXPECT_EQ(rooms.fault({{rooms.attic, upright(0, 4, 4, 4)}}), "") << "of another zone";
    EXPECT_EQ(rooms.fault({{rooms.b, upright(3, 4, 4, 4)}, {rooms.b, upright(0, 4, 1, 4)}}), "")
        << "beside the opening";
    EXPECT_EQ(rooms.fault({{rooms.b, upright(0, 4.001, 4, 4.001)}}), "") << "a millimetre behind";
    EXPECT_EQ(rooms.fault({{rooms.b, upright(0, 4, 4, 5)}}), "") << "in another plane";
    EXPECT_EQ(rooms.fault({{rooms.b, {{3, 4, 0}, {5, 4, 0}, {5, 4, 4}, {0, 4, 4}, {0, 4, 2}, {3, 4, 2}}}}),
              "")
        << "an L around it";
    EXPECT_EQ(rooms.fault({{rooms.b, {{1, 4, 0}, {3, 4, 2}}}}), "") << "no polygon";
}

TEST(ZoneCheck, findsAPortalBehindAnOpeningWithoutWalls) {
    Rooms rooms;
    rooms.builder.addOpening({.from = rooms.b, .to = rooms.attic, .polygon = upright(2.5, 4, 0.5, 4)});
    EXPECT_EQ(
        rooms.fault(),
        "portal 1, from space 0 to space 3: leads out of the zone, and portal 5 of space 2, which is in "
        "the same zone, is right behind it; give space 2 a zone of its own");
}

TEST(ZoneCheck, findsPairsThatAreNotExactAndSpacesThatAreNotConnected) {
    Rooms oneWay;
    oneWay.builder.addOpening(
        {.from = oneWay.a, .to = oneWay.b, .polygon = upright(0, 9, 1, 9), .oneWay = true});
    EXPECT_EQ(
        oneWay.fault(),
        "portal 2, from space 0 to space 2: leads to a space of the same zone, and has no reciprocal; give "
        "the two spaces different zones");
    Rooms inexact;
    inexact.builder.addOpening({.from = inexact.a,
                                .to = inexact.b,
                                .polygon = upright(0, 9, 1, 9),
                                .backPolygon = upright(1, 9, 0.5, 9)});
    EXPECT_EQ(inexact.fault(),
              "portal 2, from space 0 to space 2: leads to a space of the same zone, and its reciprocal has "
              "another polygon; give the two spaces different zones");
    Rooms apart;
    apart.builder.addSpaceInZoneOf(apart.a);
    EXPECT_EQ(
        apart.fault(),
        "space 4: is in one zone with space 0, but no portals within the zone connect them; give it a zone "
        "of its own");
}

TEST(ZoneCheck, refusesWrongWalls) {
    const Rooms rooms;
    EXPECT_EQ(rooms.fault({{9, upright(0, 4, 4, 4)}}), "wall 0: names a space that does not exist");
    std::vector<Vec3> wall = upright(0, 4, 4, 4);
    wall[2].z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(rooms.fault({{rooms.b, wall}}), "wall 0: has a vertex that is not finite");
    const auto built = rooms.builder.build();
    ASSERT_TRUE(built);
    const std::vector<WallDesc> beyond{{rooms.b, 2, 3}};
    EXPECT_FALSE(checkZones(built->graph, beyond, std::vector<Vec3>(4)));
    const std::vector<WallDesc> wrapped{{rooms.b, 0xFFFFFFFFu, 3}};
    EXPECT_FALSE(checkZones(built->graph, wrapped, std::vector<Vec3>(4)));
}

TEST(ZoneCheck, takesLittleTimeForALargeZone) {
    constexpr std::uint32_t kSide =
        100; // 10,000 rooms of 10 m, each with a door to a closet that leads out of the zone
    GraphBuilder builder;
    std::vector<WallDesc> walls;
    std::vector<Vec3> vertices;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const double x = i % kSide * 10.0, y = i / kSide * 10.0;
        const std::uint32_t room = builder.addSpaceInZoneOf(0);
        if (i % kSide > 0)
            builder.addOpening({.from = room, .to = room - 1, .polygon = upright(x, y + 4, x, y + 6)});
        if (i >= kSide)
            builder.addOpening({.from = room, .to = room - kSide, .polygon = upright(x + 6, y, x + 4, y)});
        const auto wall = upright(x + 2, y + 2, x + 3, y + 2);
        walls.push_back({room, static_cast<std::uint32_t>(vertices.size()), 4});
        vertices.insert(vertices.end(), wall.begin(), wall.end());
    }
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const double x = i % kSide * 10.0, y = i / kSide * 10.0;
        builder.addOpening(
            {.from = i, .to = builder.addSpace(), .polygon = upright(x + 8, y + 3, x + 9, y + 3)});
    }
    const auto built = builder.build();
    ASSERT_TRUE(built) << built.error().message();
    const std::clock_t start = std::clock(); // processor time: the machine may be busy
    const Result<void> checked = checkZones(built->graph, walls, vertices);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_TRUE(checked) << checked.error().message();
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_LT(seconds, 5.0) << "the check has become quadratic";
}

} // namespace
} // namespace limen::visibility
