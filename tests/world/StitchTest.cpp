#include "world/mesh/Stitch.h"

#include "geometry/Segment.h"

#include <gtest/gtest.h>

namespace limen::world {
namespace {

StitchLoop loopOf(std::initializer_list<std::uint32_t> vertices) {
    StitchLoop loop;
    for (const std::uint32_t v : vertices)
        loop.push_back({v, Vec3f(0, 0, 1), Vec2f(static_cast<float>(v)), Vec2f(0)});
    return loop;
}

std::vector<std::uint32_t> verticesOf(const StitchLoop& loop) {
    std::vector<std::uint32_t> vertices;
    for (const StitchCorner& corner : loop)
        vertices.push_back(corner.vertex);
    return vertices;
}

using Vertices = std::vector<std::uint32_t>;

TEST(Stitcher, insertsVerticesInTheOrderOfTheEdgeEitherWay) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0},      {4, 4, 0},   {0, 4, 0},
                                     {3, 0, 0}, {1, 0.0001, 0}, {2, 0.01, 0}};
    Stitcher stitcher(vertices);
    const auto up = stitcher.stitch(loopOf({0, 1, 2, 3}));
    ASSERT_EQ(up.size(), 1u);
    EXPECT_EQ(verticesOf(up[0]), (Vertices{0, 5, 4, 1, 2, 3}));
    const auto down = stitcher.stitch(loopOf({3, 2, 1, 0}));
    ASSERT_EQ(down.size(), 1u);
    EXPECT_EQ(verticesOf(down[0]), (Vertices{3, 2, 1, 4, 5, 0}));
}

TEST(Stitcher, interpolatesTheAttributesOfCorners) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 0, 0}};
    Stitcher stitcher(vertices);
    const auto loops = stitcher.stitch(loopOf({0, 1, 2}));
    ASSERT_EQ(loops.size(), 1u);
    ASSERT_EQ(verticesOf(loops[0]), (Vertices{0, 3, 1, 2}));
    EXPECT_NEAR(loops[0][1].front.x, 0.25f, 1e-6f);
}

TEST(Stitcher, dissolvesASliverSoThatItsNeighboursMeet) {
    // The triangle 0 1 2 is thinner than the tolerance. Polygons on its long side get its third corner
    // instead.
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {2, 0.0001, 0}, {0, 4, 0}, {0, -4, 0}};
    Stitcher stitcher(vertices);
    EXPECT_TRUE(stitcher.stitch(loopOf({0, 1, 2})).empty());
    const auto above = stitcher.stitch(loopOf({0, 1, 3}));
    ASSERT_EQ(above.size(), 1u);
    EXPECT_EQ(verticesOf(above[0]), (Vertices{0, 2, 1, 3}));
}

TEST(Stitcher, dropsRepeatedCornersAndPolygonsWithoutThreeCorners) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    Stitcher stitcher(vertices);
    const auto loops = stitcher.stitch(loopOf({0, 1, 1, 2, 2}));
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(verticesOf(loops[0]), (Vertices{0, 1, 2}));
    EXPECT_TRUE(stitcher.stitch(loopOf({0, 1, 1})).empty());
    EXPECT_TRUE(stitcher.stitch(loopOf({0, 0, 0})).empty());
    EXPECT_TRUE(stitcher.stitch({}).empty());
}

TEST(PointTree, agreesWithABruteForceSearch) {
    std::vector<Vec3> points;
    for (int i = 0; i < 500; ++i)
        points.emplace_back(std::fmod(0.731 * i, 10.0), std::fmod(1.27 * i, 10.0),
                            std::fmod(0.391 * i, 10.0));
    const PointTree tree(points);
    for (int i = 0; i < 50; ++i) {
        const Vec3 a = points[static_cast<std::size_t>(i)], b = points[static_cast<std::size_t>(499 - i)];
        std::vector<std::uint32_t> found, expected;
        tree.nearSegment(a, b, 0.5, found);
        std::sort(found.begin(), found.end());
        for (std::uint32_t p = 0; p < points.size(); ++p)
            if (distanceToSegment(points[p], a, b).distance <= 0.5)
                expected.push_back(p);
        EXPECT_EQ(found, expected);
    }
}

} // namespace
} // namespace limen::world
