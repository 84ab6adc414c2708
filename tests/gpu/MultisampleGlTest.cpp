#include "GlFixture.h"

#include "frame/IdColour.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace limen::gpu::test {
namespace {

class MultisampleGlTest : public GlTest {
protected:
    Frame draw(SceneBuilder& scene, std::uint32_t size, Shading shading = Shading::FlatIds) {
        Renderer renderer(*device_);
        EXPECT_TRUE(renderer.upload(scene.upload));
        return draw(renderer, scene.finish(), size, shading);
    }
    Frame draw(Renderer& renderer, const frame::FramePlan& plan, std::uint32_t size,
               Shading shading = Shading::FlatIds) {
        Result<RenderTarget> target =
            RenderTarget::create(*device_, size, size, {.samples = layout::kSamples});
        EXPECT_TRUE(target) << target.error().message();
        EXPECT_TRUE(renderer.render(plan, *target, {.wantIds = false, .shading = shading}));
        Frame frame;
        frame.colour = target->readColour();
        frame.width = size;
        return frame;
    }
};

glm::ivec3 colourOf(std::uint32_t id) {
    const auto [r, g, b] = frame::colourOfId(id);
    return {r, g, b};
}

TEST_F(MultisampleGlTest, aSurfaceHasItsColour) {
    SceneBuilder scene;
    scene.root(1);
    scene.addWall('A', {-2, -2}, {2, 2}, 2, {.members = {{1, 0}}});
    const Frame frame = draw(scene, 4);
    EXPECT_EQ(frame.at(1, 1), colourOf('A'));
    EXPECT_EQ(draw(scene, 4, Shading::Lit).at(1, 1), glm::ivec3(255));
}

TEST_F(MultisampleGlTest, gatedByTheLeafVisitOfEachSample) {
    for (const std::uint32_t size : {8u, 64u, 200u}) {
        SceneBuilder scene;
        scene.root(1);
        scene.visitThrough({-1, -1}, {1.01f, 1.01f}, 2, 2, 0);
        scene.addWallWithOpening('A', 3, 1, 2, {.members = {{1, 0}}, .gated = true});
        scene.addWall('B', {-5, -5}, {5, 5}, 3, {.members = {{2, 0}}, .gated = true});
        const Frame frame = draw(scene, size);
        EXPECT_EQ(frame.at(0, 0), colourOf('A')) << size;
        EXPECT_EQ(frame.at(size / 2, size / 2), colourOf('B')) << size;
    }
}

// docs/cases.md 12: where the wall, the opening and the surfaces behind meet, no sample shows the clear
// colour, at any position of the edges between pixels.
TEST_F(MultisampleGlTest, noStripOfClearColourAlongAnOpening_atAnyAlignment) {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-1, -1}, {1, 1}, 2, 2, 0);
    scene.addWallWithOpening('A', 9, 1, 2, {.members = {{1, 0}}, .gated = true});
    scene.addWall('B', {-20, -20}, {20, 20}, 7, {.members = {{2, 0}}, .gated = true});
    scene.finish();
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    const glm::vec3 a = colourOf('A'), b = colourOf('B');
    std::size_t between = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 eye{static_cast<float>(i) * 0.00137f, -static_cast<float>(i % 37) * 0.003f,
                            static_cast<float>(i % 53) * 0.0029f};
        scene.plan.constants.eyeHigh = {eye, 0};
        scene.plan.visits[1].entryPlane = {0, 1, 0, eye.y - 2.0f};
        const Frame frame = draw(renderer, scene.plan, 40);
        for (std::uint32_t p = 0; p < 40 * 40; ++p) {
            // A mean of the two colours in quarters.
            const glm::vec3 drawn(frame.at(p % 40, p / 40));
            float best = 255;
            int quarters = 0;
            for (int k = 0; k <= 4; ++k) {
                const glm::vec3 off = glm::abs(drawn - glm::mix(a, b, static_cast<float>(k) / 4.0f));
                const float worst = std::max({off.x, off.y, off.z});
                quarters = worst < best ? k : quarters;
                best = std::min(best, worst);
            }
            ASSERT_LE(best, 1.0f) << "alignment " << i << " pixel " << p % 40 << "," << p / 40;
            between += quarters % 4 != 0 ? 1 : 0;
        }
    }
    EXPECT_GT(between, 400u * 20u) << "edges are smooth";
}

TEST_F(MultisampleGlTest, theSamePlanGivesTheSameBits) {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-1, -1}, {1.3f, 1.1f}, 2, 2, 0);
    scene.addWallWithOpening('A', 3, 1, 2, {.members = {{1, 0}}, .gated = true});
    scene.addWall('B', {-5, -5}, {5, 5}, 3, {.members = {{2, 0}}, .gated = true});
    EXPECT_EQ(draw(scene, 50).colour, draw(scene, 50).colour);
}

TEST_F(MultisampleGlTest, skyShowsInTheSamplesThatGotOutside) {
    SceneBuilder scene;
    scene.root(1);
    scene.visitThrough({-1, -1}, {1, 1}, 2, layout::kOutside, 0);
    scene.addWallWithOpening('A', 9, 1, 2, {.members = {{1, 0}}, .gated = true});
    const Frame frame = draw(scene, 18);
    EXPECT_EQ(frame.at(9, 9), colourOf(layout::kSkyId));
    EXPECT_EQ(frame.at(1, 9), colourOf('A'));
    const glm::vec3 edge(frame.at(4, 9)); // the opening's edge, x = -0.5 of the picture, halves this pixel
    const glm::vec3 half = (glm::vec3(colourOf('A')) + glm::vec3(colourOf(layout::kSkyId))) * 0.5f;
    EXPECT_LE(glm::length(edge - half), 2.0f);
}

TEST_F(MultisampleGlTest, samplesLieInsideThePixelAndApart) {
    Result<RenderTarget> target = RenderTarget::create(*device_, 4, 4, {.samples = layout::kSamples});
    ASSERT_TRUE(target);
    const std::vector<glm::vec2> samples = target->samplePositions();
    ASSERT_EQ(samples.size(), layout::kSamples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_LT(std::max(std::abs(samples[i].x), std::abs(samples[i].y)), 0.5f);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(glm::length(samples[i] - samples[j]), 0.2f);
    }
}

TEST_F(MultisampleGlTest, unsupportedSampleCountsAreRefusedInOneMessage) {
    const Result<RenderTarget> three = RenderTarget::create(*device_, 4, 4, {.samples = 3});
    ASSERT_FALSE(three);
    EXPECT_EQ(three.error().code, ErrorCode::BadArgument);
    Capabilities poor = device_->capabilities();
    poor.maxSamples = 1;
    const Result<void> refused = checkSamples(layout::kSamples, poor);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Driver);
    EXPECT_TRUE(checkSamples(1, poor));
}

} // namespace
} // namespace limen::gpu::test
