// Worlds as other authors may write them: no landscape, the last block of the map, portals of every kind.
// Drawn and compared with the ray rule; two of them also with ids stated by hand.
#include "picture/PictureWorld.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

TEST(OddWorlds, aBlockFullOfCellsAndNoLandscape) {
    TestWorld world;
    world.omitRegion();
    std::vector<TestWorld::Cell> cells;
    for (int x = 0; x < 5; ++x) {
        for (int y = 0; y < 5; ++y) {
            cells.push_back(
                world.addBox({x * 5.0 - 40, y * 5.0 - 30, -12}, {x * 5.0 - 35, y * 5.0 - 25, -9}));
        }
    }
    for (int x = 0; x < 5; ++x) {
        for (int y = 0; y < 5; ++y) {
            const Vec3 corner(x * 5.0 - 35, y * 5.0 - 30, -12);
            if (x < 4) {
                world.link(cells[static_cast<std::size_t>(x * 5 + y)],
                           rectangle(corner + Vec3(0, 2, 0), corner + Vec3(0, 3, 2)),
                           cells[static_cast<std::size_t>(x * 5 + y + 5)]);
            }
        }
    }
    PictureWorld pictures(world);
    const world::SpaceIndex root = pictures.space(world.id(cells[2]));
    for (double yaw = 0; yaw < 360; yaw += 45) {
        SCOPED_TRACE(yaw);
        const Picture picture = pictures.expectClean(pictures.look({-38, -17.5, -10.5}, yaw, 0, root));
        EXPECT_EQ(picture.visible.visits.size(), 1u) << "closed cells are one zone";
    }
}

TEST(OddWorlds, aFloorAtTheHeightsOfTheRecordsCoversTheGround) {
    // The floor's triangles are not those of the land: at one height, roundings would choose between them, pixel by pixel.
    TestWorld world;
    dat::LandBlock& land = world.terrain(world.home());
    for (std::size_t i = 0; i < 81; ++i)
        land.heights[i] = static_cast<std::uint8_t>(i / 9 + i % 9); // one plane: z = (x + y) / 12
    const std::uint32_t paving = world.addModel(
        {{{{-5, -3, -8.0 / 12}, {6, -2, 4.0 / 12}, {5, 4, 9.0 / 12}, {-4, 5, 1.0 / 12}}, "stone"}});
    world.addObject(paving, frameAt({83, 71, 154.0 / 12}));
    PictureWorld pictures(world);
    for (double yaw = 0; yaw < 360; yaw += 40) {
        SCOPED_TRACE(yaw);
        const double radians = yaw * 3.14159265358979 / 180;
        const Vec3 eye = Vec3(83, 71, 154.0 / 12 + 9) - 14.0 * Vec3(std::sin(radians), std::cos(radians), 0);
        const Picture picture = pictures.expectClean(pictures.look(eye, yaw, -32, world::kOutside));
        const std::uint32_t floor = picture.id(picture.frame.width / 2, picture.frame.height / 2);
        EXPECT_GT(std::count(picture.ids.begin(), picture.ids.end(), floor), 200);
        for (auto row = picture.ids.begin(); row != picture.ids.end(); row += picture.frame.width) {
            const auto end = row + picture.frame.width;
            const auto first = std::find(row, end, floor);
            const auto last =
                std::find(std::reverse_iterator(end), std::reverse_iterator(first), floor).base();
            EXPECT_EQ(std::count(first, last, floor), last - first) << "no ground within the convex floor";
        }
    }
}

TEST(OddWorlds, portalPolygonsWithoutSurfaceWoundAndFlaggedBothWays) {
    for (const bool insideIsPositive : {false, true}) {
        for (const bool wrongFlag : {false, true}) {
            for (const bool merge : {false, true}) {
                SCOPED_TRACE(::testing::Message() << insideIsPositive << wrongFlag << merge);
                TestWorld world;
                const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
                const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
                TestWorld::LinkOptions link;
                link.insideIsPositive = insideIsPositive;
                link.wrongSideFlag = wrongFlag;
                world.link(a, rectangle({1, 4, 0}, {3, 4, 2}), b, link);
                PictureWorld pictures(world, {merge, 0});
                pictures.expectClean(pictures.look({2, 1, 1.5}, 0, 0, pictures.space(world.id(a))));
                const Picture picture =
                    pictures.expectClean(pictures.look({2, 7, 1.5}, 180, 0, pictures.space(world.id(b))));
                EXPECT_EQ(picture.visible.seen.size(), 2u);
            }
        }
    }
}

