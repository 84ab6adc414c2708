// The ray rule, sentence by sentence, on worlds small enough for answers computed by hand.
#include "reference/TracedWorld.h"

#include "world/terrain/Terrain.h"

namespace limen::test {
namespace {

using reference::Answer;
constexpr double kExact = 1e-9; // metres

TEST(Rule, theSixWallsOfABoxAreAtTheirDistances) {
    TestWorld source;
    const auto cell = source.addBox({0, 0, 10}, {4, 5, 13});
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    const Vec3 eye(1, 2, 11);
    const std::pair<Vec3, double> walls[] = {{{1, 0, 0}, 3},  {{-1, 0, 0}, 1}, {{0, 1, 0}, 3},
                                             {{0, -1, 0}, 2}, {{0, 0, 1}, 2},  {{0, 0, -1}, 1}};
    std::vector<std::uint32_t> ids;
    for (const auto& [direction, distance] : walls) {
        const Answer answer = traced.trace(room, eye, direction);
        EXPECT_NEAR(answer.t, distance, kExact);
        EXPECT_TRUE(traced.isShell(answer.id, room));
        EXPECT_EQ(answer.space, room);
        EXPECT_EQ(answer.spacesVisited, 1u);
        EXPECT_FALSE(answer.reachedOutside);
        ids.push_back(answer.id);
    }
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end()) << "every wall shows an id of its own";
    EXPECT_NEAR(traced.trace(room, eye, {1, 0.5, 0.25}).t, 3.0, kExact);
    EXPECT_NEAR(traced.trace(room, eye, {10, 5, 2.5}).t, 0.3, kExact) << "t counts the direction's length";
    EXPECT_NEAR(traced.trace(room, eye, {1e-3, 1e-3, 1}).t, 2.0, kExact);
}

TEST(Rule, everyRayFromInsideAClosedCellEndsInIt) {
    // Corners and edges included: a million directions on a grid that has many of them exactly.
    TestWorld source;
    const auto cell = source.addBox({0, 0, 10}, {4, 4, 14});
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    for (int x = -20; x <= 20; ++x) {
        for (int y = -20; y <= 20; ++y) {
            for (const int z : {-20, 20}) {
                const Vec3 d(x, y, z);
                for (const Vec3& direction : {d, Vec3(d.y, d.z, d.x), Vec3(d.z, d.x, d.y)})
                    ASSERT_TRUE(traced.isShell(traced.trace(room, {2, 2, 12}, direction).id, room))
                        << direction.x << " " << direction.y << " " << direction.z;
            }
        }
    }
}

TEST(Rule, anOpaquePictureInAnOpeningEndsRaysFromItsSide) {
    TestWorld::LinkOptions options;
    options.surface = "painted door";
    TwoRooms rooms(options);
    const TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                            east = traced.space(rooms.world.id(rooms.east));
    const Answer there = traced.trace(west, {1, 2, 11}, {1, 0, 0});
    EXPECT_NEAR(there.t, 3.0, kExact);
    EXPECT_EQ(there.space, west);
    EXPECT_TRUE(traced.isShell(there.id, west));
    const Answer back = traced.trace(east, {7, 2, 11}, {-1, 0, 0});
    EXPECT_NEAR(back.t, 7.0, kExact) << "the western wall: the picture shows its back";
    EXPECT_EQ(back.space, west);
}

TEST(Rule, aTransparentPictureInAnOpeningIsALayer) {
    TestWorld::LinkOptions options;
    options.surface = "pane";
    TestWorld source;
    source.solid("pane", 0xFF80A0C0u, dat::Surface::kTranslucent, 0.5f);
    const auto a = source.addBox({0, 0, 10}, {4, 4, 13}), b = source.addBox({4, 0, 10}, {8, 4, 13});
    source.link(a, rectangle({4, 1.5, 10}, {4, 2.5, 12}), b, options);
    const TracedWorld traced(source);
    const Answer through = traced.trace(traced.space(source.id(a)), {1, 2, 11}, {1, 0, 0});
    EXPECT_NEAR(through.t, 7.0, kExact);
    EXPECT_EQ(through.layers.count, 1u);
    const Answer back = traced.trace(traced.space(source.id(b)), {7, 2, 11}, {-1, 0, 0});
    EXPECT_EQ(back.layers.count, 0u) << "it is one-sided";
}

TEST(Rule, aDoorLeadsIntoTheNextRoomAndAWallDoesNot) {
    TwoRooms rooms;
    const TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                            east = traced.space(rooms.world.id(rooms.east));
    const Answer through = traced.trace(west, {1, 2, 11}, {1, 0, 0});
    EXPECT_NEAR(through.t, 7.0, kExact);
    EXPECT_EQ(through.space, east);
    EXPECT_TRUE(traced.isShell(through.id, east));
    EXPECT_EQ(through.spacesVisited, 2u);
    const Answer beside = traced.trace(west, {1, 3, 11}, {1, 0, 0});
    EXPECT_NEAR(beside.t, 3.0, kExact);
    EXPECT_TRUE(traced.isShell(beside.id, west));
    const Answer back = traced.trace(east, {7, 2, 11}, {-1, 0, 0});
    EXPECT_NEAR(back.t, 7.0, kExact);
    EXPECT_EQ(back.space, west);
    // A millimetre to either side of the door's edge at y = 2.5.
    EXPECT_EQ(traced.trace(west, {1, 2.499, 11}, {1, 0, 0}).space, east);
    EXPECT_EQ(traced.trace(west, {1, 2.501, 11}, {1, 0, 0}).space, west);
}

TEST(Rule, raysAlongTheRimOfADoorNeverSlip) {
    // Wall and opening share the rim to the bit. A ray meets one of them, independent of rounding.
    TwoRooms rooms;
    const TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                            east = traced.space(rooms.world.id(rooms.east));
    for (const Vec3& eye : {Vec3(1.1, 1.7, 11.3), Vec3(3.99, 2.2, 10.4), Vec3(0.37, 0.91, 12.77)}) {
        for (int i = 0; i <= 3000; ++i) {
            const double share = i / 3000.0;
            for (const Vec3& rim : {Vec3(4, 1.5, 10 + 2 * share), Vec3(4, 2.5, 10 + 2 * share),
                                    Vec3(4, 1.5 + share, 12), Vec3(4, 1.5 + share, 10)}) {
                const Answer answer = traced.trace(west, eye, rim - eye);
                const bool atWall = traced.isShell(answer.id, west) && std::abs(answer.t - 1.0) < 1e-9;
                const bool beyond = traced.isShell(answer.id, east) && answer.t > 1.0 - 1e-9;
                ASSERT_TRUE(atWall || beyond) << "t " << answer.t << " id " << answer.id;
            }
        }
    }
}

TEST(Rule, onlyTheSpaceTheRayIsInIsMet) {
    // A third room stands across both others and is linked to neither: nothing of it is met from them.
    TwoRooms rooms;
    const auto across = rooms.world.addBox({2, 1, 10.5}, {6, 3, 12.5}, "red");
    const TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west));
    EXPECT_NEAR(traced.trace(west, {1, 2, 11}, {1, 0, 0}).t, 7.0, kExact);
    const Answer inside = traced.trace(traced.space(rooms.world.id(across)), {3, 2, 11}, {1, 0, 0});
    EXPECT_NEAR(inside.t, 3.0, kExact) << "and of them nothing from it";
}

