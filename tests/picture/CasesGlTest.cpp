// Hard cases of docs/cases.md, drawn by the whole pipeline and compared with the ray rule. Every world is run
// twice: with cells merged into zones, and with every cell as a zone.
#include "picture/PictureWorld.h"

#include "motion/Locate.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

struct Cases : ::testing::TestWithParam<bool> {
    [[nodiscard]] PictureOptions options() const { return {GetParam(), 1}; }
};
INSTANTIATE_TEST_SUITE_P(Zones, Cases, ::testing::Bool(),
                         [](const auto& zones) { return zones.param ? "merged" : "apart"; });

/// Two rooms, 4 × 4 × 3 m, joined by a door 1 m wide and 2 m high in the plane x = 4.
struct TwoRooms {
    TestWorld world;
    TestWorld::Cell west = world.addBox({0, 0, 10}, {4, 4, 13}, "brown");
    TestWorld::Cell east = world.addBox({4, 0, 10}, {8, 4, 13}, "blue");
    TwoRooms() { world.link(west, rectangle({4, 1.5, 10}, {4, 2.5, 12}), east); }
};

/// A yard with two houses that face each other across it. Each has one room with a door (in line with the
/// other's) and, in the back wall, a window in line with the door.
struct TwoHouses {
    TestWorld world;
    TestWorld::Cell south = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
    TestWorld::Cell north = world.addBox({90, 100, 0}, {96, 106, 3}, "blue");
    TestWorld::Cell aside = world.addBox({120, 100, 0}, {126, 106, 3}, "red");
    TwoHouses() {
        world.setFlatTerrain(world.home(), 0);
        const auto house = [&](TestWorld::Cell cell, const Vec3& min, const Vec3& max, bool doorNorth) {
            const double door = doorNorth ? max.y : min.y;
            const double back = doorNorth ? min.y : max.y;
            const auto exit = world.openOutside(cell, rectangle({92, door, 0.1}, {93.2, door, 2.1}));
            const auto window = world.openOutside(cell, rectangle({92, back, 1}, {93.2, back, 2}));
            world.addBuilding(boxExterior(min, max), {exit, window});
        };
        house(south, {90, 80, 0}, {96, 86, 3}, true);
        house(north, {90, 100, 0}, {96, 106, 3}, false);
        const auto exit = world.openOutside(aside, rectangle({122, 100, 0.1}, {123.2, 100, 2.1}));
        world.addBuilding(boxExterior({120, 100, 0}, {126, 106, 3}), {exit});
    }
};

std::size_t pixelsOf(const PictureWorld& pictures, const Picture& picture, world::SpaceIndex space) {
    std::size_t count = 0;
    for (const std::uint32_t id : picture.ids) {
        const std::uint32_t instance = instanceOfId(pictures.world(), id);
        count += instance != world::kNone && pictures.world().instances[instance].placedIn == space ? 1 : 0;
    }
    return count;
}

bool visits(const Picture& picture, world::SpaceIndex space) {
    return std::any_of(picture.visible.visits.begin(), picture.visible.visits.end(),
                       [&](const visibility::Visit& v) { return v.space == space; });
}

void expectNoRepeats(const Picture& picture) {
    const auto& all = picture.visible.visits;
    for (const visibility::Visit& visit : all)
        for (std::uint32_t up = visit.parent; up != visibility::kNone && all[up].depth > 0;
             up = all[up].parent)
            EXPECT_NE(all[up].portal, visit.portal) << "a portal repeats in a chain of visits";
}

TEST_P(Cases, case01_walkingADoorwayInMillimetreSteps) {
    TwoRooms rooms;
    PictureWorld pictures(rooms.world, options());
    pictures.width = 64;
    pictures.height = 40;
    for (const int direction : {1, -1}) {
        world::SpaceIndex space = pictures.space(rooms.world.id(direction > 0 ? rooms.west : rooms.east));
        Vec3 last(4.0 - direction * 0.025, 2.1, 11.6);
        for (int step = 0; step <= 50; ++step) {
            const Vec3 eye(4.0 + direction * (-0.025 + step * 0.001), 2.1, 11.6);
            space = motion::sweep(pictures.world(), space, pictures.homeOrigin() + last,
                                  pictures.homeOrigin() + eye);
            last = eye;
            SCOPED_TRACE(::testing::Message() << "step " << step << " direction " << direction);
            expectNoRepeats(
                pictures.expectClean(pictures.look(eye, 90 - direction * (step * 4.0 - 100), 5, space)));
        }
        EXPECT_EQ(space, pictures.space(rooms.world.id(direction > 0 ? rooms.east : rooms.west)));
    }
}

