#include "support/PlacedHut.h"
#include "world/LeafPose.h"
#include "world/Solids.h"
#include "world/records/DoorMotion.h"
#include "world/terrain/Terrain.h"

#include <gmock/gmock.h>

// Objects of a world database in a World: doors in their openings, and things where they stand.
namespace limen::world {
namespace {

using test::PlacedHut;
using testing::HasSubstr;
using testing::Not;

const Door* findDoorAt(const World& world, dat::RecordId cell, std::uint32_t index) {
    for (const Door& door : world.doors) {
        if (door.portal == kNone)
            continue;
        const Portal& portal = world.portals[door.portal];
        if (world.spaces[portal.space].cellId == cell && portal.recordIndex == index)
            return &door;
    }
    return nullptr;
}

/// The greatest difference of two leaf poses, in metres, for points within 2 m of the leaf's origin.
double differenceOf(const LeafPose& a, const LeafPose& b) {
    double most = glm::length(a.origin - b.origin);
    for (int axis = 0; axis < 3; ++axis)
        most =
            std::max(most, glm::length(a.origin - b.origin) + 2.0 * glm::length(a.turn[axis] - b.turn[axis]));
    return most;
}

TEST(PlacedDoor, hangsInTheOpeningThatItStandsBefore) {
    PlacedHut placed;
    placed.placeDoors();
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    ASSERT_NE(front, nullptr) << test::findingsOf(world);
    EXPECT_EQ(front->name, "door 1");
    EXPECT_TRUE(front->opaque);
    EXPECT_EQ(front->open, 0.0);
    EXPECT_NE(front->filling, kNone);
    EXPECT_EQ(world.portals[front->reciprocal].space, kOutside);
    EXPECT_EQ(front->leafCount, 1u);
    const Door* inner = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.innerDoor.index);
    ASSERT_NE(inner, nullptr) << test::findingsOf(world);
    EXPECT_EQ(inner->name, "door 2");
    EXPECT_EQ(test::findingsOf(world), "");
    ASSERT_EQ(world.placed.size(), 2u);
    EXPECT_TRUE(world.placed[0].isHung);
}

TEST(PlacedDoor, turnsAsTheSameDoorOfWorldJson) {
    PlacedHut placed;
    const World before = placed.hut.load();
    placed.placeDoors();
    const World world = placed.hut.load();
    for (const Door& door : world.doors) {
        const auto same = std::find_if(before.doors.begin(), before.doors.end(),
                                       [&](const Door& other) { return other.portal == door.portal; });
        ASSERT_NE(same, before.doors.end());
        for (double open = 0.0; open <= 1.0; open += 0.0625)
            EXPECT_LT(differenceOf(leafPose(world, world.leaves[door.firstLeaf], open),
                                   leafPose(before, before.leaves[same->firstLeaf], open)),
                      1e-6)
                << door.name << " at " << open;
        // An upper bound from the distance in space, where the hinge allows that from the axis.
        const double way = leafWay(world, world.leaves[door.firstLeaf]),
                     exact = leafWay(before, before.leaves[same->firstLeaf]);
        EXPECT_GE(way, exact - 1e-6) << door.name;
        EXPECT_LE(way, exact * 1.5) << door.name;
    }
}

TEST(PlacedDoor, takesItsTimeFromTheMotionTable) {
    PlacedHut placed;
    placed.placeDoors();
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    ASSERT_NE(front, nullptr);
    EXPECT_NEAR(front->seconds, 1.0, 1e-9) << "30 frames at 30 a second";
    EXPECT_TRUE(canMove(world, world.leaves[front->firstLeaf]));
}

TEST(PlacedDoor, isMovedIntoThePlaneOfItsOpening) {
    for (const double away : {0.12, -0.12, 0.45}) {
        PlacedHut placed;
        placed.placeDoors();
        placed.hut.moving.placed[0].position.x += away;
        const World world = placed.hut.load();
        const Door* front =
            findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
        ASSERT_NE(front, nullptr) << away;
        const LeafPose pose = leafPose(world, world.leaves[front->firstLeaf], 0.0);
        EXPECT_NEAR(world.portals[front->portal].plane.signedDistance(pose.origin), 0.0, 1e-6) << away;
    }
}

TEST(PlacedDoor, mayBeTurnedByHalfATurn) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed[0].position = placed.hut.at({10, 12, 2});
    placed.hut.moving.placed[0].orientation = Quat(0.0, 0.0, 0.0, 1.0);
    const World world = placed.hut.load();
    EXPECT_NE(findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index), nullptr);
}

