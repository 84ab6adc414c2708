#include "GlFixture.h"
#include "gpu/device/NullDevice.h"

namespace limen::gpu::test {
namespace {

constexpr std::uint32_t kBudget = 40; // GL calls per frame

class CallCountGlTest : public GlTest {
protected:
    // A scene with every program and variant, `copies` times, behind a row of `copies` openings.
    static SceneBuilder everything(std::uint32_t copies) {
        SceneBuilder scene;
        scene.root(1);
        scene.upload.terrainCells.resize(1);
        scene.upload.terrainCells[0].base = {layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
        for (layout::TerrainLayer* layer :
             {scene.upload.terrainCells[0].overlays, scene.upload.terrainCells[0].roads})
            layer[0].texture = layer[1].texture = layout::kNoTexture;
        scene.upload.terrainCells[0].overlays[2].texture = layout::kNoTexture;
        for (std::uint32_t i = 0; i < copies; ++i) {
            const float y = 2.0f + static_cast<float>(i);
            scene.visitThrough({-1, -1}, {1, 1}, y, i % 2 == 0 ? 0 : 1, i);
            for (const frame::Program program : {frame::Program::Opaque, frame::Program::CutOut,
                                                 frame::Program::Terrain, frame::Program::Blended}) {
                for (const bool gated : {false, true}) {
                    // a plan has a single list of these
                    if (program == frame::Program::Blended && !gated)
                        continue;
                    scene.addWall('A', {-1, -1}, {1, 1}, y,
                                  {.members = {{1, 0}, {0, 0}}, .program = program, .gated = gated});
                }
            }
            scene.addSky({-1, -1}, {1, 1}, 1, 0, 0.5f);
        }
        return scene;
    }
    std::vector<std::uint32_t> countCalls(Device& device, SceneBuilder& scene, int frames,
                                          std::uint32_t size) {
        Renderer renderer(device);
        const Result<void> uploaded = renderer.upload(scene.upload);
        EXPECT_TRUE(uploaded) << uploaded.error().message();
        Result<RenderTarget> target = RenderTarget::create(device, size, size);
        EXPECT_TRUE(target);
        const frame::FramePlan& plan = scene.finish(true);
        std::vector<std::uint32_t> counts;
        for (int i = 0; i < frames; ++i) {
            EXPECT_TRUE(renderer.render(plan, *target));
            counts.push_back(renderer.report().glCalls);
        }
        return counts;
    }
};

TEST_F(CallCountGlTest, everyStageTogetherStaysWithinTheBudget_forAnyDraws) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t copies : {0u, 1u, 3u, 40u}) {
        SceneBuilder scene = everything(copies);
        const std::vector<std::uint32_t> counts = countCalls(*device_, scene, 5, 8 + copies);
        all.insert(all.end(), counts.begin(), counts.end());
    }
    EXPECT_LE(all.front(), kBudget);
    RecordProperty("glCalls", static_cast<int>(all.front()));
    EXPECT_EQ(std::count(all.begin(), all.end(), all.front()), static_cast<std::ptrdiff_t>(all.size()))
        << "first frames, later frames, few draws and many make the same calls";
}

TEST_F(CallCountGlTest, framesThatMeasureStayWithinTheBudgetToo) {
    SceneBuilder scene = everything(3);
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    Result<RenderTarget> target = RenderTarget::create(*device_, 16, 16, {.layers = true});
    ASSERT_TRUE(target);
    for (const Shading shading : {Shading::Lit, Shading::FlatIds, Shading::IdsOnly}) {
        for (const bool layers : {true, false}) {
            ASSERT_TRUE(renderer.render(scene.finish(true), *target, {true, shading, layers}));
            EXPECT_LE(renderer.report().glCalls, kBudget);
        }
    }
}

TEST_F(CallCountGlTest, multisampledFramesStayWithinTheBudget_andNullDeviceCountsThemAlike) {
    SceneBuilder scene = everything(3);
    scene.finish(true);
    NullDevice null;
    Renderer real(*device_), recorded(null);
    ASSERT_TRUE(real.upload(scene.upload));
    ASSERT_TRUE(recorded.upload(scene.upload));
    Result<RenderTarget> realTarget = RenderTarget::create(*device_, 8, 8, {.samples = layout::kSamples}),
                         nullTarget = RenderTarget::create(null, 8, 8, {.samples = layout::kSamples});
    ASSERT_TRUE(realTarget && nullTarget);
    for (const Shading shading : {Shading::Lit, Shading::FlatIds, Shading::Lit}) {
        ASSERT_TRUE(real.render(scene.plan, *realTarget, {.wantIds = false, .shading = shading}));
        ASSERT_TRUE(recorded.render(scene.plan, *nullTarget, {.wantIds = false, .shading = shading}));
        EXPECT_LE(real.report().glCalls, kBudget);
        EXPECT_EQ(real.report().glCalls, recorded.report().glCalls);
    }
}

TEST_F(CallCountGlTest, nullDeviceCountsTheSameCalls) {
    for (const bool all : {true, false}) {
        SceneBuilder scene = everything(2);
        scene.finish(all);
        NullDevice null;
        Renderer real(*device_), recorded(null);
        ASSERT_TRUE(real.upload(scene.upload));
        ASSERT_TRUE(recorded.upload(scene.upload));
        Result<RenderTarget> realTarget = RenderTarget::create(*device_, 8, 8, {.layers = true}),
                             nullTarget = RenderTarget::create(null, 8, 8, {.layers = true});
        for (const RenderOptions& options :
             {RenderOptions{}, RenderOptions{.wantIds = false}, RenderOptions{.wantLayers = true},
              RenderOptions{.shading = Shading::FlatIds}, RenderOptions{.shading = Shading::IdsOnly},
              RenderOptions{.shading = Shading::IdsOnly, .wantLayers = true}, RenderOptions{}}) {
            ASSERT_TRUE(real.render(scene.plan, *realTarget, options));
            ASSERT_TRUE(recorded.render(scene.plan, *nullTarget, options));
            EXPECT_EQ(real.report().glCalls, recorded.report().glCalls);
        }
    }
}

// Planes and openings of the other gates: clip distances, a depth test that always passes, depth cleared in between.
TEST_F(CallCountGlTest, clipDistancesCostEightCallsEachWay_andBothDevicesCountThemAlike) {
    SceneBuilder scene = everything(2);
    scene.finish(true);
    NullDevice null;
    Renderer real(*device_), recorded(null);
    ASSERT_TRUE(real.upload(scene.upload));
    ASSERT_TRUE(recorded.upload(scene.upload));
    Result<RenderTarget> realTarget = RenderTarget::create(*device_, 8, 8),
                         nullTarget = RenderTarget::create(null, 8, 8);
    ASSERT_TRUE(realTarget && nullTarget);
    const auto calls = [&](const frame::FramePlan& plan) {
        EXPECT_TRUE(real.render(plan, *realTarget));
        EXPECT_TRUE(recorded.render(plan, *nullTarget));
        EXPECT_EQ(real.report().glCalls, recorded.report().glCalls);
        return real.report().glCalls;
    };
    const std::uint32_t plain = calls(scene.plan);
    frame::FramePlan clipped = scene.plan;
    clipped.clips = true;
    EXPECT_EQ(calls(clipped), plain + 2 * kClipDistances);
    frame::FramePlan ordered = clipped;
    ordered.firstOccludee = static_cast<std::uint32_t>(ordered.batches.size()); // depth is overwritten
    ordered.stages[1].clearsDepth = true;
    for (const frame::Program program : {frame::Program::Stamp, frame::Program::Fence}) {
        ordered.stages.push_back(
            {frame::StageKind::Ownership, static_cast<std::uint32_t>(ordered.batches.size()), 1});
        ordered.batches.push_back(
            {program, false, 0, static_cast<std::uint32_t>(ordered.ownershipVertices.size()), 1});
    }
    static_cast<void>(calls(ordered));
    EXPECT_FALSE(real.report().stages[0].gpuMs) << "stages repeat, so none is timed";
    EXPECT_EQ(calls(scene.plan), plain) << "every frame begins in the same state";
}

TEST_F(CallCountGlTest, gpuTimesArriveWithoutWaiting) {
    SceneBuilder scene = everything(3);
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    Result<RenderTarget> target = RenderTarget::create(*device_, 64, 64);
    for (int i = 0; i < 6; ++i) {
        ASSERT_TRUE(renderer.render(scene.finish(), *target));
        (void)target->readDepth(); // lets the GPU catch up
    }
    for (const StageReport& stage : renderer.report().stages) {
        ASSERT_TRUE(stage.gpuMs) << frame::nameOf(stage.kind);
        EXPECT_GE(*stage.gpuMs, 0.0);
        EXPECT_LT(*stage.gpuMs, 10'000.0);
    }
}

} // namespace
} // namespace limen::gpu::test
