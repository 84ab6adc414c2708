#include "visibility/Region.h"
#include "visibility/RectLanes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace limen::visibility {
namespace {

class RegionTest : public testing::Test {
protected:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    /// A convex polygon of (x, y, w), counter-clockwise, in front of the eye.
    std::vector<Vec3> convexPolygon(std::size_t vertices) {
        const double x = between(-1.0, 1.0), y = between(-1.0, 1.0), radius = between(0.1, 1.5);
        std::vector<Vec3> polygon;
        for (std::size_t i = 0; i < vertices; ++i) {
            const double angle = (static_cast<double>(i) + between(0.0, 0.9)) * 2.0 * std::numbers::pi /
                                 static_cast<double>(vertices);
            const double w = between(0.5, 20.0);
            polygon.emplace_back((x + radius * std::cos(angle)) * w, (y + radius * std::sin(angle)) * w, w);
        }
        return polygon;
    }

    Rect rect() {
        // Few values, so that edges are often equal.
        const auto coordinate = [this] { return std::floor(between(-3.0, 3.0)); };
        return {coordinate(), coordinate(), coordinate(), coordinate()};
    }

    std::mt19937 random_{7};
};

/// The same clip, edge by edge, with a copy after each.
std::vector<Vec3> clippedByEdges(std::vector<Vec3> polygon, const std::vector<Vec3>& region) {
    std::vector<Vec3> next;
    for (std::size_t i = 0; i < region.size(); ++i) {
        clipByEyePlane(polygon, glm::cross(region[i], region[(i + 1) % region.size()]), next);
        polygon.swap(next);
    }
    tidyRegion(polygon);
    return polygon;
}

TEST_F(RegionTest, clipsBitForBitAsEdgeByEdge) {
    std::vector<Vec3> out, swap;
    int cut = 0, whole = 0, none = 0;
    for (int i = 0; i < 20000; ++i) {
        // Up to 60 vertices: more than fit on the stack.
        const auto polygon = convexPolygon(3 + static_cast<std::size_t>(between(0.0, i % 10 == 0 ? 57 : 6)));
        const auto region = convexPolygon(3 + static_cast<std::size_t>(between(0.0, 6)));
        clipByRegion(polygon, region, out, swap);
        ASSERT_EQ(out, clippedByEdges(polygon, region)) << "round " << i;
        const bool isWhole = out.size() == polygon.size();
        none += out.empty() ? 1 : 0;
        whole += isWhole ? 1 : 0;
        cut += !out.empty() && !isWhole ? 1 : 0;
    }
    EXPECT_GT(cut, 1000);
    EXPECT_GT(whole, 1000);
    EXPECT_GT(none, 1000);
}

TEST_F(RegionTest, clipsAPolygonThatPassesBehindTheEyeAsEdgeByEdge) {
    std::vector<Vec3> out, swap;
    for (int i = 0; i < 5000; ++i) {
        std::vector<Vec3> polygon = convexPolygon(5);
        for (Vec3& v : polygon)
            v.z -= between(0.0, 10.0);
        const auto region = convexPolygon(4);
        clipByRegion(polygon, region, out, swap);
        ASSERT_EQ(out, clippedByEdges(polygon, region)) << "round " << i;
    }
}

TEST_F(RegionTest, aPolygonOfManyVerticesGrowsBeyondTheStack) {
    // 32 vertices fit. Each of the region's edges adds one.
    std::vector<Vec3> polygon, region, out, swap;
    for (int i = 0; i < 32; ++i)
        polygon.emplace_back(std::cos(i * std::numbers::pi / 16), std::sin(i * std::numbers::pi / 16), 1.0);
    for (int i = 0; i < 8; ++i) // cuts off every fourth corner alone
        region.emplace_back(1.0800 * std::cos((i + 0.5) * std::numbers::pi / 4),
                            1.0800 * std::sin((i + 0.5) * std::numbers::pi / 4), 1.0);
    clipByRegion(polygon, region, out, swap);
    EXPECT_EQ(out.size(), 40u);
    EXPECT_EQ(out, clippedByEdges(polygon, region));
}

TEST_F(RegionTest, rectanglesInLanesAreThoseOfScalars) {
    int contained = 0, apart = 0;
    for (int i = 0; i < 20000; ++i) {
        const Rect a = rect(), b = rect();
        const RectLanes lanes(a);
        const Rect both = lanes.intersection(b).rect();
        const Rect expected = intersection(a, b);
        ASSERT_TRUE(both.minX == expected.minX && both.minY == expected.minY);
        ASSERT_TRUE(both.maxX == expected.maxX && both.maxY == expected.maxY);
        ASSERT_EQ(lanes.intersection(b).empty(), expected.empty());
        const bool isInside = b.minX >= a.minX && b.maxX <= a.maxX && b.minY >= a.minY && b.maxY <= a.maxY;
        ASSERT_EQ(lanes.contains(b), isInside);
        const Rect hull = lanes.unionWith(b).rect();
        ASSERT_TRUE(hull.minX == std::min(a.minX, b.minX) && hull.minY == std::min(a.minY, b.minY));
        ASSERT_TRUE(hull.maxX == std::max(a.maxX, b.maxX) && hull.maxY == std::max(a.maxY, b.maxY));
        ASSERT_EQ(lanes.area(), (a.maxX - a.minX) * (a.maxY - a.minY));
        contained += isInside ? 1 : 0;
        apart += expected.empty() ? 1 : 0;
    }
    EXPECT_GT(contained, 100);
    EXPECT_GT(apart, 100);
}

} // namespace
} // namespace limen::visibility
