#pragma once

#include "frame/FramePlan.h"
#include "frame/SceneUpload.h"
#include "gpu/DriverChoices.h"
#include "gpu/FrameReport.h"
#include "gpu/RenderOptions.h"
#include "gpu/RenderTarget.h"
#include "gpu/RendererOptions.h"
#include "gpu/device/Device.h"
#include "gpu/scene/SceneStaging.h"

#include <memory>

namespace limen::gpu {

class DrawCulling;
class FastDraws;
struct BatchSlots;
struct FrameKind;
class FrameRing;
class ResidentScene;
class SpareBuffers;

/// Draws frame plans on a device, with one GL draw call per batch. The device must outlive it.
class Renderer {
public:
    explicit Renderer(Device& device, RendererOptions options = {});
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    ~Renderer();

    /// Replaces the static scene, with a few retries if the driver fails. Errors: BadArgument for invalid
    /// indices; errors of textures, buffers and programs. On an error the previous scene stays.
    [[nodiscard]] Result<void> upload(const frame::SceneUpload& scene);

    // Sliced upload over several frames, beside the scene being drawn.

    /// Allocates spare buffers for a scene as large as the current one, so that the first sliced upload costs
    /// frames no more than later ones. Errors: the device's; sliced uploads still work then.
    Result<void> makeRoom();
    /// State that stageScene needs, beside the device's capabilities.
    [[nodiscard]] SceneState state() const;
    [[nodiscard]] const RendererOptions& options() const { return options_; }
    /// Decisions for its device, of a target with one sample a pixel.
    [[nodiscard]] DriverChoices choices() const;
    /// Anisotropic filtering limit for the textures of later scenes.
    void setAnisotropy(float most) { options_.textures.anisotropy = most; }
    /// Starts the upload of a staged scene; drops an unfinished one. Errors: Driver, if a program does not
    /// build.
    [[nodiscard]] Result<void> begin(StagedScene staged);
    /// Uploads about `bytes` more and releases a part of retired scenes. Between frames. True when the next
    /// scene is complete, or if there is none. Errors, which drop that scene: as in `upload`; BadArgument, if
    /// it was staged beside another scene.
    [[nodiscard]] Result<bool> advance(std::size_t bytes);
    /// Makes the next scene the current one. Requires that it is complete.
    void swap();
    /// Drops the next scene.
    void drop();

    /// Draws one frame. Requires an uploaded scene and a plan for it: at least one visit, parents before
    /// children, batches within the runs, runs within the pieces. The first frame of a variant builds its
    /// programs.
    /// Errors: Driver, if a program does not build, without memory for the frame's arrays, or when the
    /// context is lost. Without memory for culling the frame is drawn unculled: FrameReport::trouble.
    [[nodiscard]] Result<void> render(const frame::FramePlan& plan, RenderTarget& target,
                                      const RenderOptions& options = {});

    /// Report of the last frame; GPU times are of the latest frame with results.
    [[nodiscard]] FrameReport report() const;
    [[nodiscard]] DriverReport driver() const;

private:
    /// A scene that is no longer drawn.
    struct Retired {
        std::unique_ptr<ResidentScene> scene;
        std::uint64_t frame = 0; ///< number of the first frame without it
    };
    [[nodiscard]] std::shared_ptr<Programs> programsFor(const SceneBindings& bindings);
    [[nodiscard]] Result<void> uploadOnce(frame::SceneUpload upload);
    void releaseSome();
    [[nodiscard]] FrameKind kindOf(const frame::FramePlan& plan, const RenderTarget& target,
                                   const RenderOptions& options) const;
    [[nodiscard]] Result<void> preparePrograms(const frame::FramePlan& plan, const FrameKind& frame);
    [[nodiscard]] BufferHandle indicesFor(const RenderOptions& options) const;
    [[nodiscard]] bool isFast() const { return options_.drawing == Drawing::Fast; }
    [[nodiscard]] Result<void> createCulling();
    /// Assigns the slots of the plan's draws; returns their number.
    [[nodiscard]] std::uint32_t prepareDraws(const frame::FramePlan& plan, const RenderOptions& options,
                                             const RenderTarget& target);
    [[nodiscard]] const BatchSlots& slotsOf(std::size_t batch) const;
    /// Writes a frame's arrays into its ring memory.
    /// Of the target, or around it (wide.glsl).
    [[nodiscard]] Viewport viewportOf(const RenderTarget& target) const;
    void writeRing(const frame::FramePlan& plan, const FrameRing& ring, const RenderOptions& options,
                   const RenderTarget& target, std::span<std::byte> memory);
    void bindAll(const FrameRing& ring, bool withDrawn);
    /// All images of the target, but those that the solid pass clears.
    void clearTarget(const frame::FramePlan& plan, const FrameKind& frame);
    /// `commands`: offset of the frame's draw commands in the ring memory.
    void drawStages(const frame::FramePlan& plan, std::size_t commands, const FrameKind& frame);
    void drawPlainSky(const frame::Batch& batch, bool voids, const FrameKind& frame);
    void drawBatch(const frame::Batch& batch, const BatchSlots& slots, std::size_t commands,
                   const FrameKind& frame);

    Device* device_;
    RendererOptions options_;
    std::vector<std::shared_ptr<Programs>> programs_; ///< of the last scenes, most recently used first
    std::unique_ptr<DrawCulling> culling_;            ///< of Drawing::Exact; created with the first scene
    std::unique_ptr<FastDraws> fast_;                 ///< of Drawing::Fast
    std::unique_ptr<SpareBuffers> spare_;             ///< destroyed after the scenes
    std::unique_ptr<ResidentScene> scene_, coming_;
    std::vector<Retired> retired_; ///< oldest first
    std::uint64_t frames_ = 0;     ///< number of frames drawn
    FrameReport report_;
    bool timesStages_ = true; ///< the last frame had each stage once
};

} // namespace limen::gpu
