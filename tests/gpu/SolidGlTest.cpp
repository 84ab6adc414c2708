#include "GlFixture.h"

#include <gmock/gmock.h>

#include <cmath>

namespace limen::gpu::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

class SolidGlTest : public GlTest {};

TEST_F(SolidGlTest, nothingDrawn_isVoid) {
    SceneBuilder scene;
    scene.root(1);
    const Frame frame = render(scene, 4);
    EXPECT_THAT(frame.ids, Each(layout::kVoidId));
    EXPECT_THAT(frame.depth, Each(0.0f));
    EXPECT_EQ(frame.at(1, 2), glm::ivec3(255, 0, 255));
}

TEST_F(SolidGlTest, readback_hasTheTopRowFirst) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-4, 0}, {0, 4}, 4); // upper left quarter
    EXPECT_THAT(render(scene, 4).picture(), ElementsAre("AA~~", "AA~~", "~~~~", "~~~~"));
}

TEST_F(SolidGlTest, nearerWins_inAnyOrder) {
    for (const bool nearFirst : {true, false}) {
        SceneBuilder scene;
        scene.root(0);
        const auto add = [&](bool near) {
            near ? scene.addWall('N', {-1, -1}, {1, 0}, 1) : scene.addWall('F', {-2, -2}, {2, 2}, 2);
        };
        add(nearFirst);
        add(!nearFirst);
        EXPECT_THAT(render(scene, 4).picture(), ElementsAre("FFFF", "FFFF", "NNNN", "NNNN"));
    }
}

TEST_F(SolidGlTest, backFacesAreNotMet) {
    SceneBuilder scene;
    scene.root(1);
    scene.addQuad('A', {glm::vec3{2, 2, -2}, {-2, 2, -2}, {-2, 2, 2}, {2, 2, 2}},
                  {.members = {{1, 0}}}); // faces north
    EXPECT_THAT(render(scene, 2).ids, Each(layout::kVoidId));
}

TEST_F(SolidGlTest, depthIsNearOverViewDepth) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-700, -700}, {0, 700}, 700);
    scene.addWall('B', {0, -3}, {3, 3}, 3);
    const Frame frame = render(scene, 4);
    EXPECT_NEAR(frame.depth[1] * 700.0 / 0.02, 1.0, 1e-5);
    EXPECT_NEAR(frame.depth[2] * 3.0 / 0.02, 1.0, 1e-5);
}

TEST_F(SolidGlTest, distances_areAlongTheRay) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-3, -3}, {3, 1.5f}, 3);
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    Result<RenderTarget> target = RenderTarget::create(*device_, 4, 4);
    ASSERT_TRUE(target);
    ASSERT_TRUE(renderer.render(scene.finish(), *target));
    const std::vector<float> distances = target->readDistances(scene.plan.constants);
    const double perPixel = 2.0 / 4.0; // at a distance of 1 m
    // pixel (3, 1) shows this point of the wall
    const double x = (0.75 + layout::kPixelPlace.x * perPixel) * 3;
    const double z = (0.25 - layout::kPixelPlace.y * perPixel) * 3;
    EXPECT_NEAR(distances[1 * 4 + 3] / std::sqrt(x * x + z * z + 9), 1.0, 1e-6);
    EXPECT_TRUE(std::isinf(distances[0]));
}

TEST_F(SolidGlTest, surfaceBeforeTheNearPlaneIsNotMet) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 0.019f);
    EXPECT_THAT(render(scene, 2).ids, Each(layout::kSkyId));
}

TEST_F(SolidGlTest, sameSceneAtAFarCornerGivesTheSameIdsAndDepth) {
    const auto draw = [this](glm::vec3 eye, glm::vec4 block) {
        SceneBuilder scene;
        scene.root(0);
        scene.plan.constants.eyeHigh = {eye, 0};
        scene.plan.blocks.push_back(block); // slot 1: a neighbour
        const glm::vec2 at{eye.x - block.x, eye.z};
        scene.addWall('A', at - 1.5f, at + glm::vec2{0.3f, 1.1f}, eye.y + 2 - block.y, {.block = 1});
        return render(scene, 16);
    };
    const Frame here = draw({0.5f, 0.25f, 1}, {0, 0, 0, 0});
    const Frame there = draw({191.5f, 191.25f, 1}, {192, 192, 0, 0});
    EXPECT_EQ(here.ids, there.ids);
    for (std::size_t i = 0; i < here.depth.size(); ++i)
        EXPECT_NEAR(here.depth[i], there.depth[i], 1e-6f);
}

TEST_F(SolidGlTest, modelRowsTurnScaleAndMove) {
    SceneBuilder scene;
    scene.root(0);
    QuadOptions options; // x and z swapped, scaled by 2, moved 1 m to the right and 2 m north
    options.rows = {glm::vec4{0, 0, -2, 1}, glm::vec4{0, 1, 0, 2}, glm::vec4{2, 0, 0, 0}};
    scene.addWall('A', {0, 0}, {0.5f, 0.5f}, 0, options); // x from 0 to 1, z from 0 to 1
    EXPECT_THAT(render(scene, 4).picture(), ElementsAre("~~~~", "~~A~", "~~~~", "~~~~"));
}

