// Layouts of atlases, and the texels that they get.
#include "gpu/texture/AtlasStaging.h"

#include "SceneBuilder.h"
#include "gpu/device/NullDevice.h"
#include "gpu/texture/TextureStore.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>

namespace limen::gpu::test {
namespace {

constexpr std::uint32_t kLargestSide = 16384, kManyLayers = 2048;

MipLevel blankLayer(const AtlasLayout& layout) {
    return {layout.width, layout.height,
            std::vector<std::uint8_t>(std::size_t{layout.width} * layout.height * 4)};
}

std::array<std::uint8_t, 4> texelOf(const MipLevel& layer, std::uint32_t x, std::uint32_t y) {
    std::array<std::uint8_t, 4> texel{};
    std::copy_n(layer.rgba.begin() + (std::ptrdiff_t{y} * layer.width + x) * 4, 4, texel.begin());
    return texel;
}

std::vector<MipLevel> whiteLevels(const TextureClass& texture) {
    return mipChain(texture.width, texture.height,
                    std::vector<std::uint8_t>(std::size_t{texture.width} * texture.height * 4, 255));
}

/// A picture with a colour of its own for each texel.
std::vector<std::uint8_t> distinctTexels(std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint8_t> rgba;
    for (std::uint32_t i = 0; i < width * height; ++i)
        rgba.insert(rgba.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8), 7, 255});
    return rgba;
}

/// Texels of all levels and their borders.
std::size_t areaOf(const TextureClass& texture) {
    std::size_t area = 0;
    for (const MipLevel& level : whiteLevels(texture))
        area += std::size_t{level.width + 2} * (level.height + 2);
    return area;
}

/// Textures of a layout, with or without grains, that overlap cover less than the sum of their areas.
void expectDisjoint(std::vector<TextureClass> textures, const AtlasLayout& layout, bool hasGrains) {
    std::vector<AtlasSpot> spots = layout.spots;
    for (const AtlasSpot& spot : grainSpots()) {
        if (hasGrains) {
            spots.push_back(spot);
            textures.push_back({kGrainSide, kGrainSide, false});
        }
    }
    std::vector<MipLevel> layers(layout.layers, blankLayer(layout));
    std::size_t area = 0, covered = 0;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        ASSERT_LT(spots[i].layer, layout.layers);
        putIntoAtlas(whiteLevels(textures[i]), textures[i].clamp, spots[i], layers[spots[i].layer]);
        area += areaOf(textures[i]);
    }
    for (const MipLevel& layer : layers)
        for (std::size_t i = 0; i < layer.rgba.size(); i += 4)
            covered += layer.rgba[i] == 255 ? 1 : 0;
    EXPECT_EQ(covered, area);
}

TEST(Atlas, texturesOfAllSizesAndGrainsAreApart) {
    const std::vector<TextureClass> textures{{1, 1, false},    {256, 1, true}, {1, 256, true},
                                             {37, 5, false},   {5, 37, true},  {256, 256, true},
                                             {128, 64, false}, {2, 2, false}};
    for (const bool hasGrains : {false, true}) {
        const auto layout = layOutAtlas(textures, hasGrains, kLargestSide, kManyLayers);
        ASSERT_TRUE(layout);
        expectDisjoint(textures, *layout, hasGrains);
    }
}

