#include "engine/places/Shapes.h"

#include "engine/places/Viewpoints.h"
#include "support/LoadTestWorld.h"

#include <gtest/gtest.h>

namespace limen::engine {
namespace {

/// The picture of a hatch in the ceiling is on its upper side, which the room does not see.
TEST(Shapes, aPictureOnTheFarSideOfAnOpeningIsNoFloor) {
    test::TestWorld world;
    const auto room = world.addBox({80, 80, 0}, {86, 86, 3}), loft = world.addBox({80, 80, 3}, {86, 86, 6});
    test::TestWorld::LinkOptions options;
    options.insideIsPositive = false;
    options.surface = "grey";
    world.link(room, test::rectangle({81, 81, 3}, {85, 85, 3}), loft, options);
    const test::TempDir directory;
    ASSERT_TRUE(world.write(directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    Shapes shapes(*archive);
    const CellShape* cell = shapes.cell(world.id(room));
    ASSERT_NE(cell, nullptr);
    const std::vector<Vec3> eyes = standingEyes(*cell);
    EXPECT_FALSE(eyes.empty());
    for (const Vec3& eye : eyes)
        EXPECT_LT(eye.z, 3.0) << "in the room, not on its hatch";
}

/// A doorway that leans by 20 degrees, 2.2 m high: its eye is in its plane, not over the middle of its sill.
TEST(Shapes, theEyeOfALeaningDoorwayIsInItsPlane) {
    const double lean = 0.8;
    test::TestWorld world;
    test::Walls west = test::boxWalls({80, 80, 0}, {84, 84, 3}),
                east = test::boxWalls({84, 80, 0}, {88, 84, 3});
    const auto leanAll = [&](test::Walls& walls) {
        for (test::Wall& wall : walls)
            for (Vec3& p : wall.points)
                p.x += p.x == 84.0 && p.z > 0.0 ? lean : 0.0;
    };
    leanAll(west);
    leanAll(east);
    west.erase(west.begin() + test::kEast);
    east.erase(east.begin() + test::kWest);
    const auto a = world.addCell(std::move(west)), b = world.addCell(std::move(east));
    world.link(a, {{84, 80, 0}, {84, 84, 0}, {84 + lean, 84, 3}, {84 + lean, 80, 3}}, b);
    const test::TempDir directory;
    ASSERT_TRUE(world.write(directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    Shapes shapes(*archive);
    for (const auto id : {world.id(a), world.id(b)}) {
        const CellShape* cell = shapes.cell(id);
        ASSERT_NE(cell, nullptr);
        ASSERT_EQ(cell->openings.size(), 1u);
        const Opening& door = cell->openings.front();
        EXPECT_TRUE(door.isDoor());
        EXPECT_NEAR(glm::dot(door.eye() - door.middle, door.inward), 0.0, 1e-6);
        EXPECT_NEAR(door.eye().z, 1.7, 1e-9);
    }
}

} // namespace
} // namespace limen::engine
