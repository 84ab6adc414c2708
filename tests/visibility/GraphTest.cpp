#include "visibility/Graph.h"

#include <gtest/gtest.h>

namespace limen::visibility {
namespace {

const std::vector<Vec3> kTriangle{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};

TEST(Graph, refusesAPortalToASpaceThatDoesNotExist) {
    const std::vector<SpaceDesc> spaces{{0, 1, 0}};
    const std::vector<PortalDesc> portals{{0, 7, kNone, 0, 3, true}};
    const auto graph = Graph::build(spaces, portals, kTriangle);
    ASSERT_FALSE(graph);
    EXPECT_EQ(graph.error().code, ErrorCode::BadArgument);
}

TEST(Graph, refusesAPortalOutsideTheRunOfItsSpace) {
    const std::vector<SpaceDesc> spaces{{0, 0, 0}, {0, 1, 1}};
    const std::vector<PortalDesc> portals{{0, 1, kNone, 0, 3, true}};
    EXPECT_FALSE(Graph::build(spaces, portals, kTriangle));
}

TEST(Graph, refusesVerticesOutsideTheArrayAndNotFinite) {
    const std::vector<SpaceDesc> spaces{{0, 1, 0}};
    const std::vector<PortalDesc> beyond{{0, kNone, kNone, 2, 3, true}};
    EXPECT_FALSE(Graph::build(spaces, beyond, kTriangle));
    const std::vector<PortalDesc> portals{{0, kNone, kNone, 0, 3, true}};
    std::vector<Vec3> vertices = kTriangle;
    vertices[1].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(Graph::build(spaces, portals, vertices));
}

TEST(Graph, givesSpacesWithManyPortalsATreeThatHoldsThemAll) {
    std::vector<SpaceDesc> spaces{{0, 40, 0}, {0, 0, 1}};
    std::vector<PortalDesc> portals;
    std::vector<Vec3> vertices;
    for (std::uint32_t i = 0; i < 40; ++i) {
        portals.push_back({0, 1, kNone, i * 3, 3, true});
        for (const Vec3& v : kTriangle)
            vertices.push_back(v + Vec3(i % 7, i * 0.5, i % 3));
    }
    const auto graph = Graph::build(spaces, portals, vertices);
    ASSERT_TRUE(graph);
    ASSERT_NE(graph->spaces()[0].root, kNone);
    EXPECT_EQ(graph->spaces()[1].root, kNone);
    std::vector<int> found(40, 0);
    for (const auto& node : graph->boundsNodes()) {
        if (node.child == kNone) {
            ++found[node.portal];
            for (const Vec3& v : graph->polygon(graph->portals()[node.portal]))
                EXPECT_TRUE(node.box.contains(v));
        }
    }
    EXPECT_EQ(found, std::vector<int>(40, 1));
}

} // namespace
} // namespace limen::visibility
