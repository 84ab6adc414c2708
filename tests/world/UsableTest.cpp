#include "support/Effects.h"
#include "support/PlacedHut.h"
#include "world/LeafPose.h"
#include "world/Solids.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

// Things of a world database that open when they are used: chests and levers.
namespace limen::world {
namespace {

using test::PlacedHut;

constexpr std::uint64_t kChest = 7;

/// A chest in the rear room whose lid is the hut's leaf, which turns by 60 degrees.
struct ChestRoom {
    PlacedHut placed;

    ChestRoom() {
        PlacedEntry chest =
            placed.thing(kChest, placed.setup, placed.hut.source.id(placed.hut.rear), {16, 12, 2});
        chest.motionTable = placed.addTable(0x09000105, 0x03000105, 60.0);
        chest.mayOpen = true;
        placed.hut.moving.placed = {chest};
    }
    PlacedEntry& chest() { return placed.hut.moving.placed[0]; }
};

const Door* chestOf(const World& world) {
    const auto found = std::find_if(world.doors.begin(), world.doors.end(),
                                    [](const Door& door) { return door.portal == kNone; });
    return found != world.doors.end() ? &*found : nullptr;
}

TEST(Usable, aChestOpensAsItsMotionTableSays) {
    ChestRoom room;
    room.chest().isLocked = true;
    room.chest().scale = 0.5;
    const World world = room.placed.hut.load();
    const Door* chest = chestOf(world);
    ASSERT_NE(chest, nullptr);
    EXPECT_EQ(chest->name, "thing 7");
    EXPECT_EQ(world.spaces[chest->space].cellId, room.placed.hut.source.id(room.placed.hut.rear));
    EXPECT_FALSE(chest->opaque) << "it shuts no opening";
    EXPECT_TRUE(chest->locked);
    EXPECT_EQ(chest->open, 0.0);
    EXPECT_EQ(chest->filling, kNone);
    EXPECT_NEAR(chest->seconds, 1.0, 1e-6) << "30 frames at 30 a second";
    ASSERT_EQ(chest->leafCount, 1u);
    const Leaf& lid = world.leaves[chest->firstLeaf];
    EXPECT_EQ(lid.scale, Vec3(0.5));
    for (const double open : {0.0, 0.5, 1.0}) {
        const LeafPose pose = leafPose(world, lid, open);
        const double angle = -60.0 * open * std::numbers::pi / 180.0; // clockwise seen from above
        EXPECT_NEAR(glm::length(pose.turn[0] - Vec3(std::cos(angle), std::sin(angle), 0.0)), 0.0, 1e-4)
            << open;
        EXPECT_NEAR(glm::length(pose.origin - room.placed.hut.at({16, 12, 2})), 0.0, 1e-6);
    }
    EXPECT_TRUE(std::none_of(world.instances.begin(), world.instances.end(), [&](const Instance& i) {
        return i.object == world.placed[0].object;
    })) << "it is drawn by its leaves";
    EXPECT_EQ(world.movingParts[lid.body.firstPart].kind, InstanceKind::Static);
    EXPECT_EQ(world.movingParts[lid.body.firstPart].object, world.placed[0].object) << "for picking";
}

TEST(Usable, aChestMayStandOpen) {
    ChestRoom room;
    room.chest().isOpen = true;
    const World world = room.placed.hut.load();
    ASSERT_NE(chestOf(world), nullptr);
    EXPECT_EQ(chestOf(world)->open, 1.0);
}

TEST(Usable, otherThingsStayThings) {
    const auto opens = [](auto&& change) {
        ChestRoom room;
        change(room);
        const World world = room.placed.hut.load();
        EXPECT_EQ(world.placed.size(), 1u);
        return chestOf(world) != nullptr;
    };
    EXPECT_TRUE(opens([](ChestRoom&) {}));
    EXPECT_FALSE(opens([](ChestRoom& room) { room.chest().mayOpen = false; })) << "a person";
    EXPECT_FALSE(opens([](ChestRoom& room) { room.chest().motionTable = 0; }));
    EXPECT_FALSE(opens([](ChestRoom& room) { room.chest().opacity = 0.5; }));
    EXPECT_FALSE(opens([](ChestRoom& room) {
        room.chest().motionTable = room.placed.addTable(0x09000106, 0x03000106, 0.0);
    })) << "open and shut look the same";
    EXPECT_FALSE(opens([](ChestRoom& room) {
        dat::MotionTable table;
        table.id = 0x09000107;
        table.defaultStyle = test::kPuppetStyle;
        table.styleDefaults = {{test::kPuppetStyle, test::kSubstateOff}};
        dat::MotionData all, last;
        all.animations = {{0x03000105, 0, -1, 30.0f}};
        last.animations = {{0x03000105, 30, 30, 30.0f}};
        table.cycles = {{dat::motionKey(test::kPuppetStyle, test::kSubstateOff), all},
                        {dat::motionKey(test::kPuppetStyle, test::kSubstateOn), last}};
        room.placed.hut.source.portalFile().add(table);
        room.chest().motionTable = 0x09000107;
    })) << "it moves while it is shut";
}

TEST(Usable, aChestStopsBodiesAsItStands) {
    ChestRoom room;
    const test::TempDir directory;
    ASSERT_TRUE(room.placed.hut.source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    const Result<World> world =
        loadWorld(*archive, room.placed.hut.source.home(), {}, room.placed.hut.moving);
    ASSERT_TRUE(world);
    const Result<Solids> solids = loadSolids(*archive, *world, room.placed.hut.source.home(), 1);
    ASSERT_TRUE(solids);
    const auto isAtTheChest = [&](const Solid& solid) {
        const Vec3 corner = solids->origin + solids->corners[3 * solid.firstTriangle];
        return glm::length(corner - room.placed.hut.at({16, 12, 2})) < 2.5 &&
               (solid.kind == InstanceKind::Static || solid.leaf != kNone) && solid.door != 2; // the pane
    };
    std::vector<Solid> found;
    std::copy_if(solids->solids.begin(), solids->solids.end(), std::back_inserter(found), isAtTheChest);
    for (const Solid& solid : found)
        EXPECT_NE(solid.door, static_cast<std::uint32_t>(chestOf(*world) - world->doors.data()))
            << "no leaf pushes bodies";
}

TEST(Usable, aThingPlaysTheScriptOfItsEffectTable) {
    test::EffectsHut effects;
    const std::uint32_t script = effects.addScript(
        {{0.0, test::EffectsHut::create(effects.add(test::EffectsHut::emitter(effects.spark)))}});
    dat::PhysicsScriptTable table;
    table.id = 0x34000009;
    constexpr std::uint32_t kKind = 12;
    table.scripts = {{kKind, {{0.5f, script}}}};
    effects.hut.source.portalFile().add(table);
    PlacedEntry thing;
    thing.id = 9;
    thing.name = "portal";
    thing.model = effects.addScripted(0);
    thing.block = effects.hut.source.home();
    thing.position = effects.hut.at({30, 30, 2});
    const auto sourcesOf = [&](dat::RecordId tableId, PlayEntry play) {
        thing.scriptTable = tableId;
        thing.play = play;
        effects.hut.moving.placed = {thing};
        return effects.hut.load().particleSources.size();
    };
    const std::size_t others = sourcesOf(0, {});
    EXPECT_EQ(sourcesOf(table.id, {kKind, 0.25}), others + 1);
    EXPECT_EQ(sourcesOf(table.id, {kKind + 1, 0.25}), others) << "the table has no such kind";
    EXPECT_EQ(sourcesOf(table.id, {}), others) << "a table alone plays nothing";
    EXPECT_EQ(sourcesOf(0, {kKind, 0.25}), others) << "the Setup has no table";
}

} // namespace
} // namespace limen::world