TEST(OddWorlds, openingsOfThreeAndOfTwelveEdges) {
    for (const int corners : {3, 12}) {
        for (const bool merge : {false, true}) {
            SCOPED_TRACE(::testing::Message() << corners << " corners, merged " << merge);
            TestWorld world;
            const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
            const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
            const auto c = world.addBox({0, 8, 0}, {4, 12, 3}, "red");
            world.link(a, regularPolygon({2, 4, 1.5}, {0, -1, 0}, 0.9, corners), b);
            world.link(b, regularPolygon({2.3, 8, 1.6}, {0, -1, 0}, 1.1, corners), c);
            PictureWorld pictures(world, {merge, 0});
            for (const double x : {1.2, 2.0, 2.9}) {
                SCOPED_TRACE(x);
                const Picture picture =
                    pictures.expectClean(pictures.look({x, 2.2, 1.4}, 3, 2, pictures.space(world.id(a))));
                EXPECT_EQ(picture.visible.seen.size(), 3u);
            }
        }
    }
}

TEST(OddWorlds, anInexactPairIsOpenWhereBothPolygonsAre) {
    TestWorld world;
    const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
    TestWorld::LinkOptions link;
    link.exact = false;
    link.polygonInB = rectangle({1, 4, 0.5}, {2.5, 4, 2.5});
    world.link(a, rectangle({1.5, 4, 0}, {3, 4, 2}), b, link);
    PictureWorld pictures(world, {true, 0});
    const world::SpaceIndex root = pictures.space(world.id(a));
    const frame::FrameView frame = pictures.look({2, 1, 1.5}, 0, 0, root);
    const Picture picture = pictures.shoot(frame);
    ASSERT_EQ(picture.visible.visits.size(), 3u) << "the hole and the open part";
    // Seen from 3 m before the wall: open from 0.5 m left of the eye to 0.5 m right, from 1 m below it to 0.5
    // m above.
    std::size_t seen = 0;
    for (const std::uint32_t id : picture.ids) {
        const auto i = instanceOfId(pictures.world(), id);
        seen += i != world::kNone && pictures.world().instances[i].record == world.id(b) ? 1 : 0;
    }
    const double pixelsPerMetre = pictures.height / 2.0 / frame.view.tanHalfY / 3.0;
    EXPECT_NEAR(static_cast<double>(seen), 1.0 * 1.5 * pixelsPerMetre * pixelsPerMetre, 40.0);
    EXPECT_EQ(pictures.judge(picture).findings(), 0u);
}

/// A corner of two rooms, one zone when merged. The second room is behind the holes of the first one's north
/// wall.
struct RoundTheCorner {
    TestWorld world;
    TestWorld::Cell first = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    TestWorld::Cell second = world.addBox({4, 0, 0}, {8, 12, 3}, "red");
    TestWorld::Cell behind = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
    RoundTheCorner() { world.link(first, rectangle({4, 1, 0}, {4, 3, 2}), second); }

    void expectTheSameMergedAndApart() {
        PictureWorld merged(world, {true, 0}), apart(world, {false, 0});
        ASSERT_EQ(merged.world().spaces[merged.space(world.id(first))].zone,
                  merged.world().spaces[merged.space(world.id(second))].zone);
        for (double yaw = -20; yaw < 90; yaw += 9.7) {
            SCOPED_TRACE(yaw);
            const auto look = [&](const PictureWorld& pictures) {
                return pictures.look({0.6, 0.7, 1.4}, yaw, 3, pictures.space(world.id(first)));
            };
            const Picture one = merged.shoot(look(merged)), other = apart.shoot(look(apart));
            EXPECT_EQ(merged.judge(one).findings(), 0u);
            EXPECT_EQ(apart.judge(other).findings(), 0u);
            EXPECT_EQ(one.ids, other.ids);
        }
    }
};

TEST(OddWorlds, throughAnInexactPairNothingOfTheOwnZoneShowsWhereOnlyOnePolygonIsOpen) {
    RoundTheCorner corner;
    TestWorld::LinkOptions link;
    link.exact = false;
    link.polygonInB = rectangle({0.8, 4, 0.4}, {2, 4, 2.5});
    corner.world.link(corner.first, rectangle({1, 4, 0}, {3, 4, 2}), corner.behind, link);
    corner.expectTheSameMergedAndApart();
}

TEST(OddWorlds, throughAPortalThatLeadsNowhereNothingOfTheOwnZoneShows) {
    RoundTheCorner corner;
    const auto portals = corner.world.link(corner.first, rectangle({1, 4, 0}, {3, 4, 2}), corner.behind);
    corner.world.record(corner.first).portals[portals.first.index].otherCellId = 0;
    corner.expectTheSameMergedAndApart();
}

