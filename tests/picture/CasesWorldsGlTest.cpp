// Hard cases 20, 22 and 26 of docs/cases.md: equal low ids, sealed dungeons, lamps.
#include "picture/CaseHelp.h"

#include "motion/Locate.h"

#include <cmath>
#include <map>

namespace limen::test {
namespace {

struct CasesWorlds : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesWorlds);

TEST_P(CasesWorlds, case20_equalLowIdsInTwoLandblocksShareNothing) {
    // Two adjacent landblocks, each with a first cell, a first building and a first object of the same low
    // ids, with different shapes and colours.
    TestWorld world;
    const dat::BlockCoord home = world.home(), north{home.x, home.y + 1};
    world.setFlatTerrain(home, 0);
    world.setFlatTerrain(north, 0);
    const auto house = [&](dat::BlockCoord block, const Vec3& min, const Vec3& max, const char* colour,
                           double door) {
        TestWorld::CellOptions cell;
        cell.block = block;
        const auto room = world.addBox(min, max, colour, cell);
        const auto exit =
            world.openOutside(room, rectangle({min.x + 1, door, 0.1}, {max.x - 1, door, max.z - 0.4}));
        TestWorld::BuildingOptions building;
        building.block = block;
        world.addBuilding(boxExterior(min, max, std::string(colour) + " wall"), {exit}, building);
        return room;
    };
    const auto a = house(home, {92, 180, 0}, {96, 184, 3}, "brown", 180);
    const auto b = house(north, {97, 2, 0}, {104, 8, 4}, "blue", 2);
    const std::uint32_t stool = world.addModel(boxExterior({-0.3, -0.3, 0}, {0.3, 0.3, 0.5}, "oak"));
    const std::uint32_t pole = world.addModel(boxExterior({-0.1, -0.1, 0}, {0.1, 0.1, 2.4}, "pink"));
    world.addStatic(a, stool, frameAt({94, 182, 0}));
    world.addStatic(b, pole, frameAt({100, 5, 0}));
    world.addObject(home, stool, frameAt({91, 178, 0}));
    world.addObject(north, pole, frameAt({98.6, 0.5, 0}));
    world.addObject(north, stool, frameAt({96, 1, 0})); // the same model in both: its mesh may be shared
    ASSERT_EQ(world.id(a) & 0xFFFF, world.id(b) & 0xFFFF);
    PictureWorld pictures(world, options());

    std::map<std::uint64_t, int> byObject;
    std::map<std::uint64_t, std::pair<dat::RecordId, std::uint32_t>> byKey;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ids;
    for (const world::Instance& in : pictures.world().instances) {
        const world::Mesh& mesh = pictures.world().meshes[in.mesh];
        ids.emplace_back(in.idBase, in.idBase + mesh.polygonCount);
        ++byObject[in.object];
        const auto [known, isNew] = byKey.emplace(mesh.contentKey, std::pair{in.record, in.mesh});
        if (!isNew && in.kind != world::InstanceKind::Terrain) {
            EXPECT_EQ(known->second.second, in.mesh) << "one key, one mesh";
            EXPECT_EQ(known->second.first, in.record) << "one mesh, one record";
        }
    }
    EXPECT_EQ(byObject.size(), pictures.world().instances.size()) << "every object here has one part";
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 1; i < ids.size(); ++i)
        EXPECT_LE(ids[i - 1].second, ids[i].first) << "ids are not shared";
    pictures.fov = 25;
    const Picture both = pictures.expectClean(pictures.look({97, 165, 2}, 2, 0, world::kOutside));
    pictures.fov = 75;
    for (const dat::RecordId record : {world.id(a), world.id(b), dat::RecordId{stool}, dat::RecordId{pole}})
        EXPECT_GT(pixelsOfRecord(pictures, both, record), 3u) << std::hex << record;
    pictures.expectClean(pictures.look({94, 183, 1.6}, 200, 0, pictures.space(world.id(a))));
    pictures.expectClean(pictures.look({101, 199, 1.6}, 200, 0, pictures.space(world.id(b))));
}