TEST(Rule, terrainRunsThroughACellarUnseen) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 1); // z = 2
    const auto cellar = source.addBox({90, 80, -3}, {96, 86, 3});
    const TracedWorld traced(source);
    const Answer down = traced.trace(traced.space(source.id(cellar)), {93, 83, 2.5}, {0, 0, -1});
    EXPECT_NEAR(down.t, 5.5, kExact) << "the cellar's floor, not the ground";
    const Answer outside = traced.trace(world::kOutside, {93, 83, 2.5}, {0, 0, -1});
    EXPECT_NEAR(outside.t, 2.5 - world::landHeight(2.0f), kExact);
    EXPECT_EQ(traced.kindOf(outside.id), world::InstanceKind::Terrain);
}

TEST(Rule, terrainIsMetFromAboveOnly) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 2); // z = 4
    const TracedWorld traced(source);
    const Answer above = traced.trace(world::kOutside, {50, 60, 10}, {0, 0, -1});
    EXPECT_NEAR(above.t, 10.0 - world::landHeight(4.0f), kExact);
    const Answer below = traced.trace(world::kOutside, {50, 60, 1}, {0, 0, 1});
    EXPECT_EQ(below.id, 1u);
    EXPECT_TRUE(std::isinf(below.t) && below.t > 0);
    EXPECT_TRUE(below.reachedOutside);
}

