#pragma once

#include "frame/FramePlan.h"
#include "gpu/DepthTiles.h"
#include "gpu/FrameRing.h"
#include "gpu/RenderOptions.h"
#include "gpu/RenderTarget.h"
#include "gpu/RendererOptions.h"

#include <optional>

namespace limen::gpu {

/// Makes the draw commands of a plan's pieces, on the device, and leaves out triangles that show nothing (shaders/cull.comp). Never
/// changes a picture of exact outlines. The device must outlive it.
class DrawCulling {
public:
    /// Errors: Driver, if a program does not build.
    [[nodiscard]] static Result<DrawCulling> create(Device& device, std::span<const std::string> defines,
                                                    Culling culling);

    /// Takes up what a frame draws by indices. All triangles are drawn of multisampled frames, and where there are more than
    /// memory is kept for, or can be had: then the frame goes on without. Not during a frame.
    void prepare(const frame::FramePlan& plan, const RenderOptions& options, const RenderTarget& target);
    /// Why frames are drawn without what they were to have; none if they have it.
    [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }
    /// With another scene what could not be had before is asked for again.
    void tryAgain() {
        failures_ = 0;
        failure_.reset();
    }
    /// How many draw commands that makes: each has a slot.
    [[nodiscard]] std::uint32_t slotCount() const { return slotCount_; }
    /// Tells which pieces all slots are of, straight into the frame's memory. Plan and options are those of `prepare`.
    void writeRuns(const frame::FramePlan& plan, const RenderOptions& options,
                   std::span<frame::gpu::SlotGroup> groups, std::span<frame::gpu::DrawRun> runs) const;
    /// The slot of a batch's first draw command; those of the others follow.
    [[nodiscard]] std::uint32_t firstSlot(std::size_t batch) const { return firstSlots_[batch]; }
    /// Whether the draws read the static indices; else they read those that are kept, and no others.
    [[nodiscard]] bool keepsTriangles() const { return keepsTriangles_; }
    /// Whether batches from FramePlan::firstHideable on wait for what is drawn before them.
    [[nodiscard]] bool leavesOutHidden() const { return leavesOutHidden_; }
    /// The indices that are kept. Invalid while none ever were.
    [[nodiscard]] BufferHandle keptIndices() const { return kept_.get(); }
    /// Fills in the arrays of its own.
    void bind(StorageBindings& storage) const;
    /// Tells the shader what is to be done.
    void describe(frame::gpu::DeviceConstants& constants) const;
    /// Within a frame whose runs, pieces, commands and indices are bound: writes the commands and indices that are drawn,
    /// of the batches that wait for nothing.
    void runFirst();
    /// Of the others, if leavesOutHidden(), when those before are drawn.
    void runBehind();

private:
    static constexpr std::size_t kIndexSize = sizeof(std::uint32_t);
    DrawCulling(Device& device, OwnedProgram program, Culling culling)
        : device_(&device), program_(std::move(program)), culling_(culling), tiles_(device) {}
    [[nodiscard]] Result<void> reserve(std::size_t indices);
    /// Whether something was made. What is not is asked for again by the next frames, but not for ever.
    [[nodiscard]] bool isMade(const Result<void>& made);
    /// `purpose`: one of kCullFirst, ...
    void run(std::uint32_t purpose, std::uint32_t groups);

    Device* device_;
    OwnedProgram program_;
    Culling culling_;
    DepthTiles tiles_;
    OwnedBuffer kept_;
    std::size_t capacity_ = 0;    ///< indices a frame
    std::size_t place_ = 0;       ///< of the frames under way
    bool keepsTriangles_ = false; ///< this frame's, as all that follow
    bool leavesOutHidden_ = false;
    std::uint32_t slotCount_ = 0, firstHideable_ = 0;
    std::uint32_t failures_ = 0;
    std::optional<Error> failure_;          ///< the last
    std::vector<std::uint32_t> firstSlots_; ///< by batch
};

} // namespace limen::gpu
