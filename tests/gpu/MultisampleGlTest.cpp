#include "GlFixture.h"

#include "frame/IdColour.h"

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

} // namespace
} // namespace limen::gpu::test