TEST(Rule, backFacesAreNotMetAndTwoSidedOnesAreFromBothSides) {
    TestWorld source;
    const auto cell = source.addBox({0, 0, 10}, {8, 4, 14});
    source.addStatic(cell, source.addModel(insideOut(boxWalls({-1, -1, -1}, {1, 1, 1}, "red"))),
                     frameAt({4, 2, 12}));
    Wall leaf{rectangle({0, -0.2, -0.2}, {0, 0.2, 0.2}), "green", true};
    source.addStatic(cell, source.addModel({leaf}), frameAt({7, 2, 12}));
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    const Answer front = traced.trace(room, {0.5, 2, 12}, {1, 0, 0});
    EXPECT_NEAR(front.t, 2.5, kExact);
    EXPECT_EQ(traced.kindOf(front.id), world::InstanceKind::Static);
    const Answer fromWithin = traced.trace(room, {4, 2, 12}, {1, 0, 0});
    EXPECT_NEAR(fromWithin.t, 3.0, 1e-6) << "out through the block's back face to the leaf";
    const Answer otherSide = traced.trace(room, {7.5, 2, 12}, {-1, 0, 0});
    EXPECT_NEAR(otherSide.t, 0.5, 1e-6);
    EXPECT_EQ(traced.instanceOf(fromWithin.id), traced.instanceOf(otherSide.id));
}

TEST(Rule, aRayThatComesBackOutsideMeetsWhatIsBeyondTheLastPortal) {
    // Outside, in by the window, out by the door; the eye side's ground and walls are on the ray no more.
    House house;
    house.world.addObject(house.world.addModel({{rectangle({-2, 0, -2}, {2, 0, 2}), "red", true}}),
                          frameAt({93, 96, 1.5}));
    // Outside's, though it stands in the room: too far from door and window to be the room's, too.
    house.world.addObject(house.world.addModel({{rectangle({-0.3, 0, -0.3}, {0.3, 0, 0.3}), "blue", true}}),
                          frameAt({93, 83, 1.5}));
    const TracedWorld traced(house.world);
    for (const bool north : {true, false}) {
        const Answer answer = north ? traced.trace(world::kOutside, {93, 70, 1.5}, {0, 1, 0})
                                    : traced.trace(world::kOutside, {93, 95, 1.5}, {0, -0.5, 0});
        EXPECT_EQ(answer.spacesVisited, 3u);
        EXPECT_EQ(answer.space, world::kOutside);
        EXPECT_TRUE(answer.reachedOutside);
        if (north) {
            EXPECT_NEAR(answer.t, 26.0, 1e-6) << "the red panel beyond the door";
            EXPECT_EQ(traced.kindOf(answer.id), world::InstanceKind::Static);
        } else {
            EXPECT_EQ(answer.id, 1u) << "nothing stands in the south";
        }
    }
    const Answer within = traced.trace(traced.space(house.world.id(house.room)), {93, 82, 1.5}, {0, 1, 0});
    EXPECT_NEAR(within.t, 14.0, 1e-6);
    EXPECT_TRUE(within.reachedOutside);
    const Answer wall = traced.trace(world::kOutside, {91, 70, 1.5}, {0, 1, 0});
    EXPECT_NEAR(wall.t, 10.0, kExact);
    EXPECT_EQ(traced.kindOf(wall.id), world::InstanceKind::Exterior);
}

TEST(Rule, nothingIsAHoleInACellAndTheSkyOutside) {
    TestWorld source;
    Walls walls = boxWalls({0, 0, 10}, {4, 4, 13});
    walls.erase(walls.begin() + kEast);
    const auto cell = source.addCell(std::move(walls));
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    const Answer hole = traced.trace(room, {1, 2, 11}, {1, 0, 0});
    EXPECT_EQ(hole.id, 0u);
    EXPECT_TRUE(std::isnan(hole.t));
    EXPECT_EQ(hole.space, room);
    const Answer sky = traced.trace(world::kOutside, {1, 2, 11}, {0, 0, 1});
    EXPECT_EQ(sky.id, 1u);
    EXPECT_TRUE(std::isinf(sky.t));
}

