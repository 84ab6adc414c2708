#include "support/MovingHut.h"
#include "world/Places.h"

#include <fstream>
#include <gmock/gmock.h>

namespace limen::world {
namespace {

using testing::HasSubstr;

Result<WorldFile> load(const std::string& text) {
    const test::TempDir directory;
    std::ofstream(directory.path() / "world.json") << text;
    return loadWorldFile(directory.path());
}

TEST(MovingEntries, areReadAsTheyStand) {
    const auto file = load(R"({
        "doors": [{"name": "gate", "cell": "0xA9B40105", "portal": 2, "opaque": false, "open": 0.25,
                   "leaves": [{"model": "0x02000123", "position": [1, 2, 3], "yaw": 90, "swing": -95}]}],
        "routes": [{"name": "lane", "loop": true, "points": [{"position": [1, 2, 3], "cell": "outside"},
                                                             {"position": [4, 5, 6], "cell": "0xA9B40105"}]}],
        "villagers": [{"name": "baker", "model": "0x02000200", "route": "lane", "speed": 1.3, "start": 7,
                       "clothing": [{"table": "0x10000001"}, {"table": "0x10000002", "palette": 3, "shade": 0.75}],
                       "play": {"kind": 12, "intensity": 0.5}}],
        "player": {"model": "0x02000300", "clothing": [{"table": "0x10000003"}]},
        "emitters": [{"name": "fire", "surface": "0x08000040", "position": [7, 8, 9], "cell": "0xA9B40105",
                      "rate": 6, "life": 4, "velocity": [0, 0, 0.8], "spread": 0.15, "acceleration": [0.1, 0, 0],
                      "radius": 0.1, "size": [0.3, 1.2], "alpha": [0.6, 0], "seed": 5}],
        "weather": "rain"})");
    ASSERT_TRUE(file) << file.error().message();
    const MovingEntries& moving = file->moving;
    ASSERT_EQ(moving.doors.size(), 1u);
    EXPECT_EQ(moving.doors[0].cell, 0xA9B40105u);
    EXPECT_EQ(moving.doors[0].portal, 2u);
    EXPECT_FALSE(moving.doors[0].opaque);
    EXPECT_EQ(moving.doors[0].open, 0.25);
    ASSERT_EQ(moving.doors[0].leaves.size(), 1u);
    EXPECT_EQ(moving.doors[0].leaves[0].model, 0x02000123u);
    EXPECT_EQ(moving.doors[0].leaves[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(moving.doors[0].leaves[0].swing, -95.0);
    ASSERT_EQ(moving.routes.size(), 1u);
    EXPECT_TRUE(moving.routes[0].loop);
    EXPECT_EQ(moving.routes[0].points[0].cell, 0u);
    EXPECT_EQ(moving.routes[0].points[1].cell, 0xA9B40105u);
    ASSERT_EQ(moving.villagers.size(), 1u);
    EXPECT_EQ(moving.villagers[0].route, "lane");
    EXPECT_EQ(moving.villagers[0].start, 7.0);
    ASSERT_EQ(moving.villagers[0].clothing.size(), 2u);
    EXPECT_EQ(moving.villagers[0].clothing[0].palette, 0u);
    EXPECT_EQ(moving.villagers[0].clothing[1].table, 0x10000002u);
    EXPECT_EQ(moving.villagers[0].clothing[1].palette, 3u);
    EXPECT_EQ(moving.villagers[0].clothing[1].shades, std::vector{0.75});
    EXPECT_EQ(moving.villagers[0].play.kind, 12u);
    EXPECT_EQ(moving.villagers[0].play.intensity, 0.5);
    EXPECT_EQ(moving.player, 0x02000300u);
    ASSERT_EQ(moving.playerClothing.size(), 1u);
    EXPECT_EQ(moving.playerClothing[0].table, 0x10000003u);
    ASSERT_EQ(moving.emitters.size(), 1u);
    EXPECT_EQ(moving.emitters[0].velocity, Vec3(0, 0, 0.8));
    EXPECT_EQ(moving.emitters[0].alpha[1], 0.0);
    EXPECT_EQ(moving.emitters[0].seed, 5u);
    EXPECT_TRUE(moving.rain);
}

TEST(MovingEntries, refuseOtherShapesWithASentence) {
    for (const char* text :
         {R"({"doors": {}})", R"({"doors": [7]})", R"({"doors": [{"name": "x"}]})",
          R"({"doors": [{"cell": "0x1", "open": 2}]})", R"({"doors": [{"cell": "0x1", "leaves": [{}]}]})",
          R"({"doors": [{"cell": "0x1", "portal": -1}]})", R"({"routes": [{"points": []}]})",
          R"({"routes": [{"points": [{"position": [1]}, {"position": [1, 2, 3]}]}]})",
          R"({"villagers": [{"route": "x"}]})", R"({"emitters": [{"surface": "0x08000001", "life": 0}]})",
          R"({"emitters": [{"surface": "0x08000001", "rate": 1e999}]})", R"({"weather": "snow"})",
          R"({"villagers": [{"model": "0x02000001", "clothing": [{}]}]})",
          R"({"villagers": [{"model": "0x02000001", "clothing": 3}]})",
          R"({"villagers": [{"model": "0x02000001", "play": {"kind": 0}}]})",
          R"({"villagers": [{"model": "0x02000001", "play": []}]})",
          R"({"player": {"model": "0x02000001", "clothing": [{"table": "0x10000001", "shade": "dark"}]}})"}) {
        const auto file = load(text);
        ASSERT_FALSE(file) << text;
        EXPECT_EQ(file.error().code, ErrorCode::Malformed);
        EXPECT_THAT(file.error().where, HasSubstr("world.json"));
    }
}

TEST(Moving, doorsFindTheirOpeningsAndTheirFillingsFaceBothWays) {
    test::MovingHut hut;
    const World world = hut.load();
    ASSERT_EQ(world.doors.size(), 3u) << test::findingsOf(world);
    const Door& front = world.doors[0];
    EXPECT_EQ(world.portals[front.portal].space, findCell(world, hut.source.id(hut.front)));
    EXPECT_EQ(world.portals[front.portal].destination, kOutside);
    EXPECT_EQ(world.portals[front.reciprocal].space, kOutside);
    ASSERT_NE(front.filling, kNone);
    const Mesh& mesh = world.meshes[world.movingParts[front.filling].mesh];
    EXPECT_EQ(mesh.polygonCount, 2u);
    EXPECT_EQ(mesh.ranges[0].indexCount, 12u) << "two triangles, both sides";
    for (std::uint32_t i = 0; i < mesh.vertexCount; ++i)
        EXPECT_EQ(world.vertices[mesh.firstVertex + i].position.x, 10.0f);
    EXPECT_EQ(world.doors[2].filling, kNone) << "a pane has no filling";
}

TEST(Moving, idsOfMovingPartsCollideWithNoneOfTheStaticOnes) {
    test::MovingHut hut;
    const World world = hut.load();
    ASSERT_FALSE(world.movingParts.empty());
    std::uint32_t end = 2;
    for (const auto* instances : {&world.instances, &world.movingParts}) {
        for (const Instance& instance : *instances) {
            EXPECT_GE(instance.idBase, end);
            end = instance.idBase + world.meshes[instance.mesh].polygonCount;
        }
    }
    EXPECT_EQ(world.spriteIds, end);
    EXPECT_EQ(world.idEnd, end + kMostSprites);
}

TEST(Moving, staticsThatADoorCutsOffAreLooseAndInNoStaticList) {
    test::MovingHut hut;
    const World world = hut.load();
    ASSERT_EQ(world.looseObjects.size(), 1u);
    const InstanceIndex table = world.looseObjects[0].firstInstance;
    EXPECT_EQ(world.instances[table].record, hut.table);
    EXPECT_THAT(world.spaceInstances, testing::Not(testing::Contains(table)));
    hut.moving.doors.clear();
    EXPECT_TRUE(hut.load().looseObjects.empty());
}

TEST(Moving, entriesThatReferToNothingAreReportedOrLeftOut) {
    test::MovingHut hut;
    hut.moving.doors[0].portal = 77;
    hut.moving.doors[1].cell = 0x01020100; // not loaded: left out
    hut.moving.villagers[0].route = "nowhere";
    const World world = hut.load();
    EXPECT_EQ(world.doors.size(), 1u);
    EXPECT_TRUE(world.villagers.empty());
    EXPECT_EQ(world.emitters.size(), 1u) << "the villager's lantern is left out with him";
    EXPECT_THAT(test::findingsOf(world), HasSubstr("door \"front\" names a portal"));
    EXPECT_THAT(test::findingsOf(world), HasSubstr("villager \"anna\" walks a route"));
}

} // namespace
} // namespace limen::world
