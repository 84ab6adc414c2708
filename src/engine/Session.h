#pragma once

#include "engine/Pipeline.h"
#include "engine/SessionOptions.h"
#include "engine/WorldSource.h"
#include "engine/report/FrameReport.h"
#include "engine/report/Picked.h"
#include "engine/stream/Residency.h"
#include "gpu/device/CheckedDevice.h"
#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"
#include "world/load/LoadCache.h"

#include <memory>

namespace limen::engine {

/// Selects the images that a frame is drawn into.
struct DrawOptions {
    bool ids = false; ///< write the id image, with exact cut-outs
    gpu::Shading shading =
        gpu::Shading::Lit; ///< FlatIds with several samples: the mean of the samples' colours
    bool layers = false;   ///< count the layers of transparent surfaces instead of blending them
    std::span<const frame::Highlight> highlights{};
};

/// One world on one graphics device: its files, the loaded part, the pipeline, and the render targets. All
/// verbs that draw use it. The device must outlive it.
class Session final : public Residency {
public:
    Session(std::shared_ptr<const WorldSource> source, const SessionOptions& options, gpu::Device& device);
    ~Session() override;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Loads and uploads the blocks around `centre` unless they are loaded already. On an error the old part
    /// stays.
    [[nodiscard]] Result<void> load(dat::BlockCoord centre);
    /// Reads the blocks around `centre` without showing them. Safe on any thread, at any time.
    [[nodiscard]] Result<std::unique_ptr<PartPlanner>> read(dat::BlockCoord centre) const {
        return read({centre, options_.load});
    }
    [[nodiscard]] Result<std::unique_ptr<PartPlanner>> read(const PartTarget& target, unsigned threads = 1,
                                                            world::LoadProgress* progress = nullptr) const;
    /// Uploads a part that was read and draws it from now on. On an error the old part stays.
    [[nodiscard]] Result<void> show(std::unique_ptr<PartPlanner> part) {
        return pipeline_.show(std::move(part));
    }
    /// As Pipeline::take.
    [[nodiscard]] std::unique_ptr<PartPlanner> take(std::unique_ptr<PartPlanner> part) {
        return pipeline_.take(std::move(part));
    }
    /// Sets the options of the next loads. The part on the screen stays until `follow` or `load` replaces it.
    void setLoadOptions(const world::LoadOptions& load) { options_.load = load; }
    /// Sets the gate of the next frames.
    void setGate(frame::Gate gate);
    /// Sets a quality level, an index into kQualities. Samples and filtering change with the next frame.
    /// Loading options apply to the next load; a residency starts it in the next frame.
    void setQuality(std::size_t quality);

    // Residency without streaming: `follow` reads the part in the frame that needs it, and blocks.
    [[nodiscard]] std::shared_ptr<const LoadedPart> follow(const Vec3& eye, world::SpaceIndex root) override;
    [[nodiscard]] bool isPatient() const override { return false; }
    [[nodiscard]] bool show() override;
    [[nodiscard]] Passage open(dat::BlockCoord centre) override;

    /// Draws one frame. Requires a loaded part. Errors: the renderer's, the target's.
    [[nodiscard]] Result<void> draw(const FrameRequest& request, const DrawOptions& options);
    /// A target for drawTile, of this size in pixels and with this session's samples. Errors: the device's.
    [[nodiscard]] Result<gpu::RenderTarget> makeTile(std::uint32_t width, std::uint32_t height);
    /// Waits until the device has drawn all frames.
    void finish() { device_.finishFrames(); }
    /// Draws a part of a picture into a tile (RenderTarget::setTile). `request`: of the whole picture. Ends the
    /// last frame: `target` needs another `draw`. Errors: the renderer's.
    [[nodiscard]] Result<void> drawTile(const FrameRequest& request, gpu::RenderTarget& tile);
    /// The surface at a pixel, counted from the upper left corner. Draws a frame of ids into the target, so
    /// the visible frame must be drawn again afterwards. Requires a loaded part and a pixel inside of the
    /// picture.
    [[nodiscard]] Result<Picked> pick(const FrameRequest& request, std::uint32_t x, std::uint32_t y);
    /// Records the fate of each portal that a flood meets, with the doors of the last frame. Requires a drawn
    /// frame.
    void tracePortals(const FrameRequest& request, visibility::FloodTrace& trace);