TEST(PlacedDoor, standsWhereItIsWithoutAnOpening) {
    const auto moved = [](const Vec3& by, const Quat& turn, double scale) {
        PlacedHut placed;
        placed.placeDoors();
        PlacedEntry& entry = placed.hut.moving.placed[0];
        entry.position += by;
        entry.orientation = turn;
        entry.scale = scale;
        const World world = placed.hut.load();
        const Door* door =
            findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
        if (door == nullptr) {
            EXPECT_THAT(test::findingsOf(world), HasSubstr("\"door 1\" stands before no opening"));
            EXPECT_FALSE(world.placed[0].isHung);
            EXPECT_EQ(std::count_if(world.instances.begin(), world.instances.end(),
                                    [&](const Instance& i) { return i.object == world.placed[0].object; }),
                      1)
                << "it is drawn";
        }
        return door != nullptr;
    };
    const Quat as(1.0, 0.0, 0.0, 0.0);
    EXPECT_TRUE(moved({0, 0, 0}, as, 1.0));
    EXPECT_TRUE(moved({-0.49, 0, 0}, as, 1.0)) << "just within half a metre";
    EXPECT_FALSE(moved({-0.51, 0, 0}, as, 1.0)) << "just beyond half a metre";
    EXPECT_FALSE(moved({0, 0.7, 0}, as, 1.0)) << "beside the opening";
    EXPECT_FALSE(moved({0, 0, 0}, glm::angleAxis(0.45, Vec3(0, 0, 1)), 1.0)) << "turned by 26 degrees";
    EXPECT_TRUE(moved({0, 0, 0}, glm::angleAxis(0.3, Vec3(0, 0, 1)), 1.0)) << "turned by 17 degrees";
    EXPECT_FALSE(moved({0, 0, 0}, as, 0.4)) << "too small for the opening";
    EXPECT_FALSE(moved({0, -3, 0}, as, 5.0)) << "much larger than the opening";
}

TEST(PlacedDoor, twoInOneOpeningAreOneDoor) {
    PlacedHut placed;
    placed.placeDoors();
    PlacedEntry& first = placed.hut.moving.placed[0];
    first.scale = 1.0;
    // Two leaves of half the width, from both sides of the opening.
    const std::uint32_t half =
        placed.hut.source.addModel(test::boxExterior({-0.03, 0, 0}, {0.03, 0.5, 2}, "wood"));
    first.model = half;
    PlacedEntry second = first;
    second.id = 3;
    second.name = "door 3";
    second.position = placed.hut.at({10, 12, 2});
    second.orientation = Quat(0.0, 0.0, 0.0, 1.0);
    placed.hut.moving.placed.push_back(second);
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    ASSERT_NE(front, nullptr) << test::findingsOf(world);
    EXPECT_EQ(front->leafCount, 2u);
    EXPECT_TRUE(front->opaque) << "together they cover the opening";
    EXPECT_EQ(world.doors.size(), 3u);
}

TEST(PlacedDoor, barsDoNotShutTheView) {
    PlacedHut placed;
    placed.placeDoors();
    test::Walls bars;
    for (int i = 0; i < 5; ++i)
        for (auto& wall : test::boxExterior({-0.03, 0.2 * i, 0}, {0.03, 0.2 * i + 0.05, 2}, "iron"))
            bars.push_back(wall);
    placed.hut.moving.placed[0].model = placed.hut.source.addModel(bars);
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    ASSERT_NE(front, nullptr) << test::findingsOf(world);
    EXPECT_FALSE(front->opaque);
    EXPECT_EQ(front->filling, kNone);
}

TEST(PlacedDoor, aLeafInThePlaneOfItsOpeningHasNoFilling) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed[0].model =
        placed.hut.source.addModel(test::boxExterior({-0.001, 0, 0}, {0.001, 1, 2}, "paper"));
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    ASSERT_NE(front, nullptr) << test::findingsOf(world);
    EXPECT_FALSE(front->opaque);
}

TEST(PlacedDoor, anOpeningOfWorldJsonKeepsItsDoor) {
    PlacedHut placed;
    placed.hut.moving.placed.push_back(placed.door(1, {10, 11, 2}, placed.clockwise));
    const World world = placed.hut.load();
    EXPECT_EQ(world.doors.size(), 3u);
    EXPECT_FALSE(world.placed[0].isHung);
}

TEST(PlacedDoor, withoutAMotionTableDoesNotMove) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed[0].motionTable = 0;
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    ASSERT_NE(front, nullptr);
    EXPECT_FALSE(canMove(world, world.leaves[front->firstLeaf]));
}

TEST(PlacedDoor, ofABlockThatIsNotLoadedIsLeftOut) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed[0].block = {0x50, 0x50};
    const World world = placed.hut.load();
    EXPECT_EQ(world.placed.size(), 1u);
    EXPECT_EQ(test::findingsOf(world), "");
}

