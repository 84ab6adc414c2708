#include "gpu/texture/PageLayout.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace limen::gpu {
namespace {

TEST(PageLayout, aPagePerSizeAndWrapping) {
    const std::vector<TextureClass> textures{{8, 8, false}, {8, 8, true}, {4, 8, false}, {8, 8, false}};
    const PageLayout layout = layOutPages(textures, 16, 2048);
    ASSERT_EQ(layout.pages.size(), 3u);
    EXPECT_EQ(layout.pages[0].layers, 2u);
    EXPECT_EQ(layout.locations[3].page, layout.locations[0].page);
    EXPECT_EQ(layout.locations[3].layer, 1u);
    EXPECT_EQ(layout.resampled, 0u);
}

TEST(PageLayout, noTextures_noPages) {
    EXPECT_TRUE(layOutPages({}, 2, 16).pages.empty());
}

TEST(PageLayout, tooManySizes_cheapestAreMerged) {
    // 64x64 into 128x128 adds 3 x 4096 texels; 8x8 into 64x64 fewer; 8x8 with 16x4 (16x8) fewest.
    const std::vector<TextureClass> textures{
        {128, 128, false}, {64, 64, false}, {8, 8, false}, {16, 4, false}};
    const PageLayout layout = layOutPages(textures, 3, 2048);
    ASSERT_EQ(layout.pages.size(), 3u);
    EXPECT_EQ(layout.pages[2].shape, (TextureClass{16, 8, false}));
    EXPECT_EQ(layout.resampled, 2u);
}

TEST(PageLayout, moreTexturesThanLayers_takeSeveralPages) {
    const std::vector<TextureClass> textures(7, TextureClass{4, 4, false});
    const PageLayout layout = layOutPages(textures, 3, 3);
    ASSERT_EQ(layout.pages.size(), 3u);
    EXPECT_EQ(layout.pages[2].layers, 1u);
    EXPECT_GT(layOutPages(textures, 2, 3).pages.size(), 2u) << "reports that it does not fit";
}

RC_GTEST_PROP(PageLayout, everyTextureHasALayerOfItsOwnAtLeastItsSize, (std::vector<std::uint8_t> seeds)) {
    std::vector<TextureClass> textures;
    for (const std::uint8_t seed : seeds)
        textures.push_back({1u << (seed % 7), 1u << (seed / 7 % 6), seed % 2 == 1});
    const auto maxPages = *rc::gen::inRange<std::uint32_t>(2, 9);
    const PageLayout layout = layOutPages(textures, maxPages, 64);
    RC_ASSERT(layout.locations.size() == textures.size());
    RC_ASSERT(layout.pages.size() <= maxPages || textures.size() > 64);
    std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const TextureLocation location = layout.locations[i];
        RC_ASSERT(location.page < layout.pages.size());
        const PageLayout::Page& page = layout.pages[location.page];
        RC_ASSERT(location.layer < page.layers && page.layers <= 64);
        RC_ASSERT(page.shape.width >= textures[i].width && page.shape.height >= textures[i].height);
        RC_ASSERT(page.shape.clamp == textures[i].clamp);
        RC_ASSERT(taken.insert({location.page, location.layer}).second);
    }
}

TEST(PageLayout, keepsExistingPages) {
    const TextureClass small{8, 8, false}, large{64, 64, false}, wide{64, 8, true};
    const std::vector<TextureClass> before{large, small}, pictures{small, wide, small, small};
    const PageLayout layout = layOutPages(pictures, 8, 2, before);
    ASSERT_EQ(layout.pages.size(), 4u);
    EXPECT_EQ(layout.pages[0].shape, large);
    EXPECT_EQ(layout.pages[0].layers, 0u) << "unused";
    EXPECT_EQ(layout.pages[1].shape, small);
    EXPECT_EQ(layout.pages[1].layers, 2u);
    EXPECT_EQ(layout.pages[2].shape, wide);
    EXPECT_EQ(layout.pages[3].shape, small) << "the first of its shape is full";
    EXPECT_EQ(layout.locations[3].page, 3u);
    EXPECT_EQ(layout.resampled, 0u);
}

TEST(PageLayout, startsOverWhenExistingPagesLeaveNoRoom) {
    const TextureClass small{8, 8, false}, large{64, 64, false}, wide{64, 8, false};
    const std::vector<TextureClass> before{large, wide}, pictures{small, small};
    const PageLayout layout = layOutPages(pictures, 2, 4, before);
    ASSERT_EQ(layout.pages.size(), 1u);
    EXPECT_EQ(layout.pages[0].shape, small);
}

} // namespace
} // namespace limen::gpu
