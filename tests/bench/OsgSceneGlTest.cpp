#include "ComparedWorld.h"
#include "peer/osg/OsgScene.h"

#include <gtest/gtest.h>
#include <osg/ComputeBoundsVisitor>

namespace limen::bench::test {
namespace {

/// The graphs of a place's instances, in one.
struct PlaceGraph {
    OsgScene scene;
    osg::ref_ptr<osg::Group> root = new osg::Group;

    explicit PlaceGraph(const FramePlace& place) : scene(place.part->world, originNear(place.view.view.eye)) {
        root->addChild(scene.graphOf(place.part->world.instances));
        root->addChild(scene.graphOf(place.dynamics.instances));
    }
};

TEST(OsgScene, hasTheWorldsTrianglesAtEveryLevelOfDetail) {
    ComparedWorld source;
    std::set<std::size_t> counts;
    for (const double away : {3.0, ComparedWorld::kChangesAt - 2.0, ComparedWorld::kChangesAt + 2.0, 125.0}) {
        const world::Place from{"", source.hut.at(ComparedWorld::kPost + Vec3(0, away, 0)), 0.0, 0.0, 0};
        const FramePlace place = source.placeAt(from, 64, 36);
        PlaceGraph graph(place);
        const std::size_t all = trianglesFrom(place.part->world, place.dynamics, from.eye);
        EXPECT_GT(all, 300u);
        EXPECT_EQ(trianglesIn(*graph.root, graph.scene.origin(), from.eye), all) << away;
        counts.insert(all);
    }
    EXPECT_EQ(counts.size(), 2u) << "two levels, of which the second has no end";
}

TEST(OsgScene, isWhereTheWorldIs) {
    ComparedWorld source;
    const FramePlace place = source.placeAt(source.outside, 64, 36);
    std::vector<world::Instance> houses;
    Aabb expected;
    for (const world::Instance& instance : place.part->world.instances) {
        if (instance.kind != world::InstanceKind::Exterior)
            continue;
        houses.push_back(instance);
        const world::Mesh& mesh = place.part->world.meshes[instance.mesh];
        for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v)
            expected.include(place.part->world.blocks[instance.block].origin() +
                             Vec3(place.part->world.vertices[v].position));
    }
    ASSERT_FALSE(houses.empty());
    OsgScene scene(place.part->world, originNear(place.view.view.eye));
    osg::ComputeBoundsVisitor bounds;
    scene.graphOf(houses)->accept(bounds);
    const osg::BoundingBox& box = bounds.getBoundingBox();
    const Vec3 least = Vec3(box.xMin(), box.yMin(), box.zMin()) + scene.origin();
    const Vec3 most = Vec3(box.xMax(), box.yMax(), box.zMax()) + scene.origin();
    EXPECT_LT(glm::length(least - expected.min), 1e-3);
    EXPECT_LT(glm::length(most - expected.max), 1e-3);
}

} // namespace
} // namespace limen::bench::test
