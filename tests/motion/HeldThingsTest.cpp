#include "motion/DoorUse.h"
#include "motion/DynamicStateBuilder.h"
#include "support/PlacedHut.h"
#include "world/LeafPose.h"

#include <gtest/gtest.h>
#include <numbers>

// Things in the hands of placed objects: where they are while the holder stands and moves, and parts of things that open.
namespace limen::motion {
namespace {

using test::PlacedHut;
using world::kOutside;

constexpr std::uint32_t kRightHand = 1, kInRightHand = 1;

/// A person whose hand is part 0 of its Setup, with an axe of one part: the handle's middle is 0.1 m above its origin in the
/// placement for the right hand.
struct Axeman {
    PlacedHut placed;
    std::uint32_t blade =
        placed.hut.source.addModel(test::boxExterior({-0.1, -0.1, 0}, {0.1, 0.1, 1}, "steel"));
    std::uint32_t person = 0, axe = 0;

    Axeman() {
        dat::Setup holder;
        holder.parts = {placed.hut.leaf};
        holder.holdingLocations = {{static_cast<std::int32_t>(kRightHand), 0, test::frameAt({0, 1, 1.5})}};
        person = placed.hut.source.addSetup(holder);
        dat::Setup item;
        item.parts = {blade};
        dat::AnimationFrame rest, inHand;
        rest.parts = {test::frameAt({5, 5, 5})};
        inHand.parts = {test::frameAt({0, 0, 0.1})};
        item.placementFrames = {{dat::Setup::kPlacementDefault, rest}, {kInRightHand, inHand}};
        axe = placed.hut.source.addSetup(item);
        world::PlacedEntry entry = placed.thing(7, person, 0, {30, 30, 2});
        entry.held = {{axe, kRightHand, kInRightHand, 1.0, {}, 0, {}}};
        placed.hut.moving.placed = {entry};
    }
    world::PlacedEntry& entry() { return placed.hut.moving.placed[0]; }