TEST_P(Cases, case03_eyeExactlyInAPortalPlane) {
    TwoRooms rooms;
    PictureWorld pictures(rooms.world, options());
    const world::SpaceIndex west = pictures.space(rooms.world.id(rooms.west));
    for (const double yaw : {0.0, 45.0, 90.0, 180.0, 270.0}) {
        SCOPED_TRACE(yaw);
        pictures.expectClean(pictures.look({4, 2, 11}, yaw, 0, west));
    }
}

TEST_P(Cases, case05_theNearPlaneCutsAPortalPolygon) {
    TwoRooms rooms;
    PictureWorld pictures(rooms.world, options());
    const world::SpaceIndex west = pictures.space(rooms.world.id(rooms.west));
    for (const double gap : {0.019, 0.01, 0.004, 0.001, 0.0003}) {
        for (const double yaw : {20.0, 60.0, 90.0, 130.0}) {
            SCOPED_TRACE(::testing::Message() << gap << " m before the door, yaw " << yaw);
            pictures.expectClean(pictures.look({4 - gap, 1.7, 11.5}, yaw, -10, west));
        }
    }
}

TEST_P(Cases, case08_someoneInADoorwaySeenFromOutside) {
    TwoHouses houses;
    const std::uint32_t body =
        houses.world.addModel(insideOut(boxWalls({-0.3, -0.3, 0}, {0.3, 0.3, 1.8}, "pink")));
    houses.world.addObject(body, frameAt({92.6, 100.0, 0.1})); // half inside the northern house's door
    PictureWorld pictures(houses.world, options());
    const Picture picture = pictures.expectClean(pictures.look({92.6, 94, 1.2}, 0, 0, world::kOutside));
    // Fully visible: 0.6 m by 1.8 m at 5.7 m, its front face before the door's plane.
    std::size_t seen = 0;
    for (const std::uint32_t id : picture.ids) {
        const std::uint32_t i = instanceOfId(pictures.world(), id);
        seen +=
            i != world::kNone && pictures.world().instances[i].kind == world::InstanceKind::Static ? 1 : 0;
    }
    const double pixelsPerMetre = pictures.height / 2.0 / picture.frame.view.tanHalfY / 5.7;
    EXPECT_NEAR(static_cast<double>(seen), 0.6 * 1.8 * pixelsPerMetre * pixelsPerMetre, 20.0);
    for (double y = 98.0; y < 104.0; y += 0.37) { // and from within, and from the threshold
        SCOPED_TRACE(y);
        const Vec3 eye(93.1, y, 1.5);
        pictures.expectClean(
            pictures.look(eye, 240, -5, motion::locate(pictures.world(), pictures.homeOrigin() + eye).space));
    }
}

TEST_P(Cases, case10_fromACellarUpTheStairsAndOut) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 2); // 4 m: the cellar is wholly below
    const auto cellar = world.addBox({90, 90, 0}, {96, 96, 3}, "brown");
    const auto shaft = world.addBox({96, 90, 0}, {100, 96, 7}, "blue");
    world.link(cellar, rectangle({96, 91, 0}, {96, 95, 3}), shaft);
    const auto exit = world.openOutside(shaft, rectangle({100, 91, 4.2}, {100, 95, 6.8}));
    world.addBuilding(boxExterior({96, 90, 3}, {100, 96, 7}), {exit});
    PictureWorld pictures(world, options());
    bool sawOutside = false;
    for (const double x : {90.5, 93.0, 95.9, 96.1, 98.0}) {
        for (const double z : {0.6, 1.6, 2.6}) {
            SCOPED_TRACE(::testing::Message() << x << " " << z);
            const world::SpaceIndex root = pictures.space(world.id(x < 96 ? cellar : shaft));
            const Picture picture = pictures.expectClean(pictures.look({x, 93, z}, 90, 35, root));
            sawOutside = sawOutside || pixelsOf(pictures, picture, world::kOutside) > 0 ||
                         std::count(picture.ids.begin(), picture.ids.end(), 1u) > 0;
        }
    }
    EXPECT_TRUE(sawOutside) << "no view looked out";
}

