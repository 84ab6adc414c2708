#include "support/LoadTestWorld.h"

#include "motion/DynamicStateBuilder.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace limen::motion {
namespace {

/// Two rotated rooms, and a flat pane in the window between them.
struct AskewWindow {
    static constexpr double kTurn = 33.0; // degrees, counter-clockwise
    static Vec3 askew(const Vec3& p) {
        const Mat3 turn(glm::rotate(glm::dmat4(1.0), glm::radians(kTurn), Vec3(0, 0, 1)));
        return Vec3(21.3, 24.7, 2) + turn * p;
    }
    static std::vector<Vec3> askew(std::vector<Vec3> points) {
        for (Vec3& p : points)
            p = askew(p);
        return points;
    }
    test::TestWorld::Cell add(const Vec3& min, const Vec3& max) {
        test::Walls walls = test::boxWalls(min, max);
        for (test::Wall& wall : walls)
            wall.points = askew(wall.points);
        return source.addCell(std::move(walls));
    }

    test::TestWorld source;
    test::TestWorld::Cell room = add({0, 0, 0}, {4, 3, 3}), other = add({0, 3, 0}, {4, 6, 3});
    world::MovingEntries moving;
    world::World world;
    explicit AskewWindow(double sunk = 0.0) {
        const auto window = source.link(room, askew(test::rectangle({1, 3, 1}, {2.3, 3, 2.1})), other).first;
        source.solid("glass", 0xFF80A0C0u, 0x10, 0.6f);
        const std::uint32_t pane =
            source.addModel({{test::rectangle({0, 0, 0}, {1.3, 0, 1.1}), "glass", true}});
        const Vec3 hinge = askew(Vec3(1, 3 - sunk, 1)) +
                           Vec3(source.home().x * world::kBlockSize, source.home().y * world::kBlockSize, 0);
        moving.doors.push_back(
            {"pane", source.id(room), window.index, false, 0.0, {{pane, hinge, -kTurn, 90.0}}});
        world = test::loadTestWorld(source, {0, true}, moving);
    }
    [[nodiscard]] std::vector<Vec3> cornersOf(const world::MovingBody& body) const {
        std::vector<Vec3> corners;
        for (std::uint32_t p = body.firstPart; p < body.firstPart + body.partCount; ++p) {
            const world::Mesh& mesh = world.meshes[world.movingParts[p].mesh];
            for (const world::Mesh::Range& range : mesh.ranges) {
                for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; ++i)
                    corners.push_back(world.vertices[mesh.firstVertex + world.indices[i]].corner() +
                                      world.blocks[0].origin());
            }
        }
        return corners;
    }
};

TEST(ShutPanes, shareTheirCornersWithTheWallsToTheBit) {
    const AskewWindow scene;
    ASSERT_EQ(scene.world.leaves.size(), 1u);
    const auto outline = world::polygonOf(scene.world, scene.world.portals[scene.world.doors[0].portal]);
    const std::vector<Vec3> corners = scene.cornersOf(scene.world.leaves[0].shut);
    ASSERT_EQ(corners.size(), 12u) << "two triangles, from both sides";
    for (const Vec3& corner : corners)
        EXPECT_TRUE(std::find(outline.begin(), outline.end(), corner) != outline.end());
}

TEST(ShutPanes, standWhereTheyAreWhenTheyAreNoNeighboursOfWalls) {
    const AskewWindow scene(0.05);
    const auto outline = world::polygonOf(scene.world, scene.world.portals[scene.world.doors[0].portal]);
    for (const Vec3& corner : scene.cornersOf(scene.world.leaves[0].shut)) {
        double nearest = 1.0;
        for (const Vec3& p : outline)
            nearest = std::min(nearest, glm::distance(p, corner));
        EXPECT_NEAR(nearest, 0.05, 1e-4);
    }
}

TEST(ShutPanes, turnAboutTheirHingeOnceTheyOpen) {
    const AskewWindow scene;
    DynamicStateBuilder dynamicsBuilder(scene.world);
    world::DynamicState shut, open;
    dynamicsBuilder.build({}, shut);
    DynamicStateInput input;
    input.allDoors = 0.5;
    dynamicsBuilder.build(input, open);
    ASSERT_EQ(shut.instances.size(), 1u);
    ASSERT_EQ(open.instances.size(), 1u);
    EXPECT_EQ(shut.instances[0].linear, glm::mat3(1.0f));
    EXPECT_NE(open.instances[0].linear, glm::mat3(1.0f));
    EXPECT_EQ(shut.instances[0].memberCount, 2u);
    EXPECT_EQ(shut.instances[0].record, open.instances[0].record);
    EXPECT_NEAR(shut.instances[0].bounds.radius, open.instances[0].bounds.radius, 1e-3);
    // Shut, its middle is that of the window.
    const Vec3 middle = AskewWindow::askew(Vec3(1.65, 3, 1.55)) + scene.world.blocks[0].origin();
    EXPECT_LT(glm::distance(shut.instances[0].bounds.centre, middle), 1e-3);
}

} // namespace
} // namespace limen::motion
