#include "plain/PlainScene.h"
#include "ComparedWorld.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

using Triangle = std::array<std::array<float, 8>, 3>;

std::array<float, 8> cornerOf(const Vec3f& at, const Vec3f& normal, const Vec2f& uv) {
    return {at.x, at.y, at.z, normal.x, normal.y, normal.z, uv.x, uv.y};
}

std::vector<Triangle> trianglesOf(const MeshPart& part) {
    std::vector<Triangle> triangles(part.indices.size() / 3);
    for (std::size_t i = 0; i < part.indices.size(); ++i) {
        const PlainVertex& v = part.vertices[part.indices[i]];
        triangles[i / 3][i % 3] = cornerOf(v.position, v.normal, v.uv);
    }
    return triangles;
}

/// Of an instance that is no terrain, whose coordinates are scaled.
std::vector<Triangle> trianglesOf(const world::World& world, const world::Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (const world::Mesh::Range& range : mesh.ranges) {
        for (std::uint32_t i = 0; i < range.indexCount; ++i) {
            const world::MeshVertex& v =
                world.vertices[world.indices[range.firstIndex + i] + mesh.firstVertex];
            if (i % 3 == 0)
                triangles.emplace_back();
            triangles.back()[i % 3] = cornerOf(v.position, v.normal, v.uv);
        }
    }
    return triangles;
}

/// Of the world's instances, those of a kind.
std::vector<world::Instance> instancesOf(const FramePlace& place, world::InstanceKind kind) {
    std::vector<world::Instance> found;
    for (const world::Instance& instance : place.part->world.instances)
        if (instance.kind == kind && instance.mesh != world::kNone)
            found.push_back(instance);
    return found;
}

TEST(MeshParts, haveEveryTriangleOfTheMeshOnce) {
    ComparedWorld source;
    const FramePlace place = source.placeAt(source.outside, 64, 36);
    std::size_t compared = 0;
    for (const world::Instance& instance : place.part->world.instances) {
        if (instance.mesh == world::kNone || instance.kind == world::InstanceKind::Terrain)
            continue;
        std::vector<Triangle> parts;
        for (const MeshPart& part : partsOf(place.part->world, instance)) {
            const std::vector<Triangle> more = trianglesOf(part);
            parts.insert(parts.end(), more.begin(), more.end());
        }
        std::vector<Triangle> mesh = trianglesOf(place.part->world, place.part->world.meshes[instance.mesh]);
        std::sort(parts.begin(), parts.end());
        std::sort(mesh.begin(), mesh.end());
        EXPECT_EQ(parts, mesh);
        compared += mesh.size();
    }
    EXPECT_GT(compared, 40u);
}

TEST(MeshParts, shareEqualCorners) {
    ComparedWorld source;
    const FramePlace place = source.placeAt(source.outside, 64, 36);
    const std::vector<world::Instance> grounds = instancesOf(place, world::InstanceKind::Terrain);
    ASSERT_FALSE(grounds.empty());
    const std::vector<MeshPart> parts = partsOf(place.part->world, grounds.front());
    ASSERT_EQ(parts.size(), 1u) << "one texture";
    EXPECT_EQ(parts.front().indices.size(), 8u * 8u * 6u);
    EXPECT_LT(parts.front().vertices.size(), parts.front().indices.size() * 3 / 4);
    std::vector<std::array<float, 8>> corners;
    for (const PlainVertex& v : parts.front().vertices)
        corners.push_back(cornerOf(v.position, v.normal, v.uv));
    std::sort(corners.begin(), corners.end());
    EXPECT_EQ(std::unique(corners.begin(), corners.end()), corners.end());
}

TEST(PlainScene, drawsTheTrianglesOfTheEyesLevels) {
    ComparedWorld source;
    std::set<std::size_t> counts;
    // Before all objects, and as wide as views get.
    for (const auto& [north, yaw] : {std::pair{-5.0, 0.0}, {ComparedWorld::kChangesAt + 2.0, 180.0}}) {
        const world::Place from{"", source.hut.at(ComparedWorld::kPost + Vec3(0, north, 0)), yaw, 0.0, 0};
        FramePlace place = source.placeAt(from, 64, 36);
        place.view.view.tanHalfX = place.view.view.tanHalfY = 1e4;
        const PlainScene scene = plainSceneOf(place);
        PlainSelection selection;
        selectPlain(place.part->world, scene, place.view.view, selection);
        const std::size_t all = trianglesFrom(place.part->world, place.dynamics, from.eye);
        EXPECT_GT(all, 300u);
        EXPECT_EQ(trianglesOf(scene, selection), all);
        counts.insert(all);
        place.view.view.forward = -place.view.view.forward;
        place.view.view.right = -place.view.view.right;
        selectPlain(place.part->world, scene, place.view.view, selection);
        EXPECT_LT(trianglesOf(scene, selection), all) << "the objects are behind the eye";
    }
    EXPECT_EQ(counts.size(), 2u) << "the post has two levels";
}

TEST(PlainScene, sortsDrawsBySurfaceAndBlendsBackToFront) {
    ComparedWorld source;
    const FramePlace place = source.placeAt(source.inRoom, 64, 36);
    const PlainScene scene = plainSceneOf(place);
    EXPECT_TRUE(
        std::is_sorted(scene.solid.begin(), scene.solid.end(), [](const PlainDraw& a, const PlainDraw& b) {
            return std::pair(a.surface.surfaceClass, a.surface.texture) <
                   std::pair(b.surface.surfaceClass, b.surface.texture);
        }));
    PlainSelection selection;
    FramePlace wide = place;
    wide.view.view.tanHalfX = wide.view.view.tanHalfY = 1e4;
    selectPlain(place.part->world, scene, wide.view.view, selection);
    ASSERT_GT(selection.blended.size(), 1u) << "smoke";
    EXPECT_TRUE(std::is_sorted(selection.blended.begin(), selection.blended.end(),
                               [](const auto& a, const auto& b) { return a.distance > b.distance; }));
}

} // namespace
} // namespace limen::bench::test
