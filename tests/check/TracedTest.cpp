#include "check/Traced.h"

#include "check/House.h"

#include <gtest/gtest.h>

namespace limen::check {
namespace {

/// Whether the near plane cuts the western wall on the ray straight at it, from this far.
bool isCutFrom(double metres) {
    static const test::House house;
    static TracedWorld traced(house.world);
    reference::Camera camera;
    camera.eye = house.at({90.0 + metres, 83, 11});
    camera.right = {0, 1, 0};
    camera.up = {0, 0, 1};
    camera.forward = {-1, 0, 0};
    camera.tanHalfX = camera.tanHalfY = 1.0;
    camera.width = camera.height = 1;
    camera.nearPlane = 0.02;
    camera.root = house.space(house.front);
    return ViewRetracer(traced, camera).isCutByNearPlane(0, 0);
}

TEST(Traced, aSurfaceInTheNearPlaneItselfIsCutByItAndNoneBeyond) {
    EXPECT_TRUE(isCutFrom(0.01));
    EXPECT_TRUE(isCutFrom(0.019999));
    EXPECT_TRUE(isCutFrom(0.020001)) << "floats may put it on either side";
    EXPECT_FALSE(isCutFrom(0.0201));
    EXPECT_FALSE(isCutFrom(1.0));
}

} // namespace
} // namespace limen::check