TEST_P(Cases, case11_aStillEyeGivesIdenticalFrames) {
    TwoHouses houses;
    PictureWorld pictures(houses.world, options());
    const frame::FrameView frame =
        pictures.look({92.6, 82, 1.6}, 3, 0, pictures.space(houses.world.id(houses.south)));
    const Picture first = pictures.expectClean(frame);
    for (int i = 0; i < 5; ++i) {
        const Picture next = pictures.shoot(frame);
        EXPECT_TRUE(next.ids == first.ids && next.depth == first.depth && next.colour == first.colour);
    }
}

TEST_P(Cases, case13_throughAWindowIntoTheNeighboursDoor) {
    TwoHouses houses;
    PictureWorld pictures(houses.world, options());
    pictures.width = 240;
    pictures.height = 160;
    const world::SpaceIndex north = pictures.space(houses.world.id(houses.north));
    const world::SpaceIndex aside = pictures.space(houses.world.id(houses.aside));
    const Picture picture = pictures.expectClean(
        pictures.look({92.6, 83, 1.5}, 0, 0, pictures.space(houses.world.id(houses.south))));
    EXPECT_GT(pixelsOf(pictures, picture, north), 10u) << "the neighbour's interior is there";
    EXPECT_FALSE(visits(picture, aside)) << "a house outside the door's region is not flooded";
}

TEST_P(Cases, depthIsTheDistanceOfWhatIsSeen) {
    TwoHouses houses;
    PictureWorld pictures(houses.world, options());
    const auto frame = pictures.look({92.6, 83, 1.5}, 3, 2, pictures.space(houses.world.id(houses.south)));
    const Picture picture = pictures.expectClean(frame);
    std::size_t compared = 0;
    for (std::uint32_t y = 0; y < frame.height; ++y) {
        for (std::uint32_t x = 0; x < frame.width; ++x) {
            const auto traced = pictures.tracer().trace(frame.view.root, rayThrough(frame, x, y));
            const float depth = picture.depth[y * frame.width + x];
            if (traced.id == picture.id(x, y) && traced.id > 1) {
                EXPECT_NEAR(frame.nearPlane / static_cast<double>(depth), traced.t, 0.002 * traced.t)
                    << x << " " << y;
                ++compared;
            } else if (traced.id == 1 && picture.id(x, y) == 1) {
                EXPECT_EQ(depth, 0.0f) << "the sky is infinitely far";
            }
        }
    }
    EXPECT_GT(compared, frame.width * frame.height / 2);
}

TEST_P(Cases, case14_aHouseSeenFrontToBack) {
    TwoHouses houses;
    PictureWorld pictures(houses.world, options());
    const Picture picture = pictures.expectClean(pictures.look({92.6, 90, 1.5}, 180, 0, world::kOutside));
    const auto& all = picture.visible.visits;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const auto& v) {
        return v.depth == 2 && v.zone == 0;
    })) << "outside, through the house, outside again";
    EXPECT_GT(pixelsOf(pictures, picture, pictures.space(houses.world.id(houses.south))), 10u);
}

TEST_P(Cases, case24_emptyOutdoorsIsTheLandscapeAlone) {
    TwoHouses houses;
    TestWorld bare;
    bare.setFlatTerrain(bare.home(), 0);
    PictureWorld pictures(houses.world, options());
    PictureWorld alone(bare, options());
    const Picture a = pictures.expectClean(pictures.look({30, 30, 1.7}, 225, -10, world::kOutside));
    const Picture b = alone.expectClean(alone.look({30, 30, 1.7}, 225, -10, world::kOutside));
    EXPECT_EQ(a.visible.visits.size(), 1u);
    EXPECT_TRUE(a.colour == b.colour);
    EXPECT_TRUE(a.depth == b.depth);
}

