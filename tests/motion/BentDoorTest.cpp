#include "Walker.h"
#include "motion/DynamicStateBuilder.h"
#include "support/BentRooms.h"
#include "world/OpeningParts.h"

#include <gtest/gtest.h>

// A door in an opening that is not flat, and so is cut into parts.
namespace limen::motion {
namespace {

struct BentDoorway {
    test::TestWorld source;
    test::BentRooms rooms{source, 4.0, 0.003};

    [[nodiscard]] world::MovingEntries withDoor(bool isOpaque) const {
        world::MovingEntries moving;
        world::DoorEntry door;
        door.name = "door";
        door.cell = source.id(rooms.a);
        door.portal = 0;
        door.opaque = isOpaque;
        moving.doors.push_back(door);
        return moving;
    }
};

TEST(BentDoor, shutsAndFillsAllPartsFromBothSides) {
    BentDoorway doorway;
    const world::World world = test::loadTestWorld(doorway.source, {}, doorway.withDoor(true));
    ASSERT_EQ(world.doors.size(), 1u);
    ASSERT_EQ(world.portals.size(), 4u);
    DynamicStateBuilder builder(world);
    world::DynamicState state;
    DynamicStateInput input;
    for (const double open : {0.0, 0.5}) {
        input.doors = std::span(&open, 1);
        builder.build(input, state);
        for (world::PortalIndex p = 0; p < 4; ++p) {
            EXPECT_EQ(state.closed[p] != 0, open == 0.0) << p;
            EXPECT_EQ(state.fillings[p] != world::kNone, open == 0.0) << p;
            EXPECT_EQ(state.fillings[p], state.fillings[0]);
        }
    }
}

TEST(BentDoor, hasAFillingOfTheSameTriangles) {
    BentDoorway doorway;
    const world::World world = test::loadTestWorld(doorway.source, {}, doorway.withDoor(true));
    const world::Instance& filling = world.movingParts[world.doors[0].filling];
    const world::Mesh& mesh = world.meshes[filling.mesh];
    const Vec3 block = world.blocks[filling.block].origin();
    forParts(world, world.doors[0].portal, [&](world::PortalIndex p) {
        for (const Vec3& corner : cornersOf(world, world.portals[p])) {
            const auto vertices = std::span(world.vertices).subspan(mesh.firstVertex, mesh.vertexCount);
            EXPECT_TRUE(std::any_of(vertices.begin(), vertices.end(), [&](const world::MeshVertex& vertex) {
                return block + vertex.corner() == corner;
            }));
        }
    });
    EXPECT_EQ(mesh.vertexCount, 12u) << "two triangles, two sides";
}

TEST(BentDoor, stopsABodyWhereverItWalks) {
    BentDoorway doorway;
    test::Walker walker(doorway.source, doorway.withDoor(true));
    for (const double y : {0.5, 2.0, 3.5}) {
        for (const double open : {0.0, 1.0}) {
            walker.doors = {open};
            walker.put({2.0, y, 0.0}, walker.space(doorway.rooms.a));
            walker.go(test::kYawEast, 2.0);
            EXPECT_EQ(walker.body.standing.space,
                      walker.space(open > 0.0 ? doorway.rooms.b : doorway.rooms.a))
                << y << " " << open;
        }
    }
}

} // namespace
} // namespace limen::motion
