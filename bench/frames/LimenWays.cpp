#include "frames/LimenWays.h"

#include "HeadlessDriver.h"

#include <epoxy/gl.h>

namespace limen::bench {

namespace {

/// A part drawn with one set of options, which several ways share. All parts share the driver.
class SharedPart {
public:
    SharedPart(std::shared_ptr<HeadlessDriver> driver, gpu::RendererOptions options, std::uint32_t width,
               std::uint32_t height)
        : driver_(std::move(driver)), options_(std::move(options)), width_(width), height_(height) {}
    SharedPart(const SharedPart&) = delete;
    SharedPart& operator=(const SharedPart&) = delete;
    ~SharedPart() {
        static_cast<void>(enter());
        drawn_.reset();
    }

    [[nodiscard]] Result<void> enter() { return driver_->context.makeCurrent(); }
    [[nodiscard]] DrawnPart& drawn() { return *drawn_; }
    /// Uploads a part unless it is there already.
    [[nodiscard]] Result<void> show(const std::shared_ptr<const engine::LoadedPart>& part) {
        if (drawn_ && &drawn_->part() == part.get())
            return {};
        drawn_.reset(); // frees its memory before the next is uploaded
        return DrawnPart::of(part, *driver_->device, width_, height_, options_)
            .map([&](std::unique_ptr<DrawnPart> drawn) { drawn_ = std::move(drawn); });
    }

private:
    std::shared_ptr<HeadlessDriver> driver_;
    gpu::RendererOptions options_;
    std::uint32_t width_, height_;
    std::unique_ptr<DrawnPart> drawn_;
};

class LimenWay final : public FrameWay {
public:
    LimenWay(std::string name, std::shared_ptr<SharedPart> part, Without without)
        : FrameWay(std::move(name)), part_(std::move(part)), without_(without) {}

    [[nodiscard]] Result<void> enter() override { return part_->enter(); }
    [[nodiscard]] Result<void> show(const FramePlace& place) override {
        view_ = place.view;
        view_.occlusion = frame::Occlusion::IfWorthwhile; // as in the window
        return part_->show(place.part);
    }
    [[nodiscard]] Result<void> draw() override {
        Result<void> drawn = drawFrame(part_->drawn(), view_, without_);
        glFinish();
        return drawn;
    }
    [[nodiscard]] FramePicture read() override {
        const gpu::RenderTarget& target = part_->drawn().target();
        return {target.width(), target.height(), target.readColour(), target.readDepth()};
    }

private:
    std::shared_ptr<SharedPart> part_;
    Without without_;
    frame::FrameView view_;
};

} // namespace

std::vector<LimenRenderer> limenRenderers() {
    return {
        {"fast", {.drawing = gpu::Drawing::Fast}, {Without::Visibility}},
        {"exact", {}, {Without::Ownership}},
    };
}

Result<void> drawFrame(DrawnPart& part, const frame::FrameView& view, Without without) {
    part.move(view);
    if (without == Without::Visibility)
        part.takeAll(view);
    else
        part.flood(view);
    part.plan(view);
    if (without == Without::Ownership)
        part.leaveOutOwnership();
    return part.submit({.wantIds = false});
}

std::string wayName(const std::string& renderer, Without without) {
    switch (without) {
    case Without::Visibility:
        return renderer + " without visibility";
    case Without::Ownership:
        return renderer + " without ownership";
    case Without::Nothing:
        break;
    }
    return renderer;
}

Result<std::vector<std::unique_ptr<FrameWay>>> makeLimenWays(const std::vector<LimenRenderer>& renderers,
                                                             std::uint32_t width, std::uint32_t height) {
    std::optional<HeadlessDriver> opened = openDriver();
    if (!opened)
        return fail(ErrorCode::Driver, "bench", "no driver with OpenGL 4.5");
    const auto driver = std::make_shared<HeadlessDriver>(std::move(*opened));
    std::vector<std::unique_ptr<FrameWay>> ways;
    for (const LimenRenderer& renderer : renderers) {
        const auto part = std::make_shared<SharedPart>(driver, renderer.options, width, height);
        ways.push_back(std::make_unique<LimenWay>(renderer.name, part, Without::Nothing));
        for (const Without without : renderer.without)
            ways.push_back(std::make_unique<LimenWay>(wayName(renderer.name, without), part, without));
    }
    return ways;
}

} // namespace limen::bench
