#include "viewer/WindowGeometry.h"

#include <gtest/gtest.h>
#include <limits>

namespace limen::viewer {
namespace {

TEST(WindowGeometry, aCursorIsOverThePixelThatIsDrawnThere) {
    const WindowSizes usual{640, 360, {640, 360}, 1.0};
    EXPECT_EQ(pixelAt(usual, 0.0, 0.0), (PixelPlace{0, 0}));
    EXPECT_EQ(pixelAt(usual, 639.9, 359.0), (PixelPlace{639, 359}));
    const WindowSizes fine{640, 360, {1280, 720}, 2.0};
    EXPECT_EQ(pixelAt(fine, 639.5, 10.0), (PixelPlace{1279, 20}));
    const WindowSizes fraction{640, 360, {960, 540}, 1.5};
    EXPECT_EQ(pixelAt(fraction, 639.99, 359.99), (PixelPlace{959, 539}));
}

TEST(WindowGeometry, outsideOfTheWindowThereIsNone) {
    const WindowSizes sizes{640, 360, {640, 360}, 1.0};
    for (const auto& [x, y] : {std::pair(-0.1, 5.0), {5.0, -1.0}, {640.0, 5.0}, {5.0, 360.0}})
        EXPECT_FALSE(pixelAt(sizes, x, y)) << x << ' ' << y;
    EXPECT_FALSE(pixelAt(sizes, std::numeric_limits<double>::quiet_NaN(), 5.0));
    EXPECT_FALSE(pixelAt({0, 0, {1, 1}, 1.0}, 0.0, 0.0)) << "minimised";
}

TEST(WindowGeometry, lettersAreAsLargeAsTheScreenWantsThem) {
    EXPECT_EQ(uiScaleOf({640, 360, {640, 360}, 1.0}), (UiScale{1.0, 1.0}));
    EXPECT_EQ(uiScaleOf({640, 360, {640, 360}, 2.0}), (UiScale{2.0, 2.0})) << "X11: one unit is one pixel";
    EXPECT_EQ(uiScaleOf({640, 360, {1280, 720}, 2.0}), (UiScale{1.0, 2.0}))
        << "Wayland, macOS: one unit is several pixels";
    EXPECT_EQ(uiScaleOf({640, 360, {640, 360}, 0.0}), (UiScale{0.5, 0.5}));
    EXPECT_EQ(uiScaleOf({640, 360, {640, 360}, 1e9}), (UiScale{8.0, 8.0}));
    EXPECT_EQ(uiScaleOf({640, 360, {640, 360}, std::numeric_limits<double>::infinity()}),
              (UiScale{1.0, 1.0}));
    EXPECT_EQ(uiScaleOf({0, 0, {1, 1}, 1.0}), (UiScale{1.0, 1.0})) << "minimised";
}

} // namespace
} // namespace limen::viewer
