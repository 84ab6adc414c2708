#include "gpu/texture/MipChain.h"

#include <gmock/gmock.h>

namespace limen::gpu {
namespace {

using ::testing::ElementsAre;

TEST(MipChain, halvesDownToOneTexel) {
    const std::vector<MipLevel> levels = mipChain(37, 5, std::vector<std::uint8_t>(37 * 5 * 4, 9));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes;
    for (const MipLevel& level : levels) {
        sizes.emplace_back(level.width, level.height);
        EXPECT_THAT(level.rgba, ::testing::Each(9)) << "a plain colour stays";
        EXPECT_EQ(level.rgba.size(), std::size_t{level.width} * level.height * 4);
    }
    EXPECT_THAT(sizes, ElementsAre(std::pair(37u, 5u), std::pair(18u, 2u), std::pair(9u, 1u),
                                   std::pair(4u, 1u), std::pair(2u, 1u), std::pair(1u, 1u)));
    EXPECT_EQ(mipLevelCount(37, 5), levels.size());
    EXPECT_EQ(mipLevelCount(1, 1), 1u);
}

TEST(MipChain, texelIsTheMeanOfItsArea) {
    const std::vector<std::uint8_t> rgba{0, 10, 0, 255, 100, 20, 0, 255, 40, 30, 0, 255, 60, 40, 0, 255};
    EXPECT_THAT(mipChain(2, 2, rgba)[1].rgba, ElementsAre(50, 25, 0, 255));
}

TEST(MipChain, oddSize_takesTheLastColumnToo) {
    const std::vector<std::uint8_t> rgba{0, 0, 0, 255, 0, 0, 0, 255, 90, 0, 0, 255};
    EXPECT_THAT(mipChain(3, 1, rgba)[1].rgba, ElementsAre(30, 0, 0, 255));
}

TEST(MipChain, hiddenColoursDoNotBleed) {
    const std::vector<std::uint8_t> rgba{200, 100, 50, 255, 0, 0, 0, 0};
    EXPECT_THAT(mipChain(2, 1, rgba)[1].rgba, ElementsAre(200, 100, 50, 128));
}

TEST(Resized, keepsALevelOfTheSameSize) {
    const std::vector<MipLevel> levels = mipChain(4, 2, std::vector<std::uint8_t>(32, 80));
    for (const MipLevel& level : levels)
        EXPECT_EQ(resized(levels, level.width, level.height).rgba, level.rgba);
}

TEST(Resized, blendsNeighboursAcrossTheEdge) {
    const std::vector<std::uint8_t> rgba{0, 0, 0, 255, 80, 0, 0, 255};
    const MipLevel large =
        resized(mipChain(2, 1, rgba), 4, 1); // middles at -1/4, 1/4, 3/4 and 5/4 of the first middle
    EXPECT_THAT(large.rgba, ElementsAre(20, 0, 0, 255, 20, 0, 0, 255, 60, 0, 0, 255, 60, 0, 0, 255));
}

TEST(Enlarged, keepsSmallerMipsWhenTheSizeIsAMultiple) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 4 * 2 * 4; ++i)
        rgba.push_back(static_cast<std::uint8_t>(i * 7));
    const MipLevel large = enlarged(4, 2, rgba, 8, 8);
    EXPECT_EQ(mipChain(8, 8, large.rgba).back().rgba.size(), 4u);
    const MipLevel doubled = enlarged(4, 2, rgba, 8, 4);
    EXPECT_EQ(mipChain(8, 4, doubled.rgba)[1].rgba, rgba);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(large.rgba[(7 * 8 + 7) * 4 + i], rgba[(1 * 4 + 3) * 4 + i]);
}

} // namespace
} // namespace limen::gpu
