#include "check/LonePolygon.h"

#include <gtest/gtest.h>

#include <limits>

namespace limen::check {
namespace {

/// Looks north along +y, 90° wide and high, 64 × 64 pixels; a pixel is 1/32 m wide at 1 m.
reference::Camera north() {
    reference::Camera camera;
    camera.width = camera.height = 64;
    return camera;
}

Triangle triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {{a, b, c}};
}

/// A wall across the view, 2 m ahead.
const std::vector<Triangle> kWallAhead{triangle({-9, 2, -9}, {9, 2, -9}, {0, 2, 9})};

TEST(LonePolygon, aWallAcrossTheViewHasOneDepth) {
    EXPECT_TRUE(mayHaveDepth(kWallAhead, north(), 30, 30, 2.0));
    EXPECT_TRUE(mayHaveDepth(kWallAhead, north(), 30, 30, 2.0001));
    EXPECT_FALSE(mayHaveDepth(kWallAhead, north(), 30, 30, 2.002));
    EXPECT_FALSE(mayHaveDepth(kWallAhead, north(), 30, 30, 1.998));
}

TEST(LonePolygon, aSteepOneHasThoseWithinTheRasterisersRounding) {
    // The plane z = -1 sloping up steeply: depth differs by much from one pixel to the next.
    const std::vector<Triangle> slope{triangle({-9, 2, -0.2}, {9, 2, -0.2}, {0, 40, -0.1})};
    const reference::Camera camera = north();
    const Vec3 d = reference::rayThrough(camera, 31, 34).direction;
    const Vec3 n =
        glm::cross(slope[0].corners[1] - slope[0].corners[0], slope[0].corners[2] - slope[0].corners[0]);
    const double offset = glm::dot(n, slope[0].corners[0]);
    const double t = offset / glm::dot(n, d);
    const double shifted = offset / glm::dot(n, reference::rayThrough(camera, 31, 34 + 1.0 / 160).direction);
    const double pixel = offset / glm::dot(n, reference::rayThrough(camera, 31, 34.05).direction);
    ASSERT_GT(std::abs(shifted - t), 1e-4 * t);
    EXPECT_TRUE(mayHaveDepth(slope, camera, 31, 34, t));
    EXPECT_TRUE(mayHaveDepth(slope, camera, 31, 34, shifted));
    EXPECT_FALSE(mayHaveDepth(slope, camera, 31, 34, pixel));
}

TEST(LonePolygon, hasNoDepthWhereItIsNot) {
    const std::vector<Triangle> small{triangle({-0.1, 2, -0.1}, {0.1, 2, -0.1}, {0, 2, 0.1})};
    EXPECT_TRUE(mayHaveDepth(small, north(), 31, 32, 2.0));
    EXPECT_FALSE(mayHaveDepth(small, north(), 5, 5, 2.0));
    EXPECT_FALSE(mayHaveDepth({}, north(), 31, 32, 2.0));
}

TEST(LonePolygon, neverHasADepthThatIsNoNumber) {
    for (const double depth :
         {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(mayHaveDepth(kWallAhead, north(), 30, 30, depth)) << depth;
}

TEST(LonePolygon, aStripThinnerThanTheSnappingCoversEdgeOn) {
    // The centre ray of pixel (31, 31) runs at -1/64 east and +1/64 up a metre; the floor's edge passes it
    // closely.
    const double up = 1.0 / 64;
    const std::vector<Triangle> sheet{triangle({-5, 1, up - 1e-4}, {5, 1, up - 1e-4}, {0, 8, 8 * up - 1e-4})};
    EXPECT_TRUE(coversEdgeOn(sheet, north(), 31, 31, 9.0));
    EXPECT_FALSE(coversEdgeOn(sheet, north(), 31, 29, 9.0)) << "another pixel";
}

TEST(LonePolygon, theThinnestStripStillCovers) {
    const double up = 1.0 / 64; // as above, but far thinner than any grid of rays
    const std::vector<Triangle> sheet{triangle({-5, 1, up - 1e-8}, {5, 1, up - 1e-8}, {0, 8, 8 * up - 1e-8})};
    EXPECT_TRUE(coversEdgeOn(sheet, north(), 31, 31, 9.0));
    EXPECT_FALSE(coversEdgeOn(sheet, north(), 31, 30, 9.0));
}

TEST(LonePolygon, whatLiesBehindTheEyeCoversNothing) {
    const std::vector<Triangle> behind{triangle({-9, -2, -9}, {9, -2, -9}, {0, -2, 9})};
    EXPECT_FALSE(coversEdgeOn(behind, north(), 31, 31, 9.0));
    EXPECT_FALSE(mayHaveDepth(behind, north(), 31, 31, 2.0));
}

TEST(LonePolygon, doesNotCoverEdgeOnWhatLiesBeforeItsPlane) {
    EXPECT_TRUE(coversEdgeOn(kWallAhead, north(), 30, 30, 2.5));
    EXPECT_FALSE(coversEdgeOn(kWallAhead, north(), 30, 30, 1.5)) << "something nearer is there";
    EXPECT_TRUE(coversEdgeOn(kWallAhead, north(), 30, 30, std::numeric_limits<double>::infinity()));
}

TEST(LonePolygon, itsOutlineIsRoundedTheMoreTheNearerItIs) {
    // A pixel is 1/32 m wide at 1 m. The centre ray of pixel (31, 31) runs at -1/64 east and +1/64 up a
    // metre; each pole has its edge there, and a foot 2 m below.
    const auto pole = [](double away) {
        const double edge = -away / 64;
        return std::vector<Triangle>{triangle({edge, away, -2}, {edge + 0.1, away, -2}, {edge, away, away})};
    };
    const auto expected = [](double away) {
        return 4e-7 * glm::length(Vec3(0.1 - away / 64, away, -2)) * 32 / away;
    };
    EXPECT_NEAR(outlineRounding(pole(0.02), north(), 31, 31), expected(0.02), 1e-6);
    EXPECT_NEAR(outlineRounding(pole(0.5), north(), 31, 31), expected(0.5), 1e-7);
    EXPECT_NEAR(outlineRounding(pole(8.0), north(), 31, 31),
                4e-7 * 32 * glm::length(Vec3(1.0, 1.0, 1.0 / 64)), 1e-7);
    EXPECT_EQ(outlineRounding(pole(0.001), north(), 31, 31), 1.0 / 128) << "never more";
    EXPECT_EQ(outlineRounding(pole(8.0), north(), 5, 5), 0.0) << "it is elsewhere";
    EXPECT_EQ(outlineRounding({}, north(), 31, 31), 0.0);
}

} // namespace
} // namespace limen::check