TEST(Rule, aOneWayPortalLeadsThroughAndIsAHoleFromBehind) {
    TestWorld::LinkOptions link;
    link.oneWay = true;
    TwoRooms rooms(link);
    const TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                            east = traced.space(rooms.world.id(rooms.east));
    EXPECT_EQ(traced.trace(west, {1, 2, 11}, {1, 0, 0}).space, east);
    const Answer back = traced.trace(east, {7, 2, 11}, {-1, 0, 0});
    EXPECT_EQ(back.id, 0u);
    EXPECT_EQ(back.space, east);
}

TEST(Rule, aTexelOfACutOutDecides) {
    // 4 × 1 texels, alpha 255, 200, 199, 0: two count, two do not. The panel looks west, so that u falls
    // along y.
    TestWorld source;
    dat::RenderSurface image = solidImage(4, 1, 0xFFFFFFFFu);
    image.pixels[4 * 1 + 3] = 200;
    image.pixels[4 * 2 + 3] = 199;
    image.pixels[4 * 3 + 3] = 0;
    source.picture("bars", image, dat::Surface::kBase1ClipMap);
    const auto cell = source.addBox({0, 0, 10}, {4, 4, 14});
    std::vector<Vec3> points = rectangle({0, -1, -1}, {0, 1, 1});
    std::reverse(points.begin(), points.end());
    source.addStatic(cell, source.addModel({{points, "bars", false}}), frameAt({3, 2, 12}));
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    int solid = 0, open = 0;
    for (int i = -31; i < 32; i += 2) { // 32 rays over 2 m, in the middles of the texels' halves
        const double y = i / 32.0;
        const Answer answer = traced.trace(room, {1, 2 + y, 12.3}, {1, 0, 0});
        const double u = -y - std::floor(-y);
        const bool counts = u < 0.5;
        EXPECT_NEAR(answer.t, counts ? 2.0 : 3.0, 1e-6) << "y " << y;
        (counts ? solid : open) += 1;
    }
    EXPECT_EQ(solid, 16);
    EXPECT_EQ(open, 16);
}

TEST(Rule, anInexactPairIsOpenWhereBothPolygonsAre) {
    TestWorld::LinkOptions link;
    link.exact = false;
    link.polygonInB = rectangle({4, 2, 10.5}, {4, 3, 12.5});
    TwoRooms rooms(link); // west's is y 1.5..2.5, z 10..12
    const TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                            east = traced.space(rooms.world.id(rooms.east));
    EXPECT_EQ(traced.trace(west, {1, 2.25, 11}, {1, 0, 0}).space, east);
    const Answer onlyWest = traced.trace(west, {1, 1.75, 11}, {1, 0, 0});
    EXPECT_EQ(onlyWest.id, 0u) << "through west's polygon alone: a hole";
    const Answer onlyEast = traced.trace(west, {1, 2.75, 11}, {1, 0, 0});
    EXPECT_TRUE(traced.isShell(onlyEast.id, west)) << "west has a wall there";
    EXPECT_NEAR(onlyEast.t, 3.0, kExact);
    EXPECT_EQ(traced.trace(east, {7, 2.25, 11}, {-1, 0, 0}).space, west);
    EXPECT_EQ(traced.trace(east, {7, 2.75, 11}, {-1, 0, 0}).id, 0u);
    EXPECT_NEAR(traced.trace(east, {7, 1.75, 11}, {-1, 0, 0}).t, 3.0, kExact);
}

TEST(Rule, longChainsAndLoopsOfRoomsAreFollowed) {
    // Forty rooms in a row, doors in line; and the last leads back into the first, which stands elsewhere.
    TestWorld source;
    std::vector<TestWorld::Cell> cells;
    for (int i = 0; i < 40; ++i)
        cells.push_back(source.addBox({i * 2.0, 0, 10}, {i * 2.0 + 2, 4, 13}));
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
        const double x = 2.0 * static_cast<double>(i) + 2.0;
        source.link(cells[i], rectangle({x, 1, 10}, {x, 3, 12}), cells[i + 1]);
    }
    const TracedWorld traced(source, {.radius = 0});
    const Answer answer = traced.trace(traced.space(source.id(cells.front())), {1, 2, 11}, {1, 0, 0});
    EXPECT_EQ(answer.spacesVisited, 40u);
    EXPECT_NEAR(answer.t, 79.0, kExact);
}

} // namespace
} // namespace limen::test