/// A dungeon of four rooms in a ring in a block of its own, surrounded by blocks with landscape and a house.
struct Dungeon {
    TestWorld world;
    std::vector<TestWorld::Cell> rooms;
    Dungeon() {
        const auto hall = [&](double x, double y, const char* colour) {
            rooms.push_back(world.addBox({x, y, -12}, {x + 6, y + 6, -8}, colour));
            return rooms.back();
        };
        const auto a = hall(20, 20, "brown"), b = hall(26, 20, "blue"), c = hall(26, 26, "red"),
                   d = hall(20, 26, "green");
        world.link(a, rectangle({26, 22, -12}, {26, 24, -9.5}), b);
        world.link(b, rectangle({28, 26, -12}, {30, 26, -9.5}), c);
        world.link(c, rectangle({26, 28, -12}, {26, 30, -9.5}), d);
        world.link(d, rectangle({22, 26, -12}, {24, 26, -9.5}), a);
        (void)world.terrain(world.home()); // all heights are 0 and there is no building: a pure dungeon
        const dat::BlockCoord east{world.home().x + 1, world.home().y};
        world.setFlatTerrain(east, 3);
        TestWorld::CellOptions cell;
        cell.block = east;
        const auto room = world.addBox({2, 20, 6}, {8, 26, 9}, "pink", cell);
        const auto exit = world.openOutside(room, rectangle({4, 20, 6}, {5, 20, 8}));
        TestWorld::BuildingOptions building;
        building.block = east;
        world.addBuilding(boxExterior({2, 20, 6}, {8, 26, 9}), {exit}, building);
    }
};

TEST_P(CasesWorlds, case22_aSealedDungeonIsAloneAndDoesNoLandscapeWork) {
    Dungeon dungeon;
    PictureWorld pictures(dungeon.world, options({}, 2));
    const world::World& loaded = pictures.world();
    EXPECT_EQ(loaded.blocks.size(), 1u) << "no neighbour is resident";
    EXPECT_EQ(loaded.spaces.size(), 1 + dungeon.rooms.size());
    EXPECT_TRUE(std::none_of(loaded.instances.begin(), loaded.instances.end(), [](const world::Instance& in) {
        return in.kind == world::InstanceKind::Terrain || in.kind == world::InstanceKind::Exterior ||
               in.kind == world::InstanceKind::Scenery;
    }));
    EXPECT_TRUE(loaded.terrainCells.empty());
    for (std::size_t i = 0; i < dungeon.rooms.size(); ++i) {
        const Vec3 eye(i == 0 || i == 3 ? 23 : 29, i < 2 ? 23 : 29, -10.4);
        for (double yaw = 0; yaw < 360; yaw += 45) {
            SCOPED_TRACE(::testing::Message() << "room " << i << " yaw " << yaw);
            const Picture picture = pictures.expectClean(
                pictures.look(eye, yaw, 10, pictures.space(dungeon.world.id(dungeon.rooms[i]))));
            EXPECT_FALSE(visitsSpace(picture, world::kOutside));
            EXPECT_FALSE(seesSpace(picture, world::kOutside));
            EXPECT_EQ(picture.stages[static_cast<std::size_t>(frame::StageKind::Sky)], 0u) << "no sky";
            EXPECT_EQ(skyPixels(picture), 0u);
            visibility::VisibleSet set;
            frame::FramePlan plan;
            pictures.plan(picture.frame, set, plan);
            for (const frame::Batch& batch : plan.batches)
                EXPECT_TRUE(batch.program != frame::Program::Terrain || batch.draws == 0) << "no terrain";
        }
    }
}

