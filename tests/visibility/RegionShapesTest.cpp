// Regions as pixels, scissor rectangles, clip planes and triangles, against the definition of a region: a direction is in
// it if it is on the inner side of every edge.
#include "visibility/RegionPixels.h"
#include "visibility/RegionPlanes.h"
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace limen::visibility {
namespace {

const std::vector<Vec3> kWholeScreen{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};

/// The least value of a direction at the edges of a region; each edge has length 1.
double depthIn(std::span<const Vec3> region, const Vec3& direction) {
    double least = 1e300;
    for (std::size_t i = 0; i < region.size(); ++i)
        least =
            std::min(least, glm::dot(glm::normalize(glm::cross(region[i], region[(i + 1) % region.size()])),
                                     glm::normalize(direction)));
    return least;
}

Vec3 pixelCentre(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
    return {(2.0 * x + 1.0) / width - 1.0, (2.0 * y + 1.0) / height - 1.0, 1.0};
}

bool isConvex(std::span<const Vec3> region) {
    for (std::size_t i = 0; i < region.size(); ++i)
        for (const Vec3& corner : region)
            if (glm::dot(glm::cross(region[i], region[(i + 1) % region.size()]), corner) < -1e-12)
                return false;
    return true;
}

/// A convex region on, partly on or beside the screen, sometimes with a corner at infinity.
std::vector<Vec3> randomRegion(std::mt19937& random) {
    const auto number = [&](double most) {
        return std::uniform_real_distribution<double>(-most, most)(random);
    };
    const std::uint32_t corners = 3 + static_cast<std::uint32_t>(random() % 8);
    const Vec2 middle(number(1.2), number(1.2));
    const double size = std::exp(number(3.0));
    std::vector<Vec3> region;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = (i + 0.4 * number(1.0)) * 2.0 * std::numbers::pi / corners;
        const double w = std::exp(number(2.0));
        region.emplace_back((middle.x + size * std::cos(angle)) * w, (middle.y + size * std::sin(angle)) * w,
                            w);
    }
    if (random() % 4 == 0) { // from there to the plane of the eye, if it stays convex
        const Vec3 finite = region[0];
        region[0] = {finite.x / finite.z - middle.x, finite.y / finite.z - middle.y, 0.0};
        if (!isConvex(region))
            region[0] = finite;
    }
    return region;
}

RC_GTEST_PROP(RegionPixelsProperty, areThePixelsWhoseCentresAreInside, (unsigned seed)) {
    std::mt19937 random(seed);
    const std::vector<Vec3> region = randomRegion(random);
    const auto width = static_cast<std::uint32_t>(1 + random() % 40),
               height = static_cast<std::uint32_t>(1 + random() % 40);
    std::vector<PixelRun> runs;
    pixelsOf(region, width, height, runs);
    std::vector<std::uint8_t> found(std::size_t{width} * height, 0);
    for (const PixelRun& run : runs) {
        RC_ASSERT(run.y < height && run.firstX <= run.lastX && run.lastX < width);
        for (std::uint32_t x = run.firstX; x <= run.lastX; ++x)
            ++found[std::size_t{run.y} * width + x];
    }
    const PixelRect scissor = scissorOf(region, width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const double depth = depthIn(region, pixelCentre(x, y, width, height));
            const int count = found[std::size_t{y} * width + x];
            RC_ASSERT(count <= 1);
            if (std::abs(depth) > 1e-12)
                RC_ASSERT(count == (depth > 0.0 ? 1 : 0));
            if (count == 1)
                RC_ASSERT(x >= scissor.x && x < scissor.x + scissor.width && y >= scissor.y &&
                          y < scissor.y + scissor.height);
        }
    }
}

TEST(RegionPixels, coverTheWholeScreenAndNothing) {
    std::vector<PixelRun> runs;
    pixelsOf(kWholeScreen, 5, 2, runs);
    EXPECT_EQ(runs, (std::vector<PixelRun>{{0, 0, 4}, {1, 0, 4}}));
    pixelsOf({}, 5, 2, runs);
    EXPECT_TRUE(runs.empty());
    pixelsOf(kWholeScreen, 0, 2, runs);
    EXPECT_TRUE(runs.empty());
    pixelsOf(std::vector<Vec3>{{2, 0, 1}, {3, 0, 1}, {2, 1, 1}}, 5, 2, runs);
    EXPECT_TRUE(runs.empty());
}

TEST(Scissor, hasEveryTouchedPixelAndNoMore) {
    const std::vector<Vec3> triangle{{-0.5, -0.5, 1}, {0.1, -0.5, 1}, {-0.5, 0.3, 1}};
    EXPECT_EQ(scissorOf(triangle, 20, 20), (PixelRect{5, 5, 6, 8}));
    EXPECT_EQ(scissorOf(kWholeScreen, 1920, 1080), (PixelRect{0, 0, 1920, 1080}));
    EXPECT_EQ(scissorOf(std::vector<Vec3>{}, 20, 20), (PixelRect{}));
    EXPECT_EQ(scissorOf(kWholeScreen, 0, 20), (PixelRect{}));
    EXPECT_EQ(scissorOf(Rect{}, 20, 20), (PixelRect{}));
    EXPECT_EQ(scissorOf(Rect{-9, -9, -1, 9}, 20, 20), (PixelRect{0, 0, 1, 20}));
    EXPECT_EQ(scissorOf(Rect{1.5, 0, 2, 1}, 20, 20), (PixelRect{}));
}

