#include "support/LoadTestWorld.h"
#include "world/mesh/Models.h"
#include "world/records/Pose.h"

// The accuracy of stored corners. Touching cells of a zone overlap by their error.
namespace limen::world {
namespace {

using test::TestWorld;

const MeshVertex& nearestVertex(const World& world, const Mesh& mesh, const Vec3& to) {
    std::uint32_t nearest = mesh.firstVertex;
    for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v)
        if (glm::length(world.vertices[v].corner() - to) < glm::length(world.vertices[nearest].corner() - to))
            nearest = v;
    return world.vertices[nearest];
}

const Mesh& shellOf(const World& world, const TestWorld& source, TestWorld::Cell cell) {
    return world.meshes[world.instances[world.spaces[findCell(world, source.id(cell))].shell].mesh];
}

/// The position of a corner by the cell's record, which stores floats relative to the cell's frame.
Vec3 asRecorded(const dat::Frame& frame, const Vec3& corner) {
    const Pose pose = poseOf(frame);
    const Vec3f local(glm::conjugate(pose.orientation) * (corner - pose.origin));
    return pose.apply(Vec3(local));
}

test::Walls turned(test::Walls walls, const Mat3& turn, const Vec3& origin) {
    for (test::Wall& wall : walls)
        for (Vec3& p : wall.points)
            p = origin + turn * p;
    return walls;
}

TEST(FineCorners, cellsThatTouchShareThemToTheBitWhereTheirRecordsPutThem) {
    const Vec3 origin(181.3, 173.7, 41.9);
    const Mat3 turn = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(Vec3(0.3, -0.2, 1.0))));
    TestWorld source;
    TestWorld::CellOptions first, second;
    first.frame = test::frameAt({182.1, 174.2, 42.3}, 31.0);
    second.frame = test::frameAt({185.7, 175.9, 43.1}, 203.0);
    const auto a = source.addCell(turned(test::boxWalls({0, 0, 0}, {4, 3, 2.5}), turn, origin), first);
    const auto b = source.addCell(turned(test::boxWalls({4, 0, 0}, {7, 3, 2.5}), turn, origin), second);
    const World world = test::loadTestWorld(source);
    for (const Vec3& shared : {Vec3(4, 0, 0), Vec3(4, 3, 0), Vec3(4, 0, 2.5), Vec3(4, 3, 2.5)}) {
        const Vec3 at = origin + turn * shared;
        const MeshVertex& mine = nearestVertex(world, shellOf(world, source, a), at);
        const MeshVertex& theirs = nearestVertex(world, shellOf(world, source, b), at);
        EXPECT_EQ(mine.position, theirs.position);
        EXPECT_EQ(mine.rest, theirs.rest);
        EXPECT_LT(glm::length(mine.corner() - asRecorded(first.frame, at)), 1e-6);
        EXPECT_LT(glm::length(mine.corner() - asRecorded(second.frame, at)), 1e-6);
    }
}

TEST(FineCorners, keepTheirPlaceFarFromTheBlocksOrigin) {
    TestWorld source;
    TestWorld::CellOptions options;
    options.frame = test::frameAt({190, 189, 100});
    const Vec3 low(190.123456789, 189.234567891, 100.345678912), high(191.456789123, 190.567891234, 101.5);
    const auto cell = source.addCell(test::boxWalls(low, high), options);
    const World world = test::loadTestWorld(source);
    const MeshVertex& vertex = nearestVertex(world, shellOf(world, source, cell), low);
    EXPECT_LT(glm::length(vertex.corner() - low), 1e-7);
    EXPECT_GT(glm::length(Vec3(vertex.position) - low), 1e-6) << "one float is not enough";
}

TEST(FineCorners, ofModelsAndTerrainAreFloats) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 3);
    source.addObject(source.addModel(test::boxExterior({-0.1, -0.3, 0}, {0.7, 1.1, 1.3})),
                     test::frameAt({150.3, 160.7, 12}, 31));
    const World world = test::loadTestWorld(source);
    ASSERT_FALSE(world.vertices.empty());
    for (const MeshVertex& vertex : world.vertices)
        EXPECT_EQ(vertex.rest, Vec3f(0.0f));
}

} // namespace
} // namespace limen::world
