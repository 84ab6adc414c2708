#include "GlFixture.h"

namespace limen::gpu::test {
namespace {

class RingGlTest : public GlTest {
protected:
    // A wall of 4 x 4 pixels, and `visits` openings without a visible pixel, for arrays of any length.
    static SceneBuilder wallAndVisits(std::uint32_t visits) {
        SceneBuilder scene;
        scene.root(0);
        for (std::uint32_t i = 0; i < visits; ++i)
            scene.visitThrough({-50, -50}, {-40, -40}, 1, 7, 0);
        scene.addWall('A', {-0.5f, -0.5f}, {0.5f, 0.5f}, 1, {.gated = true});
        return scene;
    }
};

TEST_F(RingGlTest, growsWhenAFrameNeedsMoreAndDrawsTheSame) {
    Renderer renderer(*device_);
    SceneBuilder few = wallAndVisits(1), many = wallAndVisits(60'000);
    ASSERT_TRUE(renderer.upload(few.upload));
    const Frame before = renderWith(renderer, few.finish(), 8, 8);
    const std::uint32_t stalls = device_->ringStalls();
    const Frame large = renderWith(renderer, many.finish(), 8, 8);
    EXPECT_GT(device_->ringStalls(), stalls) << "growing is counted";
    const Frame after = renderWith(renderer, few.finish(), 8, 8);
    EXPECT_EQ(before.picture()[3], "~~AAAA~~");
    EXPECT_EQ(before.ids, large.ids);
    EXPECT_EQ(before.ids, after.ids);
}

TEST_F(RingGlTest, framesInFlightDoNotOverwriteEachOther) {
    // Ten frames into ten targets without waiting, each with a wall of its own, read back afterwards.
    Renderer renderer(*device_);
    SceneBuilder scene = wallAndVisits(1);
    ASSERT_TRUE(renderer.upload(scene.upload));
    std::vector<RenderTarget> targets;
    for (int i = 0; i < 10; ++i) {
        Result<RenderTarget> target = RenderTarget::create(*device_, 16, 16);
        ASSERT_TRUE(target);
        targets.push_back(std::move(*target));
        scene.plan.constants.eyeHigh.x = 0.1f * static_cast<float>(i);
        ASSERT_TRUE(renderer.render(scene.finish(), targets.back()));
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const std::vector<std::uint32_t> ids = targets[i].readIds();
        for (std::uint32_t x = 0; x < 16; ++x) {
            const double at = (x + 0.5) / 8 - 1 + 0.1f * static_cast<float>(i);
            EXPECT_EQ(ids[8 * 16 + x], std::abs(at) < 0.5 ? 'A' : layout::kSkyId)
                << "frame " << i << " column " << x;
        }
    }
}

} // namespace
} // namespace limen::gpu::test
