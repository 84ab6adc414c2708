#include "engine/CheckDrawer.h"

#include "core/Assert.h"
#include "engine/CheckView.h"

namespace limen::engine {

namespace {

/// Draws the part that another session has loaded, in a GL context of its own.
class HelpingDrawer final : public check::Drawer {
public:
    HelpingDrawer(const Session& helped, HeadlessSession headless, bool outlines, bool multisampled)
        : helped_(helped), headless_(std::move(headless)),
          drawer_(*headless_.session, outlines, multisampled) {}

    Result<std::shared_ptr<const world::World>> load(dat::BlockCoord block) override {
        const std::shared_ptr<const LoadedPart> there = helped_.sharePart();
        LIMEN_ASSERT(there && there->target.centre == block, "the other session has loaded this block");
        if (Result<void> shown = headless_.session->show(std::make_unique<PartPlanner>(there)); !shown)
            return Failure(shown.error());
        return std::shared_ptr<const world::World>(there, &there->world);
    }
    reference::Camera cameraOf(const check::View& view, world::SpaceIndex root) override {
        return drawer_.cameraOf(view, root);
    }
    Result<check::DrawnImages> draw(const check::View& view, world::SpaceIndex root, bool colour) override {
        return drawer_.draw(view, root, colour);
    }
    check::IdColour idColour() const override { return drawer_.idColour(); }
    const world::DynamicState& dynamics() const override { return drawer_.dynamics(); }

private:
    const Session& helped_;
    HeadlessSession headless_;
    CheckDrawer drawer_;
};

} // namespace

Result<std::unique_ptr<check::Drawer>> CheckDrawer::makeHelper() {
    // Array pages instead of bindless textures: zink (Mesa 25.0) crashes if two contexts sample by handles at
    // the same time. The pictures are the same.
    SessionOptions options = session_.options();
    options.textures = gpu::TextureMode::ArrayPages;
    // llvmpipe (Mesa 22.3) reads the frames of all contexts of a display, without a lock, when one binds textures.
    const bool isLlvmpipe = session_.driver().starts_with("llvmpipe");
    Result<HeadlessSession> headless =
        openHeadless(session_.shareSource(), options,
                     isLlvmpipe ? gpu::ContextDisplay::SoftwareDevice : gpu::ContextDisplay::Default);
    if (!headless)
        return Failure(headless.error());
    return std::make_unique<HelpingDrawer>(session_, std::move(*headless), outlines_, multisampled_);
}

void CheckDrawer::expect(dat::BlockCoord block) {
    expected_ = block;
    coming_ = std::async(std::launch::async, [this, block] { return session_.read(block); });
}

Result<std::shared_ptr<const world::World>> CheckDrawer::load(dat::BlockCoord block) {
    if (!session_.isLoaded() || !(session_.part().target.centre == block)) {
        Result<std::unique_ptr<PartPlanner>> read =
            coming_.valid() && expected_ == block ? coming_.get() : session_.read(block);
        if (!read)
            return Failure(read.error());
        if (Result<void> shown = session_.show(std::move(*read)); !shown)
            return Failure(shown.error());
    }
    const std::shared_ptr<const LoadedPart> loaded = session_.sharePart();
    return std::shared_ptr<const world::World>(loaded, &loaded->world);
}

reference::Camera CheckDrawer::cameraOf(const check::View& view, world::SpaceIndex root) {
    reference::Camera camera = engine::tracedCamera(requestOf(view, session_.part().world, root));
    if (multisampled_)
        camera.place = Vec2(0.0); // the samples' own offsets count
    return camera;
}

Result<check::DrawnImages> drawImages(Session& session, const FrameRequest& request, bool colour) {
    const DrawOptions options{.ids = true,
                              .shading = colour ? gpu::Shading::Lit : gpu::Shading::IdsOnly,
                              .layers = !colour}; // layers are counted instead of blended
    if (Result<void> drawn = session.draw(request, options); !drawn)
        return Failure(drawn.error());
    const gpu::RenderTarget& target = session.target();
    check::DrawnImages images;
    images.width = request.size.width;
    images.height = request.size.height;
    images.ids = target.readIds();
    // Gate::Depth overwrites depth, and draws walls over transparent surfaces: neither image is the picture's.
    const bool isOfPicture = session.options().gate != frame::Gate::Depth;
    if (isOfPicture)
        images.depth = target.readDepth();
    // A power of two, so that no bit of a depth is lost. Hashes of pictures do not depend on the near plane.
    const auto perStored = static_cast<float>(images.depthUnit / frame::FrameView{}.nearPlane);
    for (float& depth : images.depth)
        depth *= perStored;
    if (colour) {
        images.colour = target.readColour();
        return images;
    }
    for (const gpu::LayerSum& layers : isOfPicture ? target.readLayers() : std::vector<gpu::LayerSum>())
        images.layers.push_back({layers.count, layers.hash});
    return images;
}

Result<check::DrawnImages> CheckDrawer::draw(const check::View& view, world::SpaceIndex root, bool colour) {
    const FrameRequest request = requestOf(view, session_.part().world, root);
    Result<check::DrawnImages> images =
        multisampled_ ? drawSamples(request) : drawImages(session_, request, colour);
    if (images && outlines_)
        images->outlines = regionOutlines(session_.visible());
    return images;
}

Result<check::DrawnImages> CheckDrawer::drawSamples(const FrameRequest& request) {
    if (Result<void> drawn = session_.draw(request, {.shading = gpu::Shading::FlatIds}); !drawn)
        return Failure(drawn.error());
    check::DrawnImages images;
    images.width = request.size.width;
    images.height = request.size.height;
    images.colour = session_.target().readColour();
    images.samples = session_.target().samplePositions();
    return images;
}

} // namespace limen::engine
