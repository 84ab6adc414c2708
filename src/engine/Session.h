#pragma once

#include "engine/FrameReport.h"
#include "engine/Picked.h"
#include "engine/Pipeline.h"
#include "engine/Residency.h"
#include "engine/SessionOptions.h"
#include "engine/WorldSource.h"
#include "gpu/device/CheckedDevice.h"
#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"
#include "world/load/LoadCache.h"

#include <memory>

namespace limen::engine {

/// The kind of picture that a frame is drawn as.
struct DrawOptions {
    bool ids = false; ///< write the id image, cut-outs tested exactly
    gpu::Shading shading =
        gpu::Shading::Lit; ///< FlatIds with several samples: the mean of the samples' colours
    bool layers = false;   ///< count the layers of transparent surfaces instead of blending them
    std::span<const frame::Highlight> highlights{};
};

/// One world on one graphics device: files, the loaded part, its pipeline and the targets it draws into. Every verb that draws goes
/// through here. The device must outlive it.
class Session final : public Residency {
public:
    Session(std::shared_ptr<const WorldSource> source, const SessionOptions& options, gpu::Device& device);
    ~Session() override;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Loads and uploads the blocks around `centre` unless they are there already. On an error the old part stays.
    [[nodiscard]] Result<void> load(dat::BlockCoord centre);
    /// Reads the blocks around `centre`. Any thread may, at any time.
    [[nodiscard]] Result<std::unique_ptr<PartPlanner>> read(dat::BlockCoord centre) const {
        return read({centre, options_.load});
    }
    [[nodiscard]] Result<std::unique_ptr<PartPlanner>> read(const PartTarget& target,
                                                            unsigned threads = 1) const;
    /// Uploads a part that was read; it is drawn from now on. On an error the old part stays.
    [[nodiscard]] Result<void> show(std::unique_ptr<PartPlanner> part) {
        return pipeline_.show(std::move(part));
    }
    /// As Pipeline::take.
    [[nodiscard]] std::unique_ptr<PartPlanner> take(std::unique_ptr<PartPlanner> part) {
        return pipeline_.take(std::move(part));
    }
    /// Parts are loaded with these options from now on.
    void setLoadOptions(const world::LoadOptions& load) { options_.load = load; }
    /// Index into kQualities. Samples change with the next frame, all else with the next part that is loaded; where the session
    /// loads by itself, that is the next frame, too.
    void setQuality(std::size_t quality);

    // Residency: a part that comes near is read at once, in the frame that needs it.
    [[nodiscard]] std::shared_ptr<const LoadedPart> follow(const Vec3& eye, world::SpaceIndex root) override;
    [[nodiscard]] bool isPatient() const override { return false; }
    [[nodiscard]] bool show() override;
    [[nodiscard]] Passage open(dat::BlockCoord centre) override;

    /// Draws one frame. Requires a loaded part. Errors: the renderer's, the target's.
    [[nodiscard]] Result<void> draw(const FrameRequest& request, const DrawOptions& options);
    /// The surface at a pixel (from the upper left corner). It draws a frame of ids: draw the frame to show again afterwards.
    /// Requires a loaded part.
    [[nodiscard]] Result<Picked> pick(const FrameRequest& request, std::uint32_t x, std::uint32_t y);
    /// The flood's decision at each portal that it meets, with the doors of the last frame. Requires a drawn frame.
    void tracePortals(const FrameRequest& request, visibility::FloodTrace& trace);

    [[nodiscard]] const WorldSource& source() const { return *source_; }
    [[nodiscard]] const std::shared_ptr<const WorldSource>& shareSource() const { return source_; }
    [[nodiscard]] const SessionOptions& options() const { return options_; }
    [[nodiscard]] bool isLoaded() const { return pipeline_.hasPart(); }
    [[nodiscard]] const LoadedPart& part() const { return pipeline_.part(); }
    /// Outlives the next load.
    [[nodiscard]] std::shared_ptr<const LoadedPart> sharePart() const { return pipeline_.sharePart(); }
    [[nodiscard]] gpu::Renderer& renderer() { return pipeline_.renderer(); }
    [[nodiscard]] const gpu::Renderer& renderer() const { return pipeline_.renderer(); }
    [[nodiscard]] const gpu::Capabilities& capabilities() const { return device_.capabilities(); }
    /// Frames drawn so far.
    [[nodiscard]] std::uint64_t frames() const { return frames_; }
    // The last frame.
    [[nodiscard]] const visibility::VisibleSet& visible() const { return pipeline_.state().visible; }
    [[nodiscard]] const frame::FramePlan& plan() const { return pipeline_.state().plan; }
    [[nodiscard]] const world::DynamicState& dynamics() const { return pipeline_.state().dynamics; }
    [[nodiscard]] const gpu::RenderTarget& target() const { return *shown_; }
    [[nodiscard]] FrameFigures figures() const;
    /// The driver in one line.
    [[nodiscard]] std::string driver() const;

private:
    [[nodiscard]] gpu::Device& drawnOn();
    /// Makes the target of such a frame fit, and yields it.
    [[nodiscard]] Result<gpu::RenderTarget*> fitTarget(PixelSize size, const DrawOptions& options);

    std::shared_ptr<const WorldSource> source_;
    SessionOptions options_;
    const std::shared_ptr<world::LoadCache> cache_ = std::make_shared<world::LoadCache>();
    gpu::Device& device_;
    std::optional<gpu::CheckedDevice> checked_; ///< in development builds
    Pipeline pipeline_;
    std::unique_ptr<PartPlanner> offered_;
    std::optional<gpu::RenderTarget> target_, sampledTarget_; ///< one sample a pixel, and several
    gpu::RenderTarget* shown_ = nullptr;                      ///< the last frame's
    double floodMs_ = 0.0, planMs_ = 0.0;
    std::uint64_t frames_ = 0;
};

/// A session that draws without a window.
struct HeadlessSession {
    std::unique_ptr<gpu::HeadlessContext> context;
    std::unique_ptr<gpu::GlDevice> device;
    std::unique_ptr<Session> session; ///< destroyed first
    HeadlessSession() = default;
    HeadlessSession(HeadlessSession&&) noexcept = default;
    HeadlessSession& operator=(HeadlessSession&&) noexcept = default;
};
/// Errors: Driver; the world's.
[[nodiscard]] Result<HeadlessSession> openHeadless(std::shared_ptr<const WorldSource> source,
                                                   const SessionOptions& options);

} // namespace limen::engine