RC_GTEST_PROP(Atlas, anyTexturesAreApart, ()) {
    const auto side = rc::gen::inRange<std::uint32_t>(1, 400);
    const auto sizes =
        *rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint32_t>>>(rc::gen::pair(side, side));
    RC_PRE(!sizes.empty() && sizes.size() < 12);
    std::vector<TextureClass> textures;
    for (const auto& [width, height] : sizes)
        textures.push_back({width, height, width % 2 == 0});
    const auto layout = layOutAtlas(textures, true, kLargestSide, kManyLayers);
    RC_ASSERT(layout.has_value());
    expectDisjoint(textures, *layout, true);
    RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(Atlas, programsSeldomDependOnTheTextures) {
    const auto few = layOutAtlas(std::vector<TextureClass>{{1, 1, false}}, false, kLargestSide, kManyLayers);
    const auto many =
        layOutAtlas(std::vector<TextureClass>(300, {512, 512, false}), true, kLargestSide, kManyLayers);
    ASSERT_TRUE(few && many);
    EXPECT_EQ(few->width, many->width);
    EXPECT_EQ(few->height, many->height);
    EXPECT_EQ(few->layers, 1u);
    EXPECT_GT(many->layers, 75u);
    EXPECT_EQ(few->width / 16 % 2, 1u) << "an odd number of cache lines";
}

TEST(Atlas, aLargeTextureMakesLayersLarger) {
    const auto layout =
        layOutAtlas(std::vector<TextureClass>{{2048, 2048, false}}, false, kLargestSide, kManyLayers);
    ASSERT_TRUE(layout);
    EXPECT_GE(layout->width, 2048u + 2 + 1024 + 2);
    EXPECT_GE(layout->height, 2048u + 2);
}

TEST(Atlas, noneIfTexturesDoNotFit) {
    const std::vector<TextureClass> large{{4096, 16, false}}, small{{16, 16, false}};
    EXPECT_FALSE(layOutAtlas(large, false, kLargestSide, kManyLayers));
    EXPECT_FALSE(layOutAtlas(small, false, 512, kManyLayers)) << "layers are larger than the driver's";
    EXPECT_FALSE(layOutAtlas(std::vector<TextureClass>(200, {512, 512, false}), false, kLargestSide, 20));
    EXPECT_FALSE(layOutAtlas({}, false, kLargestSide, kManyLayers));
}

TEST(Atlas, bordersRepeatOrClampEachLevel) {
    const std::vector<MipLevel> levels = mipChain(4, 2, distinctTexels(4, 2));
    for (const bool clamp : {false, true}) {
        MipLevel layer{32, 16, std::vector<std::uint8_t>(32 * 16 * 4)};
        const AtlasSpot spot{0, 3, 2};
        putIntoAtlas(levels, clamp, spot, layer);
        // Level 1 of two texels is beside level 0, level 2 below it.
        const std::array<std::pair<std::uint32_t, std::uint32_t>, 3> corners{
            std::pair{3u, 2u}, {3u + 4 + 2, 2u}, {3u + 4 + 2, 2u + 1 + 3}};
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const auto width = static_cast<int>(levels[i].width), height = static_cast<int>(levels[i].height);
            for (int y = -1; y <= height; ++y) {
                for (int x = -1; x <= width; ++x) {
                    const int u = clamp ? std::clamp(x, 0, width - 1) : (x + width) % width;
                    const int v = clamp ? std::clamp(y, 0, height - 1) : (y + height) % height;
                    EXPECT_EQ(
                        texelOf(layer, corners[i].first + static_cast<std::uint32_t>(x + 1),
                                corners[i].second + static_cast<std::uint32_t>(y + 1)),
                        texelOf(levels[i], static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v)))
                        << clamp << i << x << y;
                }
            }
        }
    }
}

/// Picture 0 is on the ground and on meshes, 1 on the ground, 2 on meshes, 3 is a grain.
class AtlasStagingTest : public ::testing::Test {
protected:
    AtlasStagingTest() {
        for (const std::uint32_t side : {8u, 16u, 32u, 4u})
            pictures_.push_back(
                {side, side, texels_.emplace_back(distinctTexels(side, side)), false, 100 + side});
        capabilities_.software = true;
    }
    StagedTextures staged(const std::vector<TextureContent>& before = {}) {
        const TextureUses uses{{0, 1}, {0, 2}, {layout::kNoTexture, 3}};
        Result<StagedTextures> result = stageTextures(pictures_, {}, capabilities_, before, &uses);
        EXPECT_TRUE(result);
        return std::move(*result);
    }
    std::deque<std::vector<std::uint8_t>> texels_;
    std::vector<frame::TextureUpload> pictures_;
    Capabilities capabilities_ = NullDevice::defaultCapabilities();
};

