#include "output/Picture.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace limen::output {
namespace {

TEST(Picture, shrinkingTakesTheMeanAndKeepsProportions) {
    Picture picture(8, 4, {10, 20, 30});
    picture.set(0, 0, {250, 20, 30});
    const Picture small = shrunkToFit(picture, 4, 4);
    EXPECT_EQ(small.width, 4u);
    EXPECT_EQ(small.height, 2u);
    EXPECT_EQ(small.at(0, 0), (Rgb{70, 20, 30}));
    EXPECT_EQ(small.at(3, 1), (Rgb{10, 20, 30}));
    EXPECT_EQ(shrunkToFit(picture, 100, 100).width, 8u);
    EXPECT_EQ(shrunkToFit(Picture(1000, 1), 10, 10).height, 1u);
}

TEST(Picture, drawingOutsideDoesNothing) {
    Picture picture(4, 4);
    picture.set(-1, 0, {1, 1, 1});
    picture.set(4, 0, {1, 1, 1});
    drawLine(picture, -1e300, -1e300, -1e299, -1e300, {1, 1, 1});
    drawLine(picture, std::numeric_limits<double>::quiet_NaN(), 0, 1, 1, {1, 1, 1});
    drawText(picture, 100, 100, 3, "far \xC3\xA9", {1, 1, 1});
    EXPECT_EQ(picture.rgb, Picture(4, 4).rgb);
    drawLine(picture, 1, 2, 4, 2, {9, 9, 9});
    EXPECT_EQ(picture.at(2, 2), (Rgb{9, 9, 9}));
}

TEST(Picture, neighbouringNumbersGetColoursThatDiffer) {
    for (std::uint32_t n = 0; n < 200; ++n) {
        const Rgb a = distinctColour(n), b = distinctColour(n + 1);
        const int difference = std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
        EXPECT_GT(difference, 100) << n;
    }
}

TEST(ContactSheet, picksEvenlyWithFirstAndLast) {
    for (std::size_t frames : {1u, 2u, 7u, 12u, 13u, 40u, 400u}) {
        const ContactSheet sheet(frames, 12, 4, 100);
        std::size_t wanted = 0;
        for (std::size_t i = 0; i < frames; ++i)
            wanted += sheet.wants(i) ? 1 : 0;
        EXPECT_EQ(wanted, std::min<std::size_t>(frames, 12)) << frames;
        EXPECT_TRUE(sheet.wants(0) && sheet.wants(frames - 1)) << frames;
        EXPECT_FALSE(sheet.wants(frames));
    }
}

TEST(ContactSheet, laysTilesInRows) {
    ContactSheet sheet(3, 3, 2, 40);
    for (int i = 0; i < 3; ++i)
        sheet.add(Picture(80, 40, {200, static_cast<std::uint8_t>(i), 0}), "x");
    const Picture whole = sheet.compose();
    EXPECT_GT(whole.width, 80u);
    EXPECT_GT(whole.height, 40u);
    EXPECT_EQ(whole.at(6, 6)[0], 200);
    EXPECT_TRUE(ContactSheet(3, 3, 2, 40).compose().rgb.empty());
}

} // namespace
} // namespace limen::output