    /// Plays all frames of a turn by `swing` degrees while the person stands.
    void turnAllTheTime(double swing) {
        (void)placed.addTable(0x09000110, 0x03000110, swing);
        dat::MotionTable table;
        table.id = 0x09000111;
        table.defaultStyle = test::kPuppetStyle;
        table.styleDefaults = {{test::kPuppetStyle, test::kPuppetStands}};
        dat::MotionData all;
        all.animations = {{0x03000110, 0, -1, 30.0f}};
        table.cycles = {{dat::motionKey(test::kPuppetStyle, test::kPuppetStands), all}};
        placed.hut.source.portalFile().add(table);
        entry().motionTable = table.id;
    }
};

/// The blade in the static or the dynamic instances.
struct Found {
    Vec3 origin{0.0}; ///< global
    Mat3 linear{1.0};
};
std::optional<Found> findBlade(const world::World& world, std::span<const world::Instance> instances,
                               std::uint32_t blade) {
    for (const world::Instance& each : instances)
        if (each.record == blade)
            return Found{world.blocks[each.block].origin() + Vec3(each.origin), Mat3(each.linear)};
    return std::nullopt;
}

void expectAt(const std::optional<Found>& found, const Vec3& origin) {
    ASSERT_TRUE(found);
    EXPECT_NEAR(glm::length(found->origin - origin), 0.0, 1e-4)
        << found->origin.x << ' ' << found->origin.y << ' ' << found->origin.z;
}

TEST(HeldThings, areInTheHandOfAHolderThatStands) {
    Axeman f;
    f.entry().orientation = glm::angleAxis(std::numbers::pi / 2.0, Vec3(0, 0, 1)); // +y becomes -x
    const world::World world = f.placed.hut.load();
    expectAt(findBlade(world, world.instances, f.blade), f.placed.hut.at({29, 30, 3.6}));
    EXPECT_EQ(world.instances.back().object, world.placed[0].object) << "picking finds the holder";
}

TEST(HeldThings, haveTheirOwnSize) {
    Axeman f;
    f.entry().scale = 2.0;
    f.entry().held[0].scale = 0.5;
    const world::World world = f.placed.hut.load();
    const std::optional<Found> blade = findBlade(world, world.instances, f.blade);
    // The hand is where the holder's part is; from there on nothing follows the holder's scale.
    expectAt(blade, f.placed.hut.at({30, 31, 3.55}));
    EXPECT_NEAR(glm::length(blade->linear[0]), 0.5, 1e-6);
}

TEST(HeldThings, followTheHandThroughItsAnimation) {
    Axeman f;
    f.turnAllTheTime(90.0);
    const world::World world = f.placed.hut.load();
    ASSERT_EQ(world.idleObjects.size(), 1u);
    DynamicStateBuilder builder(world);
    world::DynamicState state;
    for (const int frame : {0, 10, 20}) {
        DynamicStateInput input;
        input.seconds = (frame + 1e-6) / 30.0;
        input.eye = f.placed.hut.at({30, 25, 4});
        builder.build(input, state);
        const double angle = -90.0 * frame / 30.0 * std::numbers::pi / 180.0;
        expectAt(findBlade(world, state.instances, f.blade),
                 f.placed.hut.at({30 - std::sin(angle), 30 + std::cos(angle), 3.6}));
    }
    const Sphere& bounds = world.idleObjects[0].body.bounds;
    for (int frame = 0; frame <= 30; ++frame) { // the tip of the blade
        const double angle = -90.0 * frame / 30.0 * std::numbers::pi / 180.0;
        const Vec3 tip(-std::sin(angle), std::cos(angle), 2.6);
        EXPECT_LE(glm::length(tip - bounds.centre), bounds.radius);
    }
}

TEST(HeldThings, withoutAPlaceAreLeftOut) {
    Axeman f;
    f.entry().held[0].location = 9; // the Setup has no such holding location
    EXPECT_FALSE(findBlade(f.placed.hut.load(), f.placed.hut.load().instances, f.blade));
    Axeman g;
    g.entry().held[0].model = 0x02007777;
    EXPECT_EQ(g.placed.hut.load().placed.size(), 1u);
}

TEST(HeldThings, withoutTheirPlacementTakeTheDefaultOne) {
    Axeman f;
    f.entry().held[0].placement = 6;
    const world::World world = f.placed.hut.load();
    expectAt(findBlade(world, world.instances, f.blade), f.placed.hut.at({35, 36, 8.5}));
}

/// A chest in the rear room: a thing whose lid is the leaf, which turns by 90 degrees.
struct ChestRoom {
    PlacedHut placed;
    ChestRoom() {
        world::PlacedEntry chest =
            placed.thing(7, placed.setup, placed.hut.source.id(placed.hut.rear), {16, 12, 2});
        chest.motionTable = placed.addTable(0x09000105, 0x03000105, 90.0);
        chest.mayOpen = true;
        placed.hut.moving.placed = {chest};
        placed.hut.moving.doors.clear();
    }
};

TEST(ThingsThatOpen, areDrawnInTheirSpaceAtEveryOpenness) {
    ChestRoom room;
    const world::World world = room.placed.hut.load();
    ASSERT_EQ(world.doors.size(), 1u);
    DynamicStateBuilder builder(world);
    world::DynamicState state;
    const world::SpaceIndex rear = world::findCell(world, room.placed.hut.source.id(room.placed.hut.rear));
    for (const double open : {0.0, 0.5, 1.0}) {
        DynamicStateInput input;
        const double doors[] = {open};
        input.doors = doors;
        input.eye = room.placed.hut.at({15, 12, 3.7});
        builder.build(input, state);
        EXPECT_TRUE(std::none_of(state.closed.begin(), state.closed.end(), [](auto c) { return c != 0; }));
        const auto lid = std::find_if(state.instances.begin(), state.instances.end(),
                                      [&](const auto& i) { return i.record == room.placed.hut.leaf; });
        ASSERT_NE(lid, state.instances.end());
        EXPECT_EQ(state.members[lid->firstMember], rear);
        EXPECT_NEAR(static_cast<double>(lid->linear[0].x), std::cos(open * std::numbers::pi / 2.0), 1e-4);
    }
}

TEST(ThingsThatOpen, areUsedLikeDoors_fromTheirOwnSpace) {
    ChestRoom room;
    const world::World world = room.placed.hut.load();
    const world::SpaceIndex rear = world::findCell(world, room.placed.hut.source.id(room.placed.hut.rear)),
                            front = world::findCell(world, room.placed.hut.source.id(room.placed.hut.front));
    const Vec3 eye = room.placed.hut.at({15, 12, 3.7});
    const Vec3 towards = glm::normalize(Vec3(1.0, 0.4, -0.7));
    EXPECT_EQ(doorInReach(world, rear, eye, towards), 0u);
    EXPECT_EQ(doorInReach(world, rear, eye, -towards), std::nullopt) << "it is behind";
    EXPECT_EQ(doorInReach(world, front, eye, towards), std::nullopt) << "in another room";
    EXPECT_EQ(doorInReach(world, rear, room.placed.hut.at({12, 12, 3.7}), towards), std::nullopt)
        << "too far";
    DoorUse use;
    EXPECT_TRUE(use.use(world.doors[0]));
    use.pass(0.5);
    std::vector<double> open;
    use.write(world, open);
    EXPECT_EQ(open, std::vector{0.5});
}

TEST(LockedDoors, stayShutWhenTheyAreUsed_butCanBeShut) {
    ChestRoom room;
    room.placed.hut.moving.placed[0].isLocked = true;
    world::World world = room.placed.hut.load();
    DoorUse use;
    std::vector<double> open;
    EXPECT_FALSE(use.use(world.doors[0]));
    use.pass(5.0);
    use.write(world, open);
    EXPECT_EQ(open, std::vector{0.0});
    use.put(world.doors[0], 0.75); // someone with a key
    EXPECT_TRUE(use.use(world.doors[0])) << "an open door shuts";
    use.pass(5.0);
    use.write(world, open);
    EXPECT_EQ(open, std::vector{0.0});
    EXPECT_FALSE(use.use(world.doors[0])) << "and is locked again";
}

} // namespace
} // namespace limen::motion