TEST_F(SolidGlTest, cutOut_countsATexelFromAlpha200On_orFrom100WithAPalette) {
    for (const std::uint32_t flags : {0u, layout::kFrameExactCutOuts}) {
        for (const bool indexed : {false, true}) {
            SceneBuilder scene;
            scene.root(0);
            scene.plan.constants.flags = flags;
            const std::uint8_t least = indexed ? 100 : 200, less = least - 1;
            std::vector<std::uint8_t> rgba;
            // Top left, top right, bottom left, bottom right.
            for (const std::uint8_t alpha : std::array<std::uint8_t, 4>{less, least, 255, 0})
                rgba.insert(rgba.end(), {255, 255, 255, alpha});
            const std::uint32_t material = scene.addMaterial({1, 1, 1, 1}, scene.addTexture(2, 2, rgba),
                                                             indexed ? layout::kMaterialIndexed : 0u);
            scene.addWall('A', {-2, -2}, {2, 2}, 2,
                          {.material = material, .program = frame::Program::CutOut});
            EXPECT_THAT(render(scene, 2).picture(), ElementsAre("~A", "A~"))
                << "flags " << flags << ", indexed " << indexed;
        }
    }
}

TEST_F(SolidGlTest, cutOut_countsFromOneHalfOnWhereAPixelCoversTwoTexels) {
    for (const std::uint32_t size : {2u, 4u}) {
        SceneBuilder scene;
        scene.root(0);
        std::vector<std::uint8_t> rgba;
        for (std::uint32_t i = 0; i < size * size; ++i)
            rgba.insert(rgba.end(), {255, 255, 255, 150});
        const std::uint32_t material = scene.addMaterial({1, 1, 1, 1}, scene.addTexture(size, size, rgba));
        scene.addWall('A', {-2, -2}, {2, 2}, 2, {.material = material, .program = frame::Program::CutOut});
        const std::string row = size == 2 ? "~~" : "AA";
        EXPECT_THAT(render(scene, 2).picture(), ElementsAre(row, row)) << size;
    }
}

TEST_F(SolidGlTest, exactCutOut_takesTheTexelAtMipZeroWhereFilteringWouldBlur) {
    SceneBuilder scene;
    scene.root(0);
    scene.plan.constants.flags = layout::kFrameExactCutOuts;
    std::vector<std::uint8_t> rgba; // every third column is solid: a third on average, below the threshold
    for (int i = 0; i < 12 * 12; ++i)
        rgba.insert(rgba.end(), {255, 255, 255, static_cast<std::uint8_t>(i % 3 == 1 ? 255 : 0)});
    const std::uint32_t material = scene.addMaterial({1, 1, 1, 1}, scene.addTexture(12, 12, rgba, false));
    scene.addWall('A', {-2, -2}, {2, 2}, 2, {.material = material, .program = frame::Program::CutOut});
    // Four pixels of three columns each; their centres are all in the middle column.
    EXPECT_THAT(render(scene, 4).picture(), ElementsAre("AAAA", "AAAA", "AAAA", "AAAA"));
}

TEST_F(SolidGlTest, twoRendersAreEqualToTheBit) {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-1, -1}, {1, 1}, 2, 2, 0);
    scene.addWallWithOpening('A', 3, 1, 2, {.members = {{1, 0}}, .gated = true});
    scene.addQuad('B', {glm::vec3{-9, 1, -2}, {9, 1, -2}, {9, 40, 3}, {-9, 40, 3}},
                  {.members = {{2, 0}}, .gated = true});
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    const frame::FramePlan& plan = scene.finish();
    const Frame first = renderWith(renderer, plan, 64, 48);
    for (int i = 0; i < 5; ++i) {
        const Frame again = renderWith(renderer, plan, 64, 48);
        EXPECT_EQ(first.ids, again.ids);
        EXPECT_EQ(first.depth, again.depth);
        EXPECT_EQ(first.colour, again.colour);
        EXPECT_EQ(first.ownership, again.ownership);
    }
}

// The programs without shells lack a step that only shells need.
TEST_F(SolidGlTest, programsWithoutShells_drawOtherSurfacesAlike) {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-1, -1}, {1, 1}, 2, 2, 0);
    const std::uint32_t texture =
        scene.addTexture(2, 2, {250, 0, 0, 255, 0, 250, 0, 0, 0, 0, 250, 255, 90, 80, 70, 255}, false);
    const std::uint32_t picture = scene.addMaterial({1, 1, 1, 1}, texture);
    scene.addWallWithOpening('A', 3, 1, 2, {.members = {{1, 0}}, .material = picture, .gated = true});
    scene.addQuad('B', {glm::vec3{-9, 1, -2}, {9, 1, -2}, {9, 40, 3}, {-9, 40, 3}},
                  {.members = {{2, 0}}, .material = picture, .gated = true});
    scene.addWall('c', {-1, -1}, {0, 1}, 1,
                  {.members = {{1, 0}}, .material = picture, .program = frame::Program::CutOut});
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    frame::FramePlan plan = scene.finish();
    const Frame with = renderWith(renderer, plan, 64, 48);
    for (frame::Batch& batch : plan.batches)
        batch.shells = false;
    const Frame without = renderWith(renderer, plan, 64, 48);
    EXPECT_EQ(with.ids, without.ids);
    EXPECT_EQ(with.depth, without.depth);
    EXPECT_EQ(with.colour, without.colour);
}

TEST_F(SolidGlTest, withoutIds_colourAndDepthAreTheSame) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 0}, 1, {.material = scene.addMaterial({0.2f, 0.4f, 0.6f, 1})});
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    const Frame with = renderWith(renderer, scene.finish(), 8, 8);
    const Frame without = renderWith(renderer, scene.finish(), 8, 8, {.wantIds = false});
    EXPECT_EQ(with.colour, without.colour);
    EXPECT_EQ(with.depth, without.depth);
}

} // namespace
} // namespace limen::gpu::test
