#include "viewer/photo/PhotoMode.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace limen::viewer {
namespace {

engine::FrameRequest someFrame() {
    engine::FrameRequest frame;
    frame.camera = {{10, 20, 30}, {45, -5}, 60.0};
    frame.scene.time = 0.3;
    frame.scene.seconds = 12.0;
    frame.scene.body = motion::PlayerBody{};
    frame.scene.body->opacity = 0.0;
    return frame;
}

double tanHalf(double degrees) {
    return std::tan(degrees * std::numbers::pi / 360.0);
}

TEST(PhotoMode, beginsWithTheFrameOnTheScreen) {
    const PhotoMode mode(someFrame());
    const engine::FrameRequest frame = mode.preview({640, 360});
    EXPECT_EQ(frame.camera.eye, Vec3(10, 20, 30));
    EXPECT_EQ(frame.camera.fovDegrees, 60.0);
    EXPECT_EQ(frame.scene.time, 0.3);
    EXPECT_EQ(frame.scene.seconds, 12.0);
    EXPECT_EQ(frame.scene.body->opacity, 0.0);
    EXPECT_EQ(frame.size, (engine::PixelSize{640, 360}));
    EXPECT_EQ(mode.picture({640, 360}).size, frame.size) << "as the window";
}

TEST(PhotoMode, changesNothingOfTheWorld) {
    const engine::FrameRequest world = someFrame();
    PhotoMode mode(world);
    PhotoSettings settings = mode.settings();
    settings.time = 0.9;
    settings.weather = engine::Weather::Rain;
    settings.fov = 90.0;
    settings.showsBody = true;
    mode.set(settings);
    const engine::FrameRequest taken = mode.picture({640, 360});
    EXPECT_EQ(taken.scene.time, 0.9);
    EXPECT_EQ(taken.scene.weather, engine::Weather::Rain);
    EXPECT_EQ(taken.camera.fovDegrees, 90.0);
    EXPECT_EQ(taken.scene.body->opacity, 1.0);
    const PhotoMode again(world); // the world's own frame is as it was
    EXPECT_EQ(again.picture({640, 360}).scene.time, 0.3);
    EXPECT_EQ(again.settings().weather, engine::Weather::Clear);
}

TEST(PhotoMode, settingsAreKeptWithinTheirRanges) {
    PhotoMode mode(someFrame());
    mode.set({.time = 7.0, .fov = 500.0, .size = 99, .supersample = 0});
    EXPECT_EQ(mode.settings().time, 1.0);
    EXPECT_EQ(mode.settings().fov, 120.0);
    EXPECT_EQ(mode.settings().size, kPhotoSizes.size() - 1);
    EXPECT_EQ(mode.settings().supersample, 1u);
}

TEST(PhotoMode, theWindowShowsTheWholePicture) {
    PhotoMode mode(someFrame());
    PhotoSettings settings = mode.settings();
    for (std::size_t size = 0; size < kPhotoSizes.size(); ++size) {
        settings.size = size;
        mode.set(settings);
        for (const engine::PixelSize window : {engine::PixelSize{640, 360}, {480, 640}, {1000, 200}}) {
            const engine::FrameRequest shown = mode.preview(window), taken = mode.picture(window);
            const Vec2 share = shownShare(taken.size, window);
            const double aspect = static_cast<double>(window.width) / window.height;
            const double pictureAspect = static_cast<double>(taken.size.width) / taken.size.height;
            // The picture's edges are at these shares of the window.
            EXPECT_NEAR(tanHalf(shown.camera.fovDegrees) * share.y, tanHalf(taken.camera.fovDegrees), 1e-9);
            EXPECT_NEAR(tanHalf(shown.camera.fovDegrees) * aspect * share.x,
                        tanHalf(taken.camera.fovDegrees) * pictureAspect, 1e-9);
        }
    }
}

} // namespace
} // namespace limen::viewer