TEST_F(AtlasStagingTest, groundIsInPages_meshesAndGrainsInTheAtlas) {
    const StagedTextures textures = staged();
    ASSERT_TRUE(textures.hasAtlas());
    EXPECT_EQ(textures.paged, (std::vector<bool>{true, true, false, false}));
    EXPECT_TRUE(textures.inAtlas[0] && textures.inAtlas[2]);
    EXPECT_FALSE(textures.inAtlas[1] || textures.inAtlas[3]);
    EXPECT_EQ(textures.textures.size(), 3u) << "the atlas and pages of 8 and 16 texels";
    const std::vector<std::uint32_t> meshes{0, 2}, ground{0, 1};
    EXPECT_EQ(bindingFor(textures, ground).pages, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(bindingFor(textures, meshes).atlas, bindingFor(textures, ground).atlas);
    EXPECT_EQ(bindingFor(textures, meshes).atlas->page, 0u);
}

TEST_F(AtlasStagingTest, bothReferencesFindATextureOfGroundAndMeshes) {
    NullDevice device(capabilities_);
    TextureStore store(device, staged(), nullptr);
    std::size_t bytes = std::size_t{1} << 30;
    ASSERT_TRUE(store.advance(bytes));
    const StagedTextures textures = staged();
    const layout::uvec2 place = atlasPlace(textures.inAtlas[0]->stored, textures.inAtlas[0]->spot);
    EXPECT_EQ(store.refs()[0].place, glm::uvec4(place, 8, 8));
    EXPECT_EQ(store.pageRefs()[0].place,
              glm::uvec4(textures.locations[0].layer, textures.locations[0].page, 8, 8));
    EXPECT_EQ(store.pageRefs()[1].place, store.refs()[1].place);
    EXPECT_EQ(store.pages().size(), 3u);
}

TEST_F(AtlasStagingTest, grainIsEnlargedBetweenItsTexels_andItsOwnLevelsStay) {
    const StagedTextures textures = staged();
    const MipLevel& layer = textures.textures[0].layers[0][0];
    const std::uint32_t top = grainSpots()[1].y + 1;
    // In the middle of a texel of 64 x 64: its colour, to the half texel that the middle is off.
    for (const auto& [x, y] : {std::pair{0u, 0u}, {1u, 0u}, {3u, 3u}, {2u, 1u}})
        EXPECT_NEAR(texelOf(layer, 1 + 64 * x + 32, top + 64 * y + 32)[0], 4 * y + x, 1);
    EXPECT_NEAR(texelOf(layer, 1 + 64, top + 32)[0], 0.5, 0.6) << "between the first two";
    // Level 6, of four texels, is the picture: the levels 1 to 5 of 128 to 8 texels are above it.
    const std::uint32_t column = 1 + kGrainSide + 2, row = top + kGrainSide - (kGrainSide >> 5) + 3 * 5;
    for (std::uint32_t i = 0; i < 16; ++i)
        EXPECT_EQ(texelOf(layer, column + i % 4, row + i / 4)[0], i);
    EXPECT_EQ(texelOf(layer, 1, kNoGrainRow), (std::array<std::uint8_t, 4>{}));
}

TEST_F(AtlasStagingTest, isSharedWithAScenesEqualAtlasOnly) {
    std::vector<TextureContent> before;
    for (const StagedTexture& texture : staged().textures)
        before.push_back(texture.content);
    EXPECT_TRUE(staged(before).textures[0].isShared);
    EXPECT_TRUE(staged(before).textures[0].layers.empty());
    pictures_[3].contentKey = 999; // another grain
    EXPECT_FALSE(staged(before).textures[0].isShared);
    EXPECT_TRUE(staged(before).textures[1].isShared);
}

TEST_F(AtlasStagingTest, isNotSharedIfPicturesHaveOtherBordersOrPlaces) {
    std::vector<TextureContent> before;
    for (const StagedTexture& texture : staged().textures)
        before.push_back(texture.content);
    pictures_[2].clamp = true;
    EXPECT_FALSE(staged(before).textures[0].isShared) << "its borders are clamped";
    pictures_[2].clamp = false;
    const TextureUses uses{{0, 1}, {0, 2}, {3, layout::kNoTexture}};
    const Result<StagedTextures> moved = stageTextures(pictures_, {}, capabilities_, before, &uses);
    ASSERT_TRUE(moved);
    EXPECT_FALSE(moved->textures[0].isShared) << "the grain is of exteriors";
}

TEST_F(AtlasStagingTest, picturesThatDoNotFitAreInPages) {
    capabilities_.maxTextureSize = 1024;
    const StagedTextures textures = staged();
    EXPECT_FALSE(textures.hasAtlas());
    EXPECT_FALSE(bindingFor(textures, std::vector<std::uint32_t>{0}).atlas);
    EXPECT_EQ(textures.textures.size(), 4u);
}

} // namespace
} // namespace limen::gpu::test