TEST(LeafReach, holdsTheLeafAtEveryOpenness) {
    PlacedHut placed;
    placed.placeDoors();
    const World world = placed.hut.load();
    for (const Leaf& leaf : world.leaves) {
        if (leaf.model != placed.hut.leaf)
            continue; // the pane
        const Sphere reach = leafReach(world, leaf);
        Vec3 last(0.0);
        double way = 0.0;
        for (int i = 0; i <= 200; ++i) {
            const LeafPose pose = leafPose(world, leaf, i / 200.0);
            const Vec3 corner = pose.origin + pose.turn * Vec3(0.03, 1.0, 2.0);
            EXPECT_LE(glm::length(corner - reach.centre), reach.radius + 1e-9);
            way += i > 0 ? glm::length(corner - last) : 0.0;
            last = corner;
        }
        EXPECT_LE(way, leafWay(world, leaf) + 1e-9);
    }
}

TEST(PlacedDoor, isLockedByItsRow) {
    PlacedHut placed;
    placed.placeDoors();
    placed.hut.moving.placed[0].isLocked = true;
    const World world = placed.hut.load();
    EXPECT_TRUE(
        findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index)->locked);
    EXPECT_FALSE(
        findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.innerDoor.index)->locked);
}

/// The image of a door's first leaf.
const Image& imageOf(const World& world, const Door& door) {
    const Instance& leaf = world.movingParts[world.leaves[door.firstLeaf].body.firstPart];
    return *world.textures.at(world.materials[world.materialRefs[leaf.firstMaterial]].texture);
}

TEST(PlacedDoor, hasTheColoursAndThePartsOfItsRow) {
    PlacedHut placed;
    dat::Palette red, blue;
    red.id = 0x04000001;
    blue.id = 0x04000002;
    red.colours.assign(8, {0xFFFF0000u});
    blue.colours.assign(8, {0xFF0000FFu});
    placed.hut.source.portalFile().add(red);
    placed.hut.source.portalFile().add(blue);
    dat::RenderSurface image;
    image.width = image.height = 2;
    image.format = dat::PixelFormat::P8;
    image.pixels = {0, 1, 2, 3};
    image.defaultPalette = red.id;
    placed.hut.source.picture("planks", image, dat::Surface::kBase1Image);
    const std::uint32_t leaf =
        placed.hut.source.addModel(test::boxExterior({-0.03, 0, 0}, {0.03, 1, 2}, "planks"));
    placed.placeDoors();
    for (PlacedEntry& door : placed.hut.moving.placed)
        door.look.parts = {{0, leaf}}; // in place of the Setup's wooden one
    placed.hut.moving.placed[0].look.colours = {{blue.id, 0, 8}};
    const World world = placed.hut.load();
    const Door* front = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.frontDoor.index);
    const Door* inner = findDoorAt(world, placed.hut.source.id(placed.hut.front), placed.hut.innerDoor.index);
    ASSERT_TRUE(front != nullptr && inner != nullptr);
    EXPECT_EQ(world.leaves[front->firstLeaf].model, leaf);
    EXPECT_EQ(imageOf(world, *front).rgba[2], 255) << "blue";
    EXPECT_EQ(imageOf(world, *inner).rgba[0], 255) << "red";
    EXPECT_EQ(
        world.materialRefs[world.movingParts[front->filling].firstMaterial],
        world.materialRefs[world.movingParts[world.leaves[front->firstLeaf].body.firstPart].firstMaterial])
        << "the margin beside the leaf has its colours";
}

TEST(PlacedThing, standsInItsCell) {
    PlacedHut placed;
    placed.hut.moving.placed = {
        placed.thing(7, placed.hut.table, placed.hut.source.id(placed.hut.rear), {16, 12, 2})};
    placed.hut.moving.placed[0].orientation = glm::angleAxis(0.5, Vec3(0, 0, 1));
    placed.hut.moving.placed[0].scale = 0.5;
    const World world = placed.hut.load();
    ASSERT_EQ(world.placed.size(), 1u);
    const auto found = std::find_if(world.instances.begin(), world.instances.end(),
                                    [&](const Instance& i) { return i.object == world.placed[0].object; });
    ASSERT_NE(found, world.instances.end());
    EXPECT_EQ(found->kind, InstanceKind::Static);
    EXPECT_EQ(world.spaces[found->placedIn].cellId, placed.hut.source.id(placed.hut.rear));
    EXPECT_NEAR(glm::length(Vec3(found->origin) - Vec3(16, 12, 2)), 0.0, 1e-5);
    EXPECT_NEAR(glm::length(Vec3(found->linear[0])), 0.5, 1e-6);
    EXPECT_EQ(world.placed[0].name, "thing 7");
}