TEST(OddWorlds, aOneWayPortalLeadsThroughAndNotBack) {
    TestWorld world;
    const auto a = world.addBox({0, 0, 0}, {4, 4, 3}, "brown");
    const auto b = world.addBox({0, 4, 0}, {4, 8, 3}, "blue");
    TestWorld::LinkOptions link;
    link.oneWay = true;
    world.link(a, rectangle({1, 4, 0.5}, {3, 4, 2}), b, link);
    PictureWorld pictures(world, {true, 0});
    EXPECT_EQ(
        pictures.shoot(pictures.look({2, 1, 1.5}, 0, 0, pictures.space(world.id(a)))).visible.seen.size(),
        2u);
    EXPECT_EQ(
        pictures.shoot(pictures.look({2, 7, 1.5}, 180, 0, pictures.space(world.id(b)))).visible.seen.size(),
        1u);
}

TEST(OddWorlds, aWholePictureOfTwoRoomsStatedByHand) {
    // Looking north from the middle of a room 8 m wide and high, 4 m before its far wall, 90 degrees, 8×8
    // pixels: each pixel is 1 m of that wall. Its opening is the middle 4×4 m. The next room's far wall is 4
    // m behind it.
    for (const bool merge : {false, true}) {
        TestWorld world;
        const auto a = world.addBox({0, 0, 0}, {8, 8, 8}, "brown");
        const auto b = world.addBox({0, 8, 0}, {8, 12, 8}, "blue");
        world.link(a, rectangle({2, 8, 2}, {6, 8, 6}), b);
        PictureWorld pictures(world, {merge, 0});
        pictures.width = pictures.height = 8;
        pictures.fov = 90.0;
        const Picture picture = pictures.shoot(pictures.look({4, 4, 4}, 0, 0, pictures.space(world.id(a))));
        for (std::uint32_t y = 0; y < 8; ++y) {
            for (std::uint32_t x = 0; x < 8; ++x) {
                const bool opening = x >= 2 && x < 6 && y >= 2 && y < 6;
                const auto i = instanceOfId(pictures.world(), picture.id(x, y));
                ASSERT_NE(i, world::kNone) << x << " " << y;
                EXPECT_EQ(pictures.world().instances[i].record, world.id(opening ? b : a)) << x << " " << y;
            }
        }
        // The far wall behind the opening is 8 m away: one polygon, one id.
        for (std::uint32_t y = 2; y < 6; ++y)
            for (std::uint32_t x = 2; x < 6; ++x)
                EXPECT_EQ(picture.id(x, y), picture.id(3, 3));
    }
}

TEST(OddWorlds, aWholePictureOfGroundAndSkyStatedByHand) {
    // Level view over flat ground, eye 10 m above it: sky above the middle, ground below.
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    PictureWorld pictures(world, {true, 0});
    pictures.width = pictures.height = 8;
    pictures.fov = 90.0;
    const Picture picture = pictures.shoot(pictures.look({96, 1, 10}, 0, 0, world::kOutside));
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 8; ++x) {
            if (y < 4) {
                EXPECT_EQ(picture.id(x, y), 1u) << x << " " << y;
            } else {
                const auto i = instanceOfId(pictures.world(), picture.id(x, y));
                ASSERT_NE(i, world::kNone);
                EXPECT_EQ(pictures.world().instances[i].kind, world::InstanceKind::Terrain);
            }
        }
    }
}

TEST(OddWorlds, aHoleShowsAsVoidAndNothingElse) {
    TestWorld world;
    Walls walls = boxWalls({0, 0, 0}, {4, 4, 3}, "brown");
    walls.erase(walls.begin() + kNorth);
    const auto a = world.addCell(walls);
    world.setFlatTerrain(world.home(), 0);
    PictureWorld pictures(world, {true, 0});
    const Picture picture = pictures.shoot(pictures.look({2, 1, 1.5}, 0, 0, pictures.space(world.id(a))));
    EXPECT_EQ(picture.id(pictures.width / 2, pictures.height / 2), 0u)
        << "no sky, no terrain: no ray got outside";
}

TEST(OddWorlds, callsAreFewAndTheSameWhateverIsSeen) {
    TestWorld world;
    std::vector<TestWorld::Cell> row;
    for (int i = 0; i < 20; ++i)
        row.push_back(world.addBox({0, i * 4.0, 0}, {4, i * 4.0 + 4, 3}));
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
        const double y = 4.0 * static_cast<double>(i + 1);
        world.link(row[i], rectangle({1, y, 0}, {3, y, 2.5}), row[i + 1]);
    }
    PictureWorld pictures(world, {false, 0});
    const Picture few = pictures.shoot(pictures.look({2, 70, 1.5}, 0, 0, pictures.space(world.id(row[17]))));
    const Picture many = pictures.shoot(pictures.look({2, 1, 1.5}, 0, 0, pictures.space(world.id(row[0]))));
    EXPECT_EQ(few.visible.visits.size(), 3u);
    EXPECT_EQ(many.visible.visits.size(), 20u);
    EXPECT_EQ(few.stages, many.stages);
    EXPECT_EQ(few.glCalls, many.glCalls);
    EXPECT_LE(many.glCalls, 40u);
}

} // namespace
} // namespace limen::test
