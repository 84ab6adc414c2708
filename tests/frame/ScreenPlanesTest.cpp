#include "frame/gates/ScreenPlanes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace limen::frame {
namespace {

constexpr ScreenSize kSize{640, 360};

bool isInside(const ScreenPlanes& planes, const Vec3& point) {
    for (std::uint32_t i = 0; i < planes.count; ++i)
        if (glm::dot(planes.lines[i], point) < 0.0)
            return false;
    return true;
}

/// A regular polygon on the screen, counter-clockwise. `radius`: of the picture's height.
std::vector<Vec3> roundRegion(int corners, double radius) {
    std::vector<Vec3> region;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        region.push_back(
            {radius * std::cos(angle) * kSize.height / kSize.width, radius * std::sin(angle), 1.0});
    }
    return region;
}

TEST(ScreenPlanes, ofTheWholePictureAreNone) {
    const std::vector<Vec3> whole{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    EXPECT_EQ(screenPlanes(whole, kSize).count, 0u);
}

TEST(ScreenPlanes, edgesAlongTheBorderHaveNone) {
    // The left half: only the edge in the middle cuts.
    const std::vector<Vec3> half{{-1, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 1}};
    const ScreenPlanes planes = screenPlanes(half, kSize);
    EXPECT_EQ(planes.count, 1u);
    EXPECT_TRUE(isInside(planes, {-0.9, 0.3, 1}));
    EXPECT_FALSE(isInside(planes, {0.1, 0.3, 1}));
}

TEST(ScreenPlanes, keepTheRegionAndNoMoreThanAFractionOfAPixel) {
    const std::vector<Vec3> region = roundRegion(8, 0.5);
    const ScreenPlanes planes = screenPlanes(region, kSize);
    EXPECT_EQ(planes.count, 8u);
    EXPECT_FALSE(planes.isRectangle);
    for (const Vec3& corner : region) {
        EXPECT_TRUE(isInside(planes, corner));
        EXPECT_TRUE(isInside(planes, corner * 7.5)) << "homogeneous";
        const double pixel = 2.0 / kSize.height;
        const double away = 1.0 + pixel / 0.5;
        EXPECT_FALSE(isInside(planes, {corner.x * away, corner.y * away, 1.0}))
            << "a pixel beyond the corner";
    }
}

TEST(ScreenPlanes, aRegionAcrossTheEyePlaneHasAVertexWithoutDepth) {
    const std::vector<Vec3> region{{1, 0, 0}, {0.2, 0.6, 1}, {-0.7, 0, 1}, {0.1, -0.5, 1}};
    const ScreenPlanes planes = screenPlanes(region, kSize);
    EXPECT_EQ(planes.count, 4u);
    EXPECT_TRUE(isInside(planes, {0, 0, 1}));
    EXPECT_TRUE(isInside(planes, {5, 0, 0.01})) << "far to the right";
    EXPECT_FALSE(isInside(planes, {-0.8, 0, 1}));
}

// Twelve edges of a small circle: neighbours meet less than a pixel beyond the edge between them.
TEST(ScreenPlanes, nearlyCollinearEdgesAreMerged) {
    const std::vector<Vec3> region = roundRegion(12, 0.03);
    const ScreenPlanes planes = screenPlanes(region, kSize);
    EXPECT_EQ(planes.count, 8u);
    EXPECT_FALSE(planes.isRectangle);
    for (const Vec3& corner : region)
        EXPECT_TRUE(isInside(planes, corner)) << "merging never loses a part of the region";
    EXPECT_FALSE(isInside(planes, {0, 0.03 + 2.5 * 2.0 / kSize.height, 1}))
        << "nor adds two pixels and a half";
}

TEST(ScreenPlanes, tooManyEdgesFallBackToTheRectangle) {
    const std::vector<Vec3> region = roundRegion(12, 0.8);
    const ScreenPlanes planes = screenPlanes(region, kSize);
    EXPECT_TRUE(planes.isRectangle);
    EXPECT_EQ(planes.count, 4u);
    for (const Vec3& corner : region)
        EXPECT_TRUE(isInside(planes, corner));
    EXPECT_TRUE(isInside(planes, {0.43, 0.77, 1})) << "a corner of the rectangle, outside the region";
    EXPECT_FALSE(isInside(planes, {0.0, 0.82, 1}));
}

} // namespace
} // namespace limen::frame
