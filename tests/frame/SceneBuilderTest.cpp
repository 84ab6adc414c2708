#include "PlannedWorld.h"

#include "frame/SceneBuilder.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

struct SceneBuilderTest : ::testing::Test {
    Rooms rooms;
    world::World world = loadTestWorld(rooms.world, {1, false});
    frame::SceneUpload scene = frame::buildScene(frame::StaticScene(world));
};

TEST_F(SceneBuilderTest, keepsTheWorldsNumbers) {
    EXPECT_EQ(scene.instances.size(), world.instances.size());
    EXPECT_EQ(scene.vertices.size(), world.vertices.size());
    EXPECT_EQ(scene.materials.size(), world.materials.size());
    EXPECT_EQ(scene.lightSets.size(), world.lightSets.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
        EXPECT_EQ(scene.instances[i].idBase, world.instances[i].idBase);
}

TEST_F(SceneBuilderTest, givesEachInstanceItsZonesWithoutRepeatsTheOneItStandsInFirst) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const auto& packed = scene.instances[i];
        const world::Instance& in = world.instances[i];
        ASSERT_GT(frame::gpu::memberCountOf(packed), 0u);
        EXPECT_EQ(scene.members[packed.firstMember].zone, world.spaces[in.placedIn].zone);
        for (std::uint32_t a = 0; a < frame::gpu::memberCountOf(packed); ++a) {
            for (std::uint32_t b = 0; b < a; ++b) {
                EXPECT_NE(scene.members[packed.firstMember + a].zone,
                          scene.members[packed.firstMember + b].zone);
            }
        }
    }
}

TEST_F(SceneBuilderTest, placesVerticesAsTheWorldDoes) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const auto& packed = scene.instances[i];
        const world::Instance& in = world.instances[i];
        const Vec3f p(1.0f, 2.0f, 3.0f);
        const Vec3f expected = in.linear * p + in.origin;
        const auto &a = packed.pose0, &b = packed.pose1, &c = packed.pose2;
        const Vec3f placed = Vec3f(a.x, a.y, a.z) * p.x + Vec3f(a.w, b.x, b.y) * p.y +
                             Vec3f(b.z, b.w, c.x) * p.z + Vec3f(c.y, c.z, c.w);
        EXPECT_LT(glm::length(placed - expected), 1e-4f);
    }
}

} // namespace
} // namespace limen::test
