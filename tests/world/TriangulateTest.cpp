#include "world/mesh/Triangulate.h"

#include "geometry/ConvexPolygon.h"

#include <gtest/gtest.h>

#include <map>

namespace limen::world {
namespace {

double areaOf(const std::vector<Vec3>& polygon, const TriangleCorners& t) {
    const Vec3 a = polygon[t[0]], b = polygon[t[1]], c = polygon[t[2]];
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

/// Checks the area, that no triangle is degenerate, and that the triangles' outer edges are the polygon's
/// edges.
void expectCovers(const std::vector<Vec3>& polygon) {
    std::vector<TriangleCorners> triangles;
    triangulate(polygon, triangles);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    const Vec3 normal = planeOf(polygon).n;
    double area = 0.0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const TriangleCorners& t : triangles) {
        EXPECT_GT(areaOf(polygon, t), 1e-6);
        const Vec3 a = polygon[t[0]], b = polygon[t[1]], c = polygon[t[2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), normal), 0.0) << "winding is kept";
        area += areaOf(polygon, t);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    }
    EXPECT_NEAR(area, 0.5 * glm::length(newellNormal(polygon)), 1e-5);
    std::size_t outer = 0;
    for (const auto& [edge, balance] : edges)
        outer += balance != 0 ? 1 : 0;
    EXPECT_EQ(outer, polygon.size()) << "every edge of the polygon, and only those, is on the outside";
}

TEST(Triangulate, coversConvexPolygons) {
    expectCovers({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    expectCovers({{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}});
    std::vector<Vec3> circle;
    for (int i = 0; i < 24; ++i)
        circle.emplace_back(3.0, std::cos(static_cast<double>(i) * 0.2617994),
                            std::sin(static_cast<double>(i) * 0.2617994));
    expectCovers(circle);
}

TEST(Triangulate, leavesNoDegenerateTriangleWhereCornersLieOnEdges) {
    expectCovers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}});
    expectCovers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}});
    std::vector<Vec3> crowded;
    for (int i = 0; i < 20; ++i)
        crowded.emplace_back(static_cast<double>(i), 0.0, 0.0);
    crowded.emplace_back(20.0, 3.0, 0.0);
    for (int i = 0; i < 20; ++i)
        crowded.emplace_back(20.0 - static_cast<double>(i) * 0.7, 3.0 + static_cast<double>(i) * 0.0, 0.0);
    crowded.erase(crowded.begin() + 20);
    expectCovers(crowded);
}

TEST(Triangulate, copesWithStitchedCornersOffTheirEdges) {
    expectCovers(
        {{0, 0, 0}, {0.5, 0.0002, 0}, {1, -0.0002, 0}, {2, 0, 0}, {2, 2, 0}, {1.9998, 1, 0}, {0, 2, 0}});
}

TEST(Triangulate, coversNonConvexPolygons) {
    expectCovers({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}});
}

TEST(Triangulate, endsOnThinPolygons) {
    expectCovers({{0, 0, 0},
                  {1, 0, 0},
                  {2, 0, 0},
                  {3, 0, 0},
                  {3, 0.0003, 0},
                  {2, 0.0003, 0},
                  {1, 0.0003, 0},
                  {0, 0.0003, 0}});
}

TEST(Triangulate, yieldsNothingWithoutArea) {
    std::vector<TriangleCorners> triangles;
    triangulate(std::vector<Vec3>{}, triangles);
    triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, triangles);
    triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, triangles);
    triangulate(std::vector<Vec3>(5, Vec3(1, 2, 3)), triangles);
    EXPECT_TRUE(triangles.empty());
}

} // namespace
} // namespace limen::world