TEST(RegionPixels, giveEachPixelItsVisit) {
    TestGraph world;
    for (int i = 0; i < 3; ++i)
        world.addSpace();
    world.link(0, 1, uprightRectangle({-1, 3, 0}, {0, -1, 0}, 1.5, 2));
    world.link(0, 2, uprightRectangle({1, 4, 0.5}, {0, -1, 0}, 2, 1));
    const VisibleSet set = floodOnce(world.build(), viewFrom({0, 0, 0}, 3, 2, 0));
    ASSERT_EQ(set.visits.size(), 3u);
    std::vector<std::uint32_t> visits;
    visitOfPixels(set, 31, 17, visits);
    ASSERT_EQ(visits.size(), 31u * 17u);
    std::vector<int> counts(3, 0);
    for (std::uint32_t y = 0; y < 17; ++y) {
        for (std::uint32_t x = 0; x < 31; ++x) {
            EXPECT_EQ(visits[y * 31 + x], ownerOf(set, pixelCentre(x, y, 31, 17))) << x << ", " << y;
            ++counts[visits[y * 31 + x]];
        }
    }
    EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 10);
}

/// The least distance of a point from the inner sides of all planes.
double depthIn(std::span<const Plane> planes, const Vec3& point) {
    double least = 1e300;
    for (const Plane& plane : planes)
        least = std::min(least, plane.signedDistance(point));
    return least;
}

RC_GTEST_PROP(ClipPlanesProperty, neverCutTheRegion, (unsigned seed)) {
    std::mt19937 random(seed);
    const std::vector<Vec3> region = randomRegion(random);
    View view = viewFrom({3, -2, 7}, static_cast<double>(random() % 360),
                         static_cast<double>(random() % 170) - 85.0, 0);
    view.tanHalfX = 1.3;
    view.tanHalfY = 0.6;
    std::vector<Plane> planes, all;
    clipPlanesOf(region, view, 100, all);
    RC_ASSERT(all.size() == region.size());
    const std::size_t most = random() % 9;
    clipPlanesOf(region, view, most, planes);
    RC_ASSERT(planes.size() <= most);
    for (int i = 0; i < 200; ++i) {
        const Vec3 screen = pixelCentre(static_cast<std::uint32_t>(random() % 64),
                                        static_cast<std::uint32_t>(random() % 64), 64, 64);
        const Vec3 direction = glm::normalize(view.forward + view.right * (screen.x * view.tanHalfX) +
                                              view.up * (screen.y * view.tanHalfY));
        const double depth = depthIn(region, screen);
        if (std::abs(depth) < 1e-9)
            continue;
        RC_ASSERT((depthIn(all, view.eye + direction) > 0.0) == (depth > 0.0));
        if (depth > 0.0)
            RC_ASSERT(depthIn(planes, view.eye + direction) > 0.0);
    }
}

TEST(ClipPlanes, leaveOutTheEdgeThatAddsLeast) {
    // A square with one corner cut off: without the cut it is a square again.
    const std::vector<Vec3> region{
        {-0.5, -0.5, 1}, {0.5, -0.5, 1}, {0.5, 0.4, 1}, {0.4, 0.5, 1}, {-0.5, 0.5, 1}};
    View view;
    std::vector<Plane> planes;
    clipPlanesOf(region, view, 4, planes);
    ASSERT_EQ(planes.size(), 4u);
    const auto at = [&](double x, double y) { return depthIn(planes, view.eye + Vec3(x, 1.0, y)); };
    EXPECT_GT(at(0.49, 0.49), 0.0);
    for (const auto& [x, y] : {std::pair(0.51, 0.0), {-0.51, 0.0}, {0.0, 0.51}, {0.0, -0.51}})
        EXPECT_LT(at(x, y), 0.0);
}

TEST(ClipPlanes, leaveOutTheBordersOfTheScreenFirst) {
    const std::vector<Vec3> half{{-1, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 1}};
    std::vector<Plane> planes;
    clipPlanesOf(half, View(), 3, planes);
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(glm::length(planes[0].n - Vec3(-1, 0, 0)), 0.0, 1e-15);
    clipPlanesOf(half, View(), 0, planes);
    EXPECT_TRUE(planes.empty());
    clipPlanesOf({}, View(), 6, planes);
    EXPECT_TRUE(planes.empty());
}

RC_GTEST_PROP(TrianglesProperty, coverTheRegionOnce, (unsigned seed)) {
    std::mt19937 random(seed);
    const std::vector<Vec3> region = randomRegion(random);
    std::vector<Vec4f> corners;
    trianglesOf(region, corners);
    RC_ASSERT(corners.size() == 3 * (region.size() - 2));
    for (int i = 0; i < 200; ++i) {
        const Vec3 screen = pixelCentre(static_cast<std::uint32_t>(random() % 64),
                                        static_cast<std::uint32_t>(random() % 64), 64, 64);
        int covered = 0, edges = 0;
        for (std::size_t t = 0; t < corners.size(); t += 3) {
            std::vector<Vec3> triangle;
            for (std::size_t c = t; c < t + 3; ++c) {
                RC_ASSERT(corners[c].z == 0.0f && corners[c].w >= 0.0f);
                triangle.emplace_back(corners[c].x, corners[c].y, corners[c].w);
            }
            const double depth = depthIn(triangle, screen);
            covered += depth > 0.0 ? 1 : 0;
            edges += std::abs(depth) < 1e-5 ? 1 : 0;
        }
        const double depth = depthIn(region, screen);
        if (edges == 0 && std::abs(depth) > 1e-5)
            RC_ASSERT(covered == (depth > 0.0 ? 1 : 0));
    }
}

} // namespace
} // namespace limen::visibility
