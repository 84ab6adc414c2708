#pragma once

#include "frame/FramePlan.h"
#include "frame/SceneUpload.h"
#include "gpu/FrameReport.h"
#include "gpu/RenderOptions.h"
#include "gpu/RenderTarget.h"
#include "gpu/RendererOptions.h"
#include "gpu/device/Device.h"
#include "gpu/scene/SceneStaging.h"

#include <memory>

namespace limen::gpu {

class DrawCulling;
class FrameRing;
class ResidentScene;
class SpareBuffers;

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

    // The same in slices, over several frames: the next scene comes beside the one that is drawn.

    /// Has memory found for a scene as large as the one that is drawn, so that the first that comes in slices costs frames no more than
    /// those after it. Errors: the device's; it comes all the same.
    Result<void> makeRoom();
    /// What stageScene takes, beside the device's capabilities.
    [[nodiscard]] SceneState state() const;
    [[nodiscard]] const RendererOptions& options() const { return options_; }
    /// Of the textures of scenes that are uploaded from now on.
    void setAnisotropy(float most) { options_.textures.anisotropy = most; }
    /// Begins with a staged scene; one that was coming is dropped. Errors: Driver, if a program does not build.
    [[nodiscard]] Result<void> begin(StagedScene staged);
    /// Goes on with it by about so many bytes, and gives back some of what is drawn no more. Between frames. Yields true when the next
    /// scene is there, also when none was begun. Errors: as upload's, and BadArgument if it was staged beside another scene;
    /// then it is dropped.
    [[nodiscard]] Result<bool> advance(std::size_t bytes);
    /// It is drawn from now on. Requires that it is there.
    void swap();
    /// It is not wanted any more.
    void drop();

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
    /// A scene that is drawn no more.
    struct Retired {
        std::unique_ptr<ResidentScene> scene;
        std::uint64_t frame = 0; ///< from which on it was not
    };
    [[nodiscard]] std::shared_ptr<Programs> programsFor(const SceneBindings& bindings);
    [[nodiscard]] Result<void> uploadOnce(frame::SceneUpload upload);
    void releaseSome();
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
    std::vector<std::shared_ptr<Programs>> programs_; ///< of the last scenes, the last used first
    std::unique_ptr<DrawCulling> culling_;            ///< with the first scene
    std::unique_ptr<SpareBuffers> spare_;             ///< goes after the scenes
    std::unique_ptr<ResidentScene> scene_, coming_;
    std::vector<Retired> retired_; ///< the oldest first
    std::uint64_t frames_ = 0;     ///< drawn so far
    FrameReport report_;
};

} // namespace limen::gpu