TEST_P(Cases, case25_theFarCornerOfTheMap) {
    std::vector<std::vector<std::uint32_t>> ids;
    for (const dat::BlockCoord home :
         {dat::BlockCoord{0, 0}, dat::BlockCoord{0x20, 0x30}, dat::BlockCoord{0xFE, 0xFE}}) {
        TestWorld world(home);
        world.setFlatTerrain(world.home(), 0);
        const auto room = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
        const auto closet = world.addBox({96, 80, 0}, {99, 86, 3}, "blue");
        world.link(room, rectangle({96, 82, 0}, {96, 83, 2}), closet);
        const auto exit = world.openOutside(room, rectangle({92, 86, 0.1}, {93.2, 86, 2.1}));
        world.addBuilding(boxExterior({90, 80, 0}, {99, 86, 3}), {exit});
        PictureWorld pictures(world, options());
        ids.emplace_back();
        for (const double yaw : {10.0, 60.0, 100.0}) {
            const auto picture = pictures.expectClean(
                pictures.look({92.3, 82.1, 1.6}, yaw, 0, pictures.space(world.id(room))));
            for (const std::uint32_t id :
                 picture.ids) { // a landcell's diagonal depends on its position on the map
                const auto i = instanceOfId(pictures.world(), id);
                const bool ground =
                    i != world::kNone && pictures.world().instances[i].kind == world::InstanceKind::Terrain;
                ids.back().push_back(ground ? world::kNone : id);
            }
        }
    }
    EXPECT_EQ(ids[0], ids[1]);
    EXPECT_EQ(ids[0], ids[2]);
}

TEST_P(Cases, case28_aTunnelThroughAHill) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    for (int x = 3; x <= 5; ++x) // a hill 8 m high across the middle of the block
        for (int y = 0; y <= 8; ++y)
            world.terrain(world.home()).heights[static_cast<std::size_t>(x * 9 + y)] = 4;
    const auto tunnel = world.addBox({50, 90, 0}, {142, 94, 3}, "brown");
    const auto west = world.openOutside(tunnel, rectangle({50, 90.5, 0.2}, {50, 93.5, 2.8}));
    const auto east = world.openOutside(tunnel, rectangle({142, 90.5, 0.2}, {142, 93.5, 2.8}));
    world.addBuilding(boxExterior({50, 90, 0}, {142, 94, 3}), {west, east});
    PictureWorld pictures(world, options());
    const Picture picture = pictures.expectClean(pictures.look({44, 92, 1.5}, 90, 0, world::kOutside));
    EXPECT_EQ(picture.visible.visits.size(), 3u) << "outside, tunnel, outside beyond";
}

TEST_P(Cases, case28_houseBehindTreeBehindHouse) {
    TwoHouses houses;
    const std::uint32_t tree =
        houses.world.addModel(insideOut(boxWalls({-0.2, -0.2, 0}, {0.2, 0.2, 4}, "green")));
    houses.world.addObject(tree, frameAt({92.5, 93, 0}));
    PictureWorld pictures(houses.world, options());
    for (const double y : {76.0, 79.0, 82.0, 85.9}) {
        SCOPED_TRACE(y);
        const Vec3 eye(92.6, y, 1.5);
        const auto root = motion::locate(pictures.world(), pictures.homeOrigin() + eye).space;
        const Picture picture = pictures.expectClean(pictures.look(eye, 0, 0, root));
        EXPECT_TRUE(visits(picture, pictures.space(houses.world.id(houses.north))));
    }
}

