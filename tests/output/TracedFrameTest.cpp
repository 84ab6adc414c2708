#include "output/TracedFrame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limen::output {
namespace {

/// 2 × 2 pixels, 90 degrees: a wall 3 m ahead on the left, sky on the upper right, a hole on the lower right.
TracedFrame smallFrame() {
    TracedFrame frame;
    engine::FrameRequest eye;
    eye.camera.fovDegrees = 90.0;
    eye.size = {2, 2};
    frame.camera = tracedCamera(eye);
    frame.camera.place = Vec2(0.0); // centres, for round numbers
    frame.picture.width = frame.picture.height = 2;
    frame.picture.answers.resize(16);
    const auto set = [&](std::size_t column, std::size_t row, std::uint32_t id, double t) {
        frame.picture.answers[row * 4 + column].id = id;
        frame.picture.answers[row * 4 + column].t = t;
    };
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            if (column < 2)
                set(column, row, 7, 3.0);
            else if (row < 2)
                set(column, row, engine::kSkyPixel, std::numeric_limits<double>::infinity());
            else
                set(column, row, engine::kVoidPixel, std::numeric_limits<double>::quiet_NaN());
    }
    return frame;
}

TEST(TracedFrame, theCameraIsTheDrawnOnes) {
    engine::FrameRequest eye;
    eye.camera = {{1, 2, 3}, {90, 0}, 60};
    eye.size = {320, 180};
    eye.root = 5;
    const reference::Camera camera = tracedCamera(eye);
    EXPECT_EQ(camera.eye, Vec3(1, 2, 3));
    EXPECT_EQ(camera.forward, Vec3(1, 0, 0));
    EXPECT_EQ(camera.right, Vec3(0, -1, 0));
    EXPECT_NEAR(camera.tanHalfY, std::tan(std::acos(-1.0) / 6.0), 1e-15);
    EXPECT_NEAR(camera.tanHalfX, camera.tanHalfY * 16.0 / 9.0, 1e-15);
    EXPECT_EQ(camera.root, 5u);
    const visibility::View view = engine::viewOf(eye.camera, eye.size, eye.root);
    for (const std::uint32_t row : {0u, 179u}) {
        // The ray's position on the flood's screen, -1..1, y up.
        const Vec3 passes = view.screenFromEye() * reference::rayThrough(camera, 17, row).direction;
        EXPECT_NEAR((passes.x / passes.z + 1.0) / 2.0 * 320.0, 17.5 + 7.0 / 4096.0, 1e-10);
        EXPECT_NEAR((1.0 - passes.y / passes.z) / 2.0 * 180.0, row + 0.5 - 3.0 / 4096.0, 1e-10);
    }
}

TEST(TracedFrame, imagesLeaveTheBorderOutAndDepthRunsAlongTheRay) {
    const TracedFrame frame = smallFrame();
    EXPECT_EQ(frame.ids(), (std::vector<std::uint32_t>{7, engine::kSkyPixel, 7, engine::kVoidPixel}));
    const std::vector<float> depth = frame.depth();
    ASSERT_EQ(depth.size(), 4u);
    EXPECT_NEAR(depth[0], 3.0 * std::sqrt(1.5), 1e-6) << "half a unit left and up for each ahead";
    EXPECT_TRUE(std::isinf(depth[1]) && depth[1] > 0);
    EXPECT_TRUE(std::isnan(depth[3]));
}

TEST(TracedFrame, thePaintingTellsIdsApartAndDarkensWhatIsSeenEdgeOn) {
    TracedFrame frame = smallFrame();
    const Picture squarely = frame.painting();
    EXPECT_NE(squarely.at(0, 0), squarely.at(1, 0));
    EXPECT_NE(squarely.at(1, 0), squarely.at(1, 1));
    // The same polygon is now a wall 1 m to the left, parallel to the view direction.
    for (std::size_t row = 0; row < 4; ++row) {
        frame.picture.answers[row * 4].t = 1.0 / 1.5; // the border
        frame.picture.answers[row * 4 + 1].t = 1.0 / 0.5;
    }
    const Picture slanting = frame.painting();
    const auto sum = [](const Rgb& c) { return int{c[0]} + c[1] + c[2]; };
    EXPECT_LT(sum(slanting.at(0, 0)), sum(squarely.at(0, 0)));
}

} // namespace
} // namespace limen::output
