#pragma once

#include "frame/FramePlan.h"
#include "frame/SceneUpload.h"
#include "gpu/Device.h"
#include "gpu/FrameReport.h"
#include "gpu/RenderOptions.h"
#include "gpu/RenderTarget.h"
#include "gpu/RendererOptions.h"

#include <memory>

namespace limen::gpu {

class DrawCulling;
class FrameRing;
class ResidentScene;

/// Draws frame plans on a device: one GL draw call per batch, whatever it holds. The device must outlive it.
class Renderer {
public:
    explicit Renderer(Device& device, RendererOptions options = {});
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    ~Renderer();

    /// Replaces the static scene. Tries again, but not for ever, where the driver fails. Errors: BadArgument for indices that lead
    /// nowhere; what textures, buffers and programs report. On an error the scene that was there stays.
    [[nodiscard]] Result<void> upload(const frame::SceneUpload& scene);
    /// Draws one frame. Requires an uploaded scene and a plan made for it: at least one visit, parents before
    /// children, batches within the runs, runs within the pieces. The first frame of its kind builds its programs. Errors: Driver, if they
    /// do not build, memory for the frame's arrays cannot be had, or the driver has lost all it held. Without memory for what only makes
    /// frames faster they go on: FrameReport::trouble.
    [[nodiscard]] Result<void> render(const frame::FramePlan& plan, RenderTarget& target,
                                      const RenderOptions& options = {});

    /// The last frame; GPU times are the latest known.
    [[nodiscard]] FrameReport report() const;
    [[nodiscard]] DriverReport driver() const;

private:
    [[nodiscard]] Result<void> preparePrograms(const frame::FramePlan& plan, const RenderOptions& options,
                                               bool multisampled);
    void bindAll(const FrameRing& ring, const DrawCulling& culling);
    void clearTarget(const frame::FramePlan& plan, const RenderOptions& options);
    void drawStages(const frame::FramePlan& plan, std::size_t commandsOffset, const RenderOptions& options,
                    bool multisampled);
    void drawBatch(const frame::Batch& batch, std::size_t commandsOffset, const RenderOptions& options,
                   bool multisampled); ///< `commandsOffset`: of its own

    Device* device_;
    RendererOptions options_;
    std::unique_ptr<ResidentScene> scene_;
    FrameReport report_;
};

} // namespace limen::gpu
