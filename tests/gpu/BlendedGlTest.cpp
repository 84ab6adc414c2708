#include "GlFixture.h"

#include <gmock/gmock.h>

namespace limen::gpu::test {
namespace {

using ::testing::ElementsAre;

// A grey wall 2 m north; a transparent surface over the left half, 1 m north.
class BlendedGlTest : public GlTest {
protected:
    Frame drawOver(std::uint32_t flags, std::uint8_t texelAlpha, float materialAlpha, bool gated = false) {
        SceneBuilder scene;
        scene.root(1);
        scene.addWall('A', {-2, -2}, {2, 2}, 2,
                      {.members = {{1, 0}}, .material = scene.addMaterial({0.4f, 0.4f, 0.4f, 1})});
        const std::uint32_t texture = scene.addTexture(1, 1, {255, 0, 0, texelAlpha});
        QuadOptions options{.members = {{1, 0}}, .program = frame::Program::Blended, .gated = gated};
        options.material = scene.addMaterial({1, 1, 1, materialAlpha}, texture, flags);
        scene.addWall('B', {-1, -1}, {0, 1}, 1, options);
        return render(scene, 2);
    }
};

TEST_F(BlendedGlTest, alphaCoversByItsAlpha) {
    const Frame frame = drawOver(layout::kMaterialAlpha, 204, 0.5f); // 0.4 of red over 0.4 grey
    EXPECT_EQ(frame.at(0, 0), glm::ivec3(163, 61, 61));
    EXPECT_EQ(frame.at(1, 0), glm::ivec3(102));
    EXPECT_THAT(frame.picture(), ElementsAre("AA", "AA")) << "no id";
    EXPECT_FLOAT_EQ(frame.depth[0], frame.depth[1]) << "no depth";
}

TEST_F(BlendedGlTest, additiveAddsItsWholeColour_orItsAlphaOfItWithTheAlphaBit) {
    EXPECT_EQ(drawOver(layout::kMaterialAdditive, 51, 0.4f).at(0, 0), glm::ivec3(204, 102, 102));
    const std::uint32_t both = layout::kMaterialAdditive | layout::kMaterialAlpha;
    EXPECT_EQ(drawOver(both, 51, 1.0f).at(0, 0), glm::ivec3(153, 102, 102));
}

TEST_F(BlendedGlTest, inverseAlphaCoversByOneMinusAlpha) {
    EXPECT_EQ(drawOver(layout::kMaterialInvAlpha, 153, 1.0f).at(0, 0), glm::ivec3(163, 61, 61));
}

TEST_F(BlendedGlTest, gatedVariantIsTheSameWithOneVisit) {
    EXPECT_EQ(drawOver(layout::kMaterialAlpha, 128, 1, true).colour,
              drawOver(layout::kMaterialAlpha, 128, 1, false).colour);
}

TEST_F(BlendedGlTest, hiddenBehindSolidSurfacesAndOutsideItsZone) {
    SceneBuilder scene;
    scene.root(1);
    scene.addWall('A', {-2, -2}, {2, 2}, 2, {.members = {{1, 0}}});
    QuadOptions options{.members = {{1, 0}}, .program = frame::Program::Blended, .gated = true};
    options.material = scene.addMaterial({1, 0, 0, 1});
    scene.addWall('B', {-3, -3}, {3, 3}, 3, options); // behind
    options.members = {{2, 0}};
    scene.addWall('C', {-1, -1}, {1, 1}, 1, options); // nearer, in a zone that no ray visits
    EXPECT_EQ(render(scene, 2).at(1, 1), glm::ivec3(255));
}

// A split surface 1 m north, drawn both ways; behind it a green veil that is listed after it, so sorted
// wrongly.
class SplitGlTest : public GlTest {
protected:
    Frame drawn(std::uint8_t texelAlpha, const RenderOptions& options, float opacity = 1.0f) {
        SceneBuilder scene;
        scene.root(1);
        scene.addWall('A', {-2, -2}, {2, 2}, 2,
                      {.members = {{1, 0}}, .material = scene.addMaterial({0.4f, 0.4f, 0.4f, 1})});
        const std::uint32_t texture = scene.addTexture(1, 1, {255, 0, 0, texelAlpha});
        QuadOptions quad{.members = {{1, 0}}, .program = frame::Program::Blended};
        quad.material =
            scene.addMaterial({1, 1, 1, 1}, texture, layout::kMaterialAlpha | layout::kMaterialSplit);
        const std::uint32_t split = scene.addWall('B', {-1, -1}, {0, 1}, 1, quad);
        scene.upload.instances[split].opacity = opacity;
        scene.drawAgain(split, frame::Program::CutOut, false);
        quad.material = scene.addMaterial({0, 1, 0, 0.5f}, layout::kNoTexture, layout::kMaterialAlpha);
        scene.addWall('C', {-1.5f, -1.5f}, {0, 1.5f}, 1.5f, quad);
        Renderer renderer(*device_);
        EXPECT_TRUE(renderer.upload(scene.upload));
        return renderWith(renderer, scene.finish(), 2, 2, options);
    }
    static constexpr RenderOptions kPainted{.wantIds = false}, kWithIds{};
};

TEST_F(SplitGlTest, hidesSurfacesBehindWhereNearlyOpaque) {
    EXPECT_EQ(drawn(250, kPainted).at(0, 0), glm::ivec3(255, 0, 0));
}

TEST_F(SplitGlTest, hasNoIdAndNoDepthAtAnyAlpha) {
    const Frame frame = drawn(250, kWithIds);
    EXPECT_THAT(frame.picture(), ElementsAre("AA", "AA"));
    EXPECT_FLOAT_EQ(frame.depth[0], frame.depth[1]);
    EXPECT_NEAR(frame.at(0, 0).y, 128, 2) << "blended in the order of the list, the veil last";
}

TEST_F(SplitGlTest, isBlendedOnceElsewhere) {
    for (const std::uint8_t alpha : {std::uint8_t{20}, std::uint8_t{128}, std::uint8_t{235}})
        EXPECT_EQ(drawn(alpha, kPainted).at(0, 0), drawn(alpha, kWithIds).at(0, 0)) << int{alpha};
    EXPECT_EQ(drawn(255, kPainted, 0.5f).at(0, 0), drawn(255, kWithIds, 0.5f).at(0, 0))
        << "it fades as a whole";
}

TEST_F(SplitGlTest, isSkippedWhereNearlyTransparent) {
    EXPECT_EQ(drawn(10, kPainted).at(0, 0), drawn(0, kWithIds).at(0, 0));
    EXPECT_NE(drawn(10, kWithIds).at(0, 0), drawn(0, kWithIds).at(0, 0));
}

} // namespace
} // namespace limen::gpu::test