    [[nodiscard]] const WorldSource& source() const { return *source_; }
    [[nodiscard]] const std::shared_ptr<const WorldSource>& shareSource() const { return source_; }
    [[nodiscard]] const SessionOptions& options() const { return options_; }
    [[nodiscard]] bool isLoaded() const { return pipeline_.hasPart(); }
    [[nodiscard]] const LoadedPart& part() const { return pipeline_.part(); }
    /// The part as shared data; it outlives the next load. Null: no part is loaded.
    [[nodiscard]] std::shared_ptr<const LoadedPart> sharePart() const { return pipeline_.sharePart(); }
    [[nodiscard]] gpu::Renderer& renderer() { return pipeline_.renderer(); }
    [[nodiscard]] const gpu::Renderer& renderer() const { return pipeline_.renderer(); }
    [[nodiscard]] const gpu::Capabilities& capabilities() const { return device_.capabilities(); }
    /// Samples a pixel in frames without ids and layers; 1: no multisampling.
    [[nodiscard]] std::uint32_t samples() const { return samplesOn(capabilities(), options_); }
    /// Frames drawn so far.
    [[nodiscard]] std::uint64_t frames() const { return frames_; }
    // Results of the last frame. `target` requires a drawn frame.
    [[nodiscard]] const visibility::VisibleSet& visible() const { return pipeline_.state().visible; }
    [[nodiscard]] const frame::FramePlan& plan() const { return pipeline_.state().plan; }
    [[nodiscard]] const world::DynamicState& dynamics() const { return pipeline_.state().dynamics; }
    [[nodiscard]] const gpu::RenderTarget& target() const;
    [[nodiscard]] FrameFigures figures() const;
    /// The driver in one line.
    [[nodiscard]] std::string driver() const;

private:
    [[nodiscard]] gpu::Device& drawnOn();
    /// Draws into a target that fits. `outputs` refers to data of the caller.
    [[nodiscard]] Result<void> drawInto(gpu::RenderTarget& target, const FrameRequest& request,
                                        const FrameOutputs& outputs, const gpu::RenderOptions& options);
    /// The target for a frame of this size and kind; made again if the last one does not fit.
    [[nodiscard]] Result<gpu::RenderTarget*> fitTarget(PixelSize size, const DrawOptions& options);

    std::shared_ptr<const WorldSource> source_;
    SessionOptions options_;
    const std::shared_ptr<world::LoadCache> cache_ = std::make_shared<world::LoadCache>();
    gpu::Device& device_;
    std::optional<gpu::CheckedDevice> checked_; ///< in development builds
    Pipeline pipeline_;
    std::unique_ptr<PartPlanner> offered_;
    std::optional<gpu::RenderTarget> target_, sampledTarget_; ///< with one sample a pixel, and with several
    gpu::RenderTarget* shown_ = nullptr;                      ///< the last frame's; null before the first
    double floodMs_ = 0.0, planMs_ = 0.0;
    std::uint64_t frames_ = 0;
};

/// A session with a GL context that needs no window.
struct HeadlessSession {
    std::unique_ptr<gpu::HeadlessContext> context;
    std::unique_ptr<gpu::GlDevice> device;
    std::unique_ptr<Session> session; ///< destroyed first
    HeadlessSession() = default;
    HeadlessSession(HeadlessSession&&) noexcept = default;
    HeadlessSession& operator=(HeadlessSession&&) noexcept = default;
};
/// Errors: Driver, if no context can be made.
[[nodiscard]] Result<HeadlessSession>
openHeadless(std::shared_ptr<const WorldSource> source, const SessionOptions& options,
             gpu::ContextDisplay display = gpu::ContextDisplay::Default);

} // namespace limen::engine
