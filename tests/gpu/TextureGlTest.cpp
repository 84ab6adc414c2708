#include "GlFixture.h"

#include <random>
#include <set>

namespace limen::gpu::test {
namespace {

// Textures of several sizes and both wrapping modes, on slanted quads that need every mip level, in one draw;
// half of them cut-outs; and a landcell.
SceneBuilder manyTextures() {
    SceneBuilder scene;
    scene.root(0);
    std::mt19937 random(7);
    const std::array<glm::uvec2, 5> sizes{glm::uvec2{1, 1}, {4, 4}, {64, 32}, {37, 5}, {16, 128}};
    for (std::uint32_t i = 0; i < 20; ++i) {
        const glm::uvec2 size = sizes[i % sizes.size()];
        std::vector<std::uint8_t> rgba(std::size_t{size.x} * size.y * 4);
        for (std::uint8_t& byte : rgba)
            byte = static_cast<std::uint8_t>(random());
        QuadOptions options;
        options.material =
            scene.addMaterial({1, 1, 1, 1}, scene.addTexture(size.x, size.y, rgba, i % 2 == 0));
        options.program = i % 4 < 2 ? frame::Program::Opaque : frame::Program::CutOut;
        options.gated = i % 3 == 0;
        const float s = 3.0f;
        options.uv = {glm::vec2{-s, s}, {s, s}, {s, -s}, {-s, -s}};
        const float x = static_cast<float>(i % 5) - 2.5f, z = static_cast<float>(i / 5) - 2.0f;
        scene.addQuad('A' + i, {glm::vec3{x, 2, z}, {x + 1, 2.5f, z}, {x + 1, 9, z + 1}, {x, 5, z + 1}},
                      options);
    }
    layout::TerrainCell cell{{2, layout::kNoTexture, 0, 3.0f}, {}, {}};
    for (std::uint32_t i = 0; i < 3; ++i)
        cell.overlays[i] = {i, 3 + i, i, 2.0f};
    for (std::uint32_t i = 0; i < 2; ++i)
        cell.roads[i] = {9, 7 + i, i + 2, 1.0f};
    scene.upload.terrainCells.push_back(cell);
    scene.addQuad('a', {glm::vec3{-9, 1, -1}, {9, 1, -1}, {9, 30, -0.5f}, {-9, 30, -0.5f}},
                  {.program = frame::Program::Terrain});
    return scene;
}

class TextureGlTest : public GlTest {};

TEST_F(TextureGlTest, bindlessAndArrayPagesGiveTheSameImage) {
    if (!device_->capabilities().bindless)
        GTEST_SKIP() << "no GL_ARB_bindless_texture on " << device_->capabilities().renderer;
    SceneBuilder scene = manyTextures();
    const Frame pages = render(scene, 128, {.textures = {.mode = TextureMode::ArrayPages}});
    const Frame bindless = render(scene, 128, {.textures = {.mode = TextureMode::Bindless}});
    EXPECT_EQ(pages.colour, bindless.colour);
    EXPECT_EQ(pages.ids, bindless.ids);
    EXPECT_EQ(pages.depth, bindless.depth);
}

// On software drivers; on others both are the same.
TEST_F(TextureGlTest, pagesChosenByIndexAndByConstantGiveTheSameImage) {
    SceneBuilder scene = manyTextures();
    scene.plan.constants.flags = layout::kFrameExactCutOuts;
    for (const bool exact : {false, true}) {
        scene.plan.constants.flags = exact ? layout::kFrameExactCutOuts : 0;
        const Frame byConstant =
            render(scene, 128, {.textures = {.mode = TextureMode::ArrayPages, .pagesByIndex = false}});
        const Frame byIndex = render(scene, 128, {.textures = {.mode = TextureMode::ArrayPages}});
        EXPECT_EQ(byConstant.colour, byIndex.colour);
        EXPECT_EQ(byConstant.ids, byIndex.ids);
        EXPECT_EQ(byConstant.depth, byIndex.depth);
    }
}

// On software drivers; on others both are the same. Drivers differ in the distance at which they take the next level, and in
// the last bits of a filter.
TEST_F(TextureGlTest, atlasAndPagesGiveNearlyTheSameImage) {
    SceneBuilder scene = manyTextures();
    for (const bool exact : {false, true}) {
        scene.plan.constants.flags = exact ? layout::kFrameExactCutOuts : 0;
        RendererOptions options{.drawing = Drawing::Fast};
        options.textures.mode = TextureMode::ArrayPages;
        const Frame atlas = render(scene, 128, options);
        options.textures.atlas = false;
        const Frame pages = render(scene, 128, options);
        EXPECT_GT(std::set<std::uint32_t>(pages.ids.begin(), pages.ids.end()).size(), 12u);
        if (exact)
            EXPECT_EQ(atlas.ids, pages.ids);
        std::size_t others = 0;
        for (std::size_t i = 0; i < pages.colour.size(); ++i)
            others += std::abs(int{atlas.colour[i]} - int{pages.colour[i]}) > 3 ? 1 : 0;
        EXPECT_LT(others, pages.colour.size() / 20);
    }
}

// The eye looks straight ahead over the edge of a floor. Corners of depth 0 have no position in the window,
// and the triangle is drawn as one around the window. Its texture is still in the right place.
TEST_F(TextureGlTest, liesInPlaceOnAFloorWhoseCornersAreBeneathTheEye) {
    constexpr std::uint32_t kTexels = 64, kSize = 32;
    constexpr double kHalf = 4.0, kLength = 8.0, kBelow = 1.0; // metres
    std::vector<std::uint8_t> ramp;
    for (std::uint32_t row = 0; row < kTexels; ++row) {
        for (std::uint32_t column = 0; column < kTexels; ++column) {
            ramp.insert(ramp.end(),
                        {static_cast<std::uint8_t>(4 * column), static_cast<std::uint8_t>(4 * row), 0, 255});
        }
    }
    SceneBuilder scene;
    scene.root(0);
    QuadOptions options;
    options.material = scene.addMaterial({1, 1, 1, 1}, scene.addTexture(kTexels, kTexels, ramp));
    scene.addQuad('F',
                  {glm::vec3{-kHalf, 0, -kBelow},
                   {kHalf, 0, -kBelow},
                   {kHalf, kLength, -kBelow},
                   {-kHalf, kLength, -kBelow}},
                  options);
    const Frame frame = render(scene, kSize);
    std::size_t compared = 0;
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            if (frame.ids[y * kSize + x] != 'F')
                continue;
            const double right = (x + 0.5) / (kSize / 2) - 1.0, down = (y + 0.5) / (kSize / 2) - 1.0;
            const double along = kBelow / down; // metres ahead
            if (along > kLength / 3)
                continue; // mip levels of the ramp end at its edges
            const double u = (right * along + kHalf) / (2 * kHalf), v = 1.0 - along / kLength;
            EXPECT_NEAR(frame.at(x, y).x, 4.0 * (u * kTexels - 0.5), 6.0) << x << ", " << y;
            EXPECT_NEAR(frame.at(x, y).y, 4.0 * (v * kTexels - 0.5), 6.0) << x << ", " << y;
            ++compared;
        }
    }
    EXPECT_GT(compared, kSize * kSize / 5);
}