/// A house with a window, a red lamp beside it outdoors, and a blue one inside.
struct LitHouse {
    TestWorld world;
    TestWorld::Cell room, closet;
    LitHouse() {
        world.setFlatTerrain(world.home(), 1);
        TestWorld::CellOptions seesOut;
        seesOut.seenOutside = true;
        room = world.addBox({90, 90, 2}, {96, 96, 5}, "grey", seesOut);
        closet = world.addBox({96, 90, 2}, {100, 96, 5}, "grey");
        world.link(room, rectangle({96, 92, 2}, {96, 94, 4.2}), closet);
        const auto window = world.openOutside(room, rectangle({91, 90, 2.5}, {95, 90, 4.5}));
        world.addBuilding(boxExterior({90, 90, 2}, {100, 96, 5}, "stone"), {window});
        const std::uint32_t stand = world.addModel(boxExterior({-0.05, -0.05, 0}, {0.05, 0.05, 0.3}, "oak"));
        world.addObject(lamp(stand, 0xFFFF4020), frameAt({97, 88.5, 3}));
        world.addStatic(room, lamp(stand, 0xFF2040FF), frameAt({93, 94.5, 3}));
        // Target of the views outside: a post before the window.
        world.addObject(world.addModel(boxExterior({-0.5, -0.5, 0}, {0.5, 0.5, 3}, "chalk")),
                        frameAt({93, 86, 2}));
    }
    std::uint32_t lamp(std::uint32_t part, std::uint32_t argb) {
        dat::Setup setup;
        setup.parts = {part};
        dat::LightInfo light;
        light.frame = frameAt({0, 0, 0.6});
        light.colour.argb = argb;
        light.intensity = 1.5f;
        light.falloff = 7.0f;
        setup.lights = {{0, light}};
        return world.addSetup(setup);
    }
};

TEST_P(CasesWorlds, case26_aSurfaceIsLitAlikeWhicheverRootItIsSeenFrom) {
    LitHouse house;
    PictureWorld pictures(house.world, options());
    pictures.width = pictures.height = 33;
    pictures.fov = 10;
    struct Seen {
        std::uint32_t id;
        glm::ivec3 colour;
    };
    const auto lookAt = [&](const Vec3& eye, const Vec3& point) {
        const Vec3 way = point - eye;
        const double yaw = std::atan2(way.x, way.y) * 57.29577951308232;
        const double pitch = std::atan2(way.z, std::hypot(way.x, way.y)) * 57.29577951308232;
        const auto root = motion::locate(pictures.world(), pictures.homeOrigin() + eye).space;
        const Picture picture = pictures.expectClean(pictures.look(eye, yaw, pitch, root));
        const std::size_t at = std::size_t{33} * 16 + 16;
        return Seen{picture.ids[at],
                    {picture.colour[at * 4], picture.colour[at * 4 + 1], picture.colour[at * 4 + 2]}};
    };
    // Points, each seen from inside, from outside through the window, and from the closet through the door.
    const Vec3 in(92.2, 91.5, 3.6), out(93.4, 87.5, 3.7), closet(97, 93.1, 3.5);
    struct Target {
        const char* name;
        Vec3 point;
        std::vector<Vec3> eyes;
    };
    const Target targets[] = {{"the room's rear wall", {92.5, 96, 3.3}, {in, out, closet}},
                              {"the room's floor", {92.0, 93.2, 2}, {in, out, closet}},
                              {"the closet's wall", {100, 93, 3.0}, {in, closet, {93.5, 92.6, 3.5}}},
                              {"the post outside", {93.1, 86.5, 3.4}, {in, {94.5, 88.5, 3.5}, {94, 91, 3.2}}},
                              {"the meadow", {95.4, 87.8, 2}, {{94.2, 91.2, 3.6}, {96.2, 86.4, 3.8}}}};
    std::vector<glm::ivec3> colours;
    for (const Target& target : targets) {
        SCOPED_TRACE(target.name);
        const Seen first = lookAt(target.eyes[0], target.point);
        ASSERT_GT(first.id, 1u);
        for (const Vec3& eye : target.eyes) {
            const Seen seen = lookAt(eye, target.point);
            EXPECT_EQ(seen.id, first.id) << "from " << eye.x << ", " << eye.y;
            for (int c = 0; c < 3; ++c) // fog and rounding of positions differ by a step or two
                EXPECT_NEAR(seen.colour[c], first.colour[c], 3) << "from " << eye.x << ", " << eye.y;
        }
        colours.push_back(first.colour);
    }
    EXPECT_GT(colours[0].z, colours[0].x + 10) << "the room's own lamp is blue";
    EXPECT_NEAR(colours[4].x, colours[4].z, 3) << "the red lamp outdoors lights nothing";
    EXPECT_NE(colours[0], colours[2]) << "the closet has a regime of its own";
}

} // namespace
} // namespace limen::test
