#include "engine/Camera.h"
#include "engine/FrameRequest.h"
#include "play/FlyCamera.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace limen::engine {
namespace {

void expectNear(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Camera, yawZeroLooksNorthAndNinetyEast) {
    EXPECT_EQ(basisOf({0, 0}).forward, Vec3(0, 1, 0));
    EXPECT_EQ(basisOf({90, 0}).forward, Vec3(1, 0, 0));
    EXPECT_EQ(basisOf({180, 0}).forward, Vec3(0, -1, 0));
    EXPECT_EQ(basisOf({270, 0}).forward, Vec3(-1, 0, 0));
    EXPECT_EQ(basisOf({-90, 0}).forward, Vec3(-1, 0, 0));
    EXPECT_EQ(basisOf({0, 0}).right, Vec3(1, 0, 0));
    EXPECT_EQ(basisOf({90, 0}).right, Vec3(0, -1, 0));
}

TEST(Camera, pitchNinetyLooksStraightUpWithTheHeadTiltedBack) {
    EXPECT_EQ(basisOf({0, 90}).forward, Vec3(0, 0, 1));
    EXPECT_EQ(basisOf({0, 90}).up, Vec3(0, -1, 0));
    EXPECT_EQ(basisOf({0, -90}).forward, Vec3(0, 0, -1));
    EXPECT_EQ(basisOf({0, 0}).up, Vec3(0, 0, 1));
}

TEST(Camera, basisIsOrthonormalAndRightHandedAtAnyHeading) {
    for (double yaw = -720.0; yaw < 720.0; yaw += 37.3) {
        for (double pitch = -90.0; pitch <= 90.0; pitch += 12.5) {
            const CameraBasis b = basisOf({yaw, pitch});
            EXPECT_NEAR(glm::length(b.right), 1.0, 1e-14);
            expectNear(glm::cross(b.right, b.forward), b.up, 1e-14);
            EXPECT_NEAR(glm::dot(b.forward, b.up), 0.0, 1e-14);
        }
    }
}

TEST(Camera, headingOfUndoesTheBasis) {
    for (double yaw = 0.0; yaw < 360.0; yaw += 31.0) {
        for (double pitch = -80.0; pitch <= 80.0; pitch += 20.0) {
            const Heading heading = headingOf(basisOf({yaw, pitch}).forward * 5.0);
            EXPECT_NEAR(heading.yaw, yaw, 1e-9);
            EXPECT_NEAR(heading.pitch, pitch, 1e-9);
        }
    }
    EXPECT_EQ(headingOf({0, 0, 3}).pitch, 90.0);
    EXPECT_EQ(headingOf({0, 0, 3}).yaw, 0.0);
}

TEST(Camera, fieldOfViewIsVerticalAndWidthFollowsThePictureShape) {
    Camera camera;
    camera.fovDegrees = 90.0;
    const visibility::View view = viewOf(camera, {200, 100}, 7);
    EXPECT_NEAR(view.tanHalfY, 1.0, 1e-12);
    EXPECT_NEAR(view.tanHalfX, 2.0, 1e-12);
    EXPECT_EQ(view.root, 7u);
}

TEST(FlyCamera, fliesAlongItsSightAndNoFasterSlantwise) {
    Camera camera;
    camera.heading = {90.0, 0.0};
    play::FlyInput input;
    input.forward = 1.0;
    input.seconds = 0.05;
    expectNear(play::fly(camera, input).eye, {play::kFlySpeed * 0.05, 0.0, 0.0});
    input.right = 1.0;
    EXPECT_NEAR(glm::length(play::fly(camera, input).eye), play::kFlySpeed * 0.05, 1e-12);
    input.fast = true;
    EXPECT_NEAR(glm::length(play::fly(camera, input).eye), play::kFlySpeed * play::kFlyFastFactor * 0.05,
                1e-12);
}

TEST(Camera, aScaledSizeIsRoundedAndHasAPixel) {
    EXPECT_EQ(scaledSize({1280, 720}, 100), (PixelSize{1280, 720}));
    EXPECT_EQ(scaledSize({1280, 720}, 75), (PixelSize{960, 540}));
    EXPECT_EQ(scaledSize({321, 181}, 50), (PixelSize{161, 91}));
    EXPECT_EQ(scaledSize({1, 1}, 50), (PixelSize{1, 1}));
}

TEST(Camera, aScaledRequestHasTheSameViewToTheBit) {
    FrameRequest request, scaled;
    request.camera = {{1.5, 2.5, 3.5}, {37.0, -4.0}, 71.0};
    request.size = {1279, 719};
    for (std::uint32_t percent = 50; percent <= 100; ++percent) {
        scaleRequest(request, percent, scaled);
        EXPECT_EQ(scaled.size, scaledSize(request.size, percent));
        const visibility::View whole = viewOf(request.camera, request.size, 0);
        const visibility::View small = viewOf(scaled.camera, scaled.size, 0);
        EXPECT_EQ(small.tanHalfX, whole.tanHalfX);
        EXPECT_EQ(small.tanHalfY, whole.tanHalfY);
        EXPECT_EQ(tracedCamera(scaled).tanHalfX, whole.tanHalfX);
        EXPECT_EQ(tracedCamera(scaled).width, scaled.size.width);
        EXPECT_EQ(scaled.levels, world::levelShareOf(percent));
    }
    scaleRequest(scaled, 50, scaled); // scaled twice, it keeps the first shape
    EXPECT_EQ(viewOf(scaled.camera, scaled.size, 0).tanHalfX,
              viewOf(request.camera, request.size, 0).tanHalfX);
}

TEST(FlyCamera, staysWithinItsLimits) {
    play::FlyInput input;
    input.turnUp = 500.0;
    input.turnRight = -30.0;
    const Camera turned = play::fly(Camera{}, input);
    EXPECT_LT(turned.heading.pitch, 90.0);
    EXPECT_NEAR(turned.heading.yaw, 330.0, 1e-12);
    play::FlyInput stall;
    stall.forward = 1.0;
    stall.seconds = 100.0;
    EXPECT_LE(glm::length(play::fly(Camera{}, stall).eye), play::kFlySpeed * play::kMaxFrameSeconds + 1e-12);
    EXPECT_EQ(play::fly(Camera{}, play::FlyInput{}).eye, Vec3(0.0));
}

TEST(FlyCamera, case27_doesNotMoveABitWhileNobodyTouchesIt) {
    Camera camera;
    camera.eye = {8123.4567890123, 9345.6789012345, 4.7000000001};
    camera.heading = {359.99999999999, -88.7};
    Camera later = play::fly(camera, {.forward = 0.3, .right = -0.2, .turnRight = 1.7, .seconds = 0.016});
    const Camera still = later;
    for (int frame = 0; frame < 1000; ++frame)
        later = play::fly(later, {.seconds = 0.016 + frame * 1e-5});
    EXPECT_EQ(later.eye, still.eye);
    EXPECT_EQ(later.heading.yaw, still.heading.yaw);
    EXPECT_EQ(later.heading.pitch, still.heading.pitch);
}

} // namespace
} // namespace limen::engine
