#include "GlFixture.h"

namespace limen::gpu::test {

void GlTest::SetUp() {
    Result<HeadlessContext> context = HeadlessContext::create(true);
    ASSERT_TRUE(context) << context.error().message();
    context_.emplace(std::move(*context));
    debug_.emplace();
    Result<std::unique_ptr<GlDevice>> device = GlDevice::create();
    ASSERT_TRUE(device) << device.error().message();
    device_ = std::move(*device);
}

void GlTest::TearDown() {
    device_.reset();
    if (debug_)
        for (const std::string& fault : debug_->faults())
            ADD_FAILURE() << "driver message: " << fault;
    debug_.reset();
    context_.reset();
}

Frame GlTest::render(SceneBuilder& scene, std::uint32_t size, const RendererOptions& options) {
    Renderer renderer(*device_, options);
    const Result<void> uploaded = renderer.upload(scene.upload);
    EXPECT_TRUE(uploaded) << uploaded.error().message();
    return uploaded ? renderWith(renderer, scene.finish(), size, size) : Frame{};
}

Frame GlTest::renderWith(Renderer& renderer, const frame::FramePlan& plan, std::uint32_t width,
                         std::uint32_t height, const RenderOptions& options) {
    Result<RenderTarget> target = RenderTarget::create(
        *device_, width, height,
        {.layers = options.wantLayers, .wide = renderer.options().drawing == Drawing::Fast});
    EXPECT_TRUE(target) << target.error().message();
    const Result<void> rendered = renderer.render(plan, *target, options);
    EXPECT_TRUE(rendered) << rendered.error().message();
    Frame frame{
        target->readIds(), target->readOwnership(), target->readColour(), target->readDepth(), {}, width};
    if (options.wantLayers)
        frame.layers = target->readLayers();
    return frame;
}

} // namespace limen::gpu::test
