#include "world/block/OpeningOverlay.h"

#include "geometry/ConvexPolygon.h"

#include <gmock/gmock.h>

#include <map>
#include <random>

namespace limen::world {
namespace {

using Loop = OpeningOverlay::Loop;
using Loops = std::vector<Loop>;

const Vec3 kUp(0, 0, 1);

/// A regular polygon with corners off the plane z = 0 by up to `off`.
Loop bentPolygon(const Vec3& middle, double radius, int corners, double off, std::mt19937& random) {
    std::uniform_real_distribution<double> height(-off, off);
    Loop polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i / corners + 0.1;
        polygon.push_back(
            middle + Vec3(radius * std::cos(angle), radius * std::sin(angle), off > 0 ? height(random) : 0));
    }
    return polygon;
}

double areaSeenFromAbove(const Loops& loops) {
    double sum = 0.0;
    for (const Loop& loop : loops)
        sum += newellNormal(loop).z / 2.0;
    return sum;
}

/// Edges that remain if those that are run along in both directions are left out.
std::vector<std::pair<Vec3, Vec3>> borderOf(const Loops& common, const Loops& own) {
    const auto less = [](const std::pair<Vec3, Vec3>& a, const std::pair<Vec3, Vec3>& b) {
        const double x[] = {a.first.x, a.first.y, a.first.z, a.second.x, a.second.y, a.second.z},
                     y[] = {b.first.x, b.first.y, b.first.z, b.second.x, b.second.y, b.second.z};
        return std::lexicographical_compare(std::begin(x), std::end(x), std::begin(y), std::end(y));
    };
    std::map<std::pair<Vec3, Vec3>, int, decltype(less)> count(less);
    for (const Loops* loops : {&common, &own})
        for (const Loop& loop : *loops)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec3 &from = loop[i], &to = loop[(i + 1) % loop.size()];
                ++count[{from, to}];
                --count[{to, from}];
            }
    std::vector<std::pair<Vec3, Vec3>> border;
    for (const auto& [edge, times] : count)
        if (times > 0)
            border.push_back(edge);
    return border;
}

/// The parts close a hole of this outline: their border is the outline, with more vertices on its edges.
void expectBorder(const OpeningOverlay& parts, const Loops& own, const Loop& outline) {
    const auto border = borderOf(parts.common, own);
    double length = 0.0, around = 0.0;
    for (const auto& [from, to] : border) {
        double beside = 1.0;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
            const double excess =
                glm::length(from - a) + glm::length(to - from) + glm::length(b - to) - glm::length(b - a);
            beside = std::min(beside, excess);
        }
        EXPECT_LT(beside, 1e-6);
        length += glm::length(to - from);
    }
    for (std::size_t i = 0; i < outline.size(); ++i)
        around += glm::length(outline[(i + 1) % outline.size()] - outline[i]);
    EXPECT_NEAR(length, around, 1e-6);
}

TEST(OpeningOverlay, cutsFlatOutlinesWhereTheyCross) {
    const Loop a{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, b{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
    const auto parts = overlayOpenings(a, b, kUp);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->common.size(), 1u);
    EXPECT_DOUBLE_EQ(areaSeenFromAbove(parts->common), 1.0);
    EXPECT_DOUBLE_EQ(areaSeenFromAbove(parts->first), 3.0);
    EXPECT_DOUBLE_EQ(areaSeenFromAbove(parts->second), 3.0);
    expectBorder(*parts, parts->first, a);
    expectBorder(*parts, parts->second, b);
}

TEST(OpeningOverlay, closesBothOutlinesIfTheirEdgesMissEachOther) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> aside(-0.04, 0.04);
    for (int i = 0; i < 200; ++i) {
        const int corners = 3 + i % 10;
        const double off = std::ldexp(0.003, -(i % 12));
        const Loop a = bentPolygon({5, 7, 0}, 1.0, corners, off, random),
                   b = bentPolygon({5 + aside(random), 7 + aside(random), 0}, 1.0, corners, off, random);
        const auto parts = overlayOpenings(a, b, kUp);
        ASSERT_TRUE(parts) << i;
        EXPECT_EQ(parts->common.size(), 1u) << i;
        expectBorder(*parts, parts->first, a);
        expectBorder(*parts, parts->second, b);
    }
}

TEST(OpeningOverlay, ofOneOutlineWithinAnotherHasARingOfSimpleParts) {
    std::mt19937 random(2);
    const Loop outer = bentPolygon({0, 0, 0}, 2.0, 7, 0.001, random),
               inner = bentPolygon({0.2, 0.1, 0}, 1.0, 5, 0.001, random);
    const auto parts = overlayOpenings(outer, inner, kUp), swapped = overlayOpenings(inner, outer, kUp);
    ASSERT_TRUE(parts && swapped);
    EXPECT_EQ(parts->first.size(), 2u);
    EXPECT_TRUE(parts->second.empty());
    expectBorder(*parts, parts->first, outer);
    expectBorder(*parts, {}, inner);
    EXPECT_TRUE(swapped->first.empty());
    expectBorder(*swapped, swapped->second, outer);
}

TEST(OpeningOverlay, keepsCommonEdgesAndVertices) {
    const Loop a{{0, 0, 0}, {2, 0, 0.001}, {2, 2, 0}, {0, 2, 0}}, low{{0, 0, 0}, {2, 0, 0.001}, {1, 1, 0}};
    const auto same = overlayOpenings(a, a, kUp);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->common.size(), 1u);
    EXPECT_TRUE(same->first.empty() && same->second.empty());
    const auto parts = overlayOpenings(a, low, kUp);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->common.size(), 1u);
    EXPECT_EQ(parts->common[0].size(), 3u);
    expectBorder(*parts, parts->first, a);
    expectBorder(*parts, parts->second, low);
}

TEST(OpeningOverlay, mayHaveAVertexOnTheOthersEdgeAsSeenAlongTheNormal) {
    const Loop a{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
        b{{1, 0, 0.001}, {1.5, 0.5, 0}, {1, 1, 0}, {0.5, 0.5, 0}};
    const auto parts = overlayOpenings(a, b, kUp);
    ASSERT_TRUE(parts);
    expectBorder(*parts, parts->first, a);
    expectBorder(*parts, parts->second, b);
}

TEST(OpeningOverlay, isNothingForOutlinesWithNothingInCommon) {
    const Loop a{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, b{{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}};
    EXPECT_FALSE(overlayOpenings(a, b, kUp));
}

} // namespace
} // namespace limen::world