TEST_F(TextureGlTest, drawsAreAsIfEachHadItsTextureAlone) {
    // The same quads, each in a scene with one texture: the result with a single page and no divergence.
    SceneBuilder all = manyTextures();
    const Frame together = render(all, 64);
    std::size_t compared = 0;
    for (std::uint32_t i = 0; i < 20; i += 3) { // all sizes, both wrapping modes, all programs
        SceneBuilder alone = manyTextures();
        const frame::TextureUpload kept = alone.upload.textures[i];
        alone.upload.textures = {kept};
        alone.upload.terrainCells.clear();
        for (layout::Material& material : alone.upload.materials)
            material.texture = material.texture == i ? 0 : layout::kNoTexture;
        alone.upload.terrainCells.push_back({{layout::kNoTexture, 0, 0, 1}, {}, {}});
        for (layout::TerrainLayer& layer : alone.upload.terrainCells[0].overlays)
            layer.texture = layer.alpha = layout::kNoTexture;
        for (layout::TerrainLayer& layer : alone.upload.terrainCells[0].roads)
            layer.texture = layer.alpha = layout::kNoTexture;
        alone.upload.terrainCells[0].base.alpha = layout::kNoTexture;
        const Frame frame = render(alone, 64);
        for (std::size_t p = 0; p < frame.ids.size(); ++p) {
            if (together.ids[p] == 'A' + i && frame.ids[p] == 'A' + i) {
                EXPECT_TRUE(
                    std::equal(&frame.colour[4 * p], &frame.colour[4 * p] + 4, &together.colour[4 * p]));
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 100u);
}

TEST_F(TextureGlTest, fewPages_keepExactCutOutsAndReportResampledTextures) {
    const auto draw = [this](std::uint32_t pageLimit, DriverReport& report) {
        SceneBuilder scene;
        scene.root(0);
        scene.plan.constants.flags = layout::kFrameExactCutOuts;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t size = 8u << i;
            std::vector<std::uint8_t> rgba;
            for (std::uint32_t t = 0; t < size * size; ++t)
                rgba.insert(
                    rgba.end(),
                    {255, 255, 255, static_cast<std::uint8_t>((t * 7 + t / size * 5) % 3 == 0 ? 255 : 0)});
            const std::uint32_t material =
                scene.addMaterial({1, 1, 1, 1}, scene.addTexture(size, size, rgba));
            const float x = static_cast<float>(i) - 1.5f;
            scene.addWall('A' + i, {x, -1.5f}, {x + 1, 1.5f}, 1.7f,
                          {.material = material, .program = frame::Program::CutOut});
        }
        Renderer renderer(*device_, {.textures = {.mode = TextureMode::ArrayPages, .pageLimit = pageLimit}});
        EXPECT_TRUE(renderer.upload(scene.upload));
        report = renderer.driver();
        return renderWith(renderer, scene.finish(), 61, 61);
    };
    DriverReport enough, few;
    const Frame full = draw(0, enough);
    const Frame limited = draw(2, few);
    EXPECT_EQ(enough.pages, 3u);
    EXPECT_EQ(enough.resampledTextures, 0u);
    EXPECT_EQ(few.pages, 2u);
    EXPECT_EQ(few.resampledTextures, 1u);
    EXPECT_EQ(full.ids, limited.ids);
}

TEST_F(TextureGlTest, wrappingIsTheTexturesOwn) {
    for (const bool clamp : {true, false}) {
        SceneBuilder scene;
        scene.root(0);
        const std::uint32_t texture = scene.addTexture(2, 1, {255, 0, 0, 255, 0, 255, 0, 255}, clamp);
        QuadOptions options{.material = scene.addMaterial({1, 1, 1, 1}, texture)};
        options.uv = {glm::vec2{0, 1}, {2, 1}, {2, 0}, {0, 0}};
        scene.addWall('A', {-1, -1}, {1, 1}, 1, options);
        const Frame frame = render(scene, 4);
        EXPECT_EQ(frame.at(0, 1), glm::ivec3(255, 0, 0));
        EXPECT_EQ(frame.at(1, 1), glm::ivec3(0, 255, 0));
        EXPECT_EQ(frame.at(2, 1), clamp ? glm::ivec3(0, 255, 0) : glm::ivec3(255, 0, 0));
    }
}

TEST_F(TextureGlTest, uploadAgain_replacesTheScene) {
    Renderer renderer(*device_);
    for (const std::uint8_t level : std::initializer_list<std::uint8_t>{50, 100}) {
        SceneBuilder scene;
        scene.root(0);
        const std::uint32_t texture = scene.addTexture(1, 1, {level, level, level, 255});
        scene.addWall('A', {-1, -1}, {1, 1}, 1, {.material = scene.addMaterial({1, 1, 1, 1}, texture)});
        ASSERT_TRUE(renderer.upload(scene.upload));
        EXPECT_EQ(renderWith(renderer, scene.finish(), 2, 2).at(0, 0), glm::ivec3(level));
    }
}

} // namespace
} // namespace limen::gpu::test