TEST_P(Cases, case28_aUShapedHouseWhoseWindowsFaceEachOther) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    const auto left = world.addBox({90, 90, 0}, {94, 100, 3}, "brown");
    const auto base = world.addBox({94, 90, 0}, {102, 94, 3}, "red");
    const auto right = world.addBox({102, 90, 0}, {106, 100, 3}, "blue");
    world.link(left, rectangle({94, 91, 0}, {94, 93, 2.2}), base);
    world.link(base, rectangle({102, 91, 0}, {102, 93, 2.2}), right);
    const auto w1 = world.openOutside(left, rectangle({94, 96, 0.5}, {94, 98, 2.5}));
    const auto w2 = world.openOutside(right, rectangle({102, 96, 0.5}, {102, 98, 2.5}));
    const auto w3 = world.openOutside(right, rectangle({106, 96, 0.5}, {106, 98, 2.5}));
    Walls shape = boxExterior({90, 90, 0}, {94, 100, 3});
    for (const Walls& part :
         {boxExterior({94, 90, 0}, {102, 94, 3}), boxExterior({102, 90, 0}, {106, 100, 3})})
        shape.insert(shape.end(), part.begin(), part.end());
    world.addBuilding(shape, {w1, w2, w3});
    PictureWorld pictures(world, options());
    const Picture picture =
        pictures.expectClean(pictures.look({91, 97, 1.5}, 90, 0, pictures.space(world.id(left))));
    const auto& all = picture.visible.visits;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const auto& v) { return v.depth == 3; }))
        << "wing, yard, wing, outside";
    for (double yaw = 60; yaw <= 180; yaw += 15) {
        SCOPED_TRACE(yaw);
        pictures.expectClean(pictures.look({91, 97, 1.5}, yaw, 0, pictures.space(world.id(left))));
    }
}

TEST_P(Cases, case29_aCorridorThatWrapsBehindARoomAndOverlapsIt) {
    TestWorld world;
    const auto room = world.addBox({0, 0, 0}, {6, 6, 3}, "brown");
    const auto first = world.addBox({6, 0, 0}, {8, 8, 3}, "blue");
    const auto second =
        world.addBox({-2, 4, 0}, {8, 8, 3}, "green"); // runs through the room's northern third
    world.link(room, rectangle({6, 1, 0}, {6, 2, 2}), first);
    world.link(first, rectangle({6.5, 8, 0}, {7.5, 8, 2}), world.addBox({6, 8, 0}, {8, 12, 3}, "red"));
    world.link(second, rectangle({-2, 5, 0}, {-2, 6, 2}), world.addBox({-6, 4, 0}, {-2, 8, 3}, "pink"));
    world.link(room, rectangle({0, 4.5, 0}, {0, 5.5, 2}), world.addBox({-4, 2, 0}, {0, 7, 3}, "grey"));
    PictureWorld pictures(world, options());
    for (double yaw = 0; yaw < 360; yaw += 30) {
        SCOPED_TRACE(yaw);
        pictures.expectClean(pictures.look({3, 3, 1.5}, yaw, 0, pictures.space(world.id(room))));
        pictures.expectClean(pictures.look({3, 5, 1.5}, yaw, 0, pictures.space(world.id(second))));
        pictures.expectClean(pictures.look({7, 5, 1.5}, yaw, 0, pictures.space(world.id(first))));
    }
}

TEST_P(Cases, case29_aShelfThatPokesThroughAFacade) {
    TwoHouses houses;
    const std::uint32_t shelf =
        houses.world.addModel(insideOut(boxWalls({-0.5, -0.3, 0}, {0.5, 0.3, 0.4}, "pink")));
    houses.world.addStatic(houses.south, shelf, frameAt({94.9, 86, 1.2})); // half outside the northern wall
    PictureWorld pictures(houses.world, options());
    const Picture outside = pictures.expectClean(pictures.look({94, 90, 1.5}, 180, 0, world::kOutside));
    const Picture inside = pictures.expectClean(
        pictures.look({94, 82, 1.5}, 0, 0, pictures.space(houses.world.id(houses.south))));
    const auto shelfPixels = [&](const Picture& picture) {
        return std::count_if(picture.ids.begin(), picture.ids.end(), [&](std::uint32_t id) {
            const auto i = instanceOfId(pictures.world(), id);
            return i != world::kNone && pictures.world().instances[i].kind == world::InstanceKind::Static;
        });
    };
    EXPECT_GT(shelfPixels(inside), 10);
    EXPECT_EQ(shelfPixels(outside), 0);
}

} // namespace
} // namespace limen::test
