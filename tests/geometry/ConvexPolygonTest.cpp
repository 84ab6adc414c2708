#include "geometry/ConvexPolygon.h"

#include "geometry/Bounds.h"

#include <gtest/gtest.h>

namespace limen {
namespace {

const std::vector<Vec3> kUnitSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

double area(std::span<const Vec3> polygon) {
    return 0.5 * glm::length(newellNormal(polygon));
}

TEST(PlaneOf, pointsTowardsTheCounterClockwiseSide) {
    const Plane plane = planeOf(kUnitSquare);
    EXPECT_DOUBLE_EQ(plane.n.z, 1.0);
    EXPECT_DOUBLE_EQ(plane.signedDistance({5, 5, 2}), 2.0);
}

TEST(PlaneOf, isZeroForAPolygonWithoutArea) {
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_EQ(planeOf(line).n, Vec3(0.0));
    EXPECT_EQ(planeOf({}).n, Vec3(0.0));
}

TEST(ClipPolygon, keepsTheHalfInFrontAndItsWinding) {
    std::vector<Vec3> out;
    clipPolygon(kUnitSquare, {{1, 0, 0}, -0.25}, 0.0, out);
    EXPECT_NEAR(area(out), 0.75, 1e-15);
    EXPECT_GT(newellNormal(out).z, 0.0);
}

TEST(ClipPolygon, keepsVerticesOnThePlane) {
    std::vector<Vec3> out;
    clipPolygon(kUnitSquare, {{1, 0, 0}, 0.0}, 0.0, out);
    EXPECT_EQ(out.size(), 4u);
    clipPolygon(kUnitSquare, {{0, 0, 1}, 0.0}, 0.0, out);
    EXPECT_EQ(out.size(), 4u) << "a polygon in the plane is in front of it";
}

TEST(ClipPolygon, isEmptyBehindThePlaneAndForNoPolygon) {
    std::vector<Vec3> out{{1, 2, 3}};
    clipPolygon(kUnitSquare, {{0, 0, 1}, -1.0}, 0.0, out);
    EXPECT_TRUE(out.empty());
    clipPolygon({}, {{0, 0, 1}, 0.0}, 0.0, out);
    EXPECT_TRUE(out.empty());
}

TEST(ContainsProjection, acceptsTheEdgeAndTheTolerance) {
    const Vec3 up{0, 0, 1};
    EXPECT_TRUE(containsProjection(kUnitSquare, up, {0.5, 0.5, 7.0}, 0.0));
    EXPECT_TRUE(containsProjection(kUnitSquare, up, {1.0, 0.5, 0.0}, 0.0));
    EXPECT_TRUE(containsProjection(kUnitSquare, up, {1.05, 0.5, 0.0}, 0.1));
    EXPECT_FALSE(containsProjection(kUnitSquare, up, {1.05, 0.5, 0.0}, 0.01));
}

TEST(BoundingSphere, holdsEveryPoint) {
    const Sphere sphere = boundingSphere(kUnitSquare);
    for (const Vec3& p : kUnitSquare)
        EXPECT_LE(glm::length(p - sphere.centre), sphere.radius);
    EXPECT_LT(boundingSphere({}).radius, 0.0);
}

} // namespace
} // namespace limen