TEST(PlacedThing, inACellThatDoesNotExistIsAFinding) {
    PlacedHut placed;
    placed.hut.moving.placed = {
        placed.thing(7, placed.hut.table, placed.hut.source.id(placed.hut.rear) + 50, {16, 12, 2})};
    const World world = placed.hut.load();
    EXPECT_TRUE(world.placed.empty());
    EXPECT_THAT(test::findingsOf(world), HasSubstr("\"thing 7\" stands in a cell that does not exist"));
}

TEST(PlacedThing, outsideMayStandOnTheGround) {
    PlacedHut placed;
    placed.hut.moving.placed = {placed.thing(7, placed.hut.table, 0, {30, 30, 77}),
                                placed.thing(8, placed.hut.table, 0, {40, 30, 77})};
    placed.hut.moving.placed[0].isOnGround = true;
    const World world = placed.hut.load();
    ASSERT_EQ(world.placed.size(), 2u);
    EXPECT_NEAR(world.placed[0].origin.z, landHeight(2.0f), 1e-6) << "the meadow's height";
    EXPECT_NEAR(world.placed[1].origin.z, 77.0, 1e-6);
    EXPECT_EQ(world.placed[0].space, kOutside);
}

TEST(PlacedThing, withAMotionTableOfItsOwnMovesInPlace) {
    PlacedHut placed;
    placed.hut.moving.placed = {placed.thing(7, placed.setup, 0, {30, 30, 2}),
                                placed.thing(8, placed.setup, 0, {40, 30, 2})};
    placed.hut.moving.placed[0].motionTable = placed.addTable(0x09000103, 0x03000103, 45.0);
    placed.hut.moving.placed[1].opacity = 0.5;
    World world = placed.hut.load();
    ASSERT_EQ(world.idleObjects.size(), 1u)
        << "the table's standing pose equals the resting one; the faded one is idle";
    EXPECT_EQ(world.idleObjects[0].opacity, 0.5);
    // A cycle that moves: Off plays all frames.
    PlacedHut moving;
    dat::MotionTable table;
    table.id = 0x09000104;
    table.defaultStyle = test::kPuppetStyle;
    table.styleDefaults = {{test::kPuppetStyle, test::kSubstateOff}};
    dat::MotionData all;
    all.animations = {{0x03000101, 0, -1, 30.0f}};
    table.cycles = {{dat::motionKey(test::kPuppetStyle, test::kSubstateOff), all}};
    moving.hut.source.portalFile().add(table);
    moving.hut.moving.placed = {moving.thing(7, moving.setup, 0, {30, 30, 2})};
    moving.hut.moving.placed[0].motionTable = 0x09000104;
    world = moving.hut.load();
    ASSERT_EQ(world.idleObjects.size(), 1u);
    EXPECT_NE(world.idleObjects[0].body.cycles[0], kNone);
}

TEST(PlacedThing, hasALookOfItsOwn) {
    PlacedHut placed;
    const std::uint32_t other =
        placed.hut.source.addModel(test::boxExterior({-1, -1, 0}, {1, 1, 1}, "velvet"));
    placed.hut.moving.placed = {placed.thing(7, placed.setup, 0, {30, 30, 2}),
                                placed.thing(8, placed.setup, 0, {40, 30, 2})};
    placed.hut.moving.placed[0].look.parts = {{0, other}};
    const World world = placed.hut.load();
    std::vector<dat::RecordId> records;
    for (const Instance& instance : world.instances)
        for (const PlacedObject& object : world.placed)
            if (instance.object == object.object)
                records.push_back(instance.record);
    EXPECT_EQ(records, (std::vector<dat::RecordId>{other, placed.hut.leaf}));
}

TEST(PlacedThing, stopsBodiesUnlessItIsEthereal) {
    const auto solidsOf = [](bool stops) {
        PlacedHut placed;
        placed.hut.moving.placed = {placed.thing(7, placed.hut.table, 0, {30, 30, 2})};
        placed.hut.moving.placed[0].stopsBodies = stops;
        const test::TempDir directory;
        EXPECT_TRUE(placed.hut.source.write(directory.path()));
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        const Result<World> world = loadWorld(*archive, placed.hut.source.home(), {}, placed.hut.moving);
        const Result<Solids> solids = loadSolids(*archive, *world, placed.hut.source.home(), 1);
        EXPECT_TRUE(solids);
        return std::count_if(solids->solids.begin(), solids->solids.end(), [&](const Solid& solid) {
            const Vec3 corner = solids->origin + solids->corners[3 * solid.firstTriangle];
            return solid.kind == InstanceKind::Static &&
                   glm::length(corner - placed.hut.at({30, 30, 2})) < 2.0;
        });
    };
    EXPECT_EQ(solidsOf(true), 1);
    EXPECT_EQ(solidsOf(false), 0);
}

} // namespace
} // namespace limen::world
