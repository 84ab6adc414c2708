#pragma once

#include "frame/FramePlan.h"
#include "gpu/BatchSlots.h"
#include "gpu/DepthTiles.h"
#include "gpu/FrameRing.h"
#include "gpu/RenderOptions.h"
#include "gpu/RenderTarget.h"
#include "gpu/RendererOptions.h"

#include <array>
#include <optional>

namespace limen::gpu {

/// Writes a plan's draw commands on the GPU and culls triangles (shaders/cull.comp). With exact outlines the
/// picture is the same to the bit. The device must outlive it.
class DrawCulling {
public:
    /// Errors: Driver, if a program does not build.
    [[nodiscard]] static Result<DrawCulling> create(Device& device, std::span<const std::string> defines,
                                                    Culling culling);

    /// Assigns slots to the plan's indexed draws. Multisampled frames are drawn unculled, as are frames with
    /// more indices than kLargestCapacity or without memory for them. Between frames.
    void prepare(const frame::FramePlan& plan, const RenderOptions& options, const RenderTarget& target);
    /// Error because of which culling or occlusion is off; none if both work.
    [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }
    /// Retries failed allocations, for a new scene.
    void tryAgain() {
        failures_ = 0;
        failure_.reset();
    }
    /// Draw commands of the frame; each has a slot.
    [[nodiscard]] std::uint32_t slotCount() const { return slotCount_; }
    /// Writes the runs of all slots into the frame's ring memory. Same plan and options as in `prepare`.
    void writeRuns(const frame::FramePlan& plan, const RenderOptions& options,
                   std::span<frame::gpu::SlotGroup> groups, std::span<frame::gpu::DrawRun> runs) const;
    [[nodiscard]] const BatchSlots& slotsOf(std::size_t batch) const { return slots_[batch]; }
    /// Whether draws use the static indices; otherwise only the kept ones.
    [[nodiscard]] bool drawsStaticIndices() const { return drawsStaticIndices_; }
    /// Whether batches from FramePlan::firstOccludee on are culled by cullOccluded.
    [[nodiscard]] bool usesOcclusion() const { return usesOcclusion_; }
    /// Buffer of the kept indices. Invalid until the first allocation.
    [[nodiscard]] BufferHandle keptIndices() const { return kept_.get(); }
    /// Sets the bindings of its own buffers.
    void bind(StorageBindings& storage) const;
    /// Sets the constants that the shader reads.
    void describe(frame::gpu::DeviceConstants& constants) const;
    /// Writes commands and indices of all batches, or with occlusion those before firstOccludee. Within a
    /// frame whose runs, pieces, commands and indices are bound.
    void cull();
    /// Writes those of the other batches. Requires usesOcclusion(), and that the earlier batches are drawn.
    void cullOccluded();

private:
    static constexpr std::size_t kIndexSize = sizeof(std::uint32_t);
    using CullPrograms = std::array<OwnedProgram, frame::gpu::kCullModes>; ///< of cull.comp, by mode
    DrawCulling(Device& device, CullPrograms programs, Culling culling)
        : device_(&device), programs_(std::move(programs)), culling_(culling), tiles_(device) {}
    [[nodiscard]] Result<void> reserve(std::size_t indices);
    /// True on success, else records the failure. Later frames retry, up to kMostFailures times.
    [[nodiscard]] bool isMade(const Result<void>& made);

    Device* device_;
    CullPrograms programs_;
    Culling culling_;
    DepthTiles tiles_;
    OwnedBuffer kept_;
    std::size_t capacity_ = 0;        ///< indices per frame
    std::size_t place_ = 0;           ///< index among the frames in flight
    bool drawsStaticIndices_ = false; ///< of this frame, like all that follow
    bool usesOcclusion_ = false;
    std::uint32_t slotCount_ = 0, firstOccludee_ = 0;
    std::uint32_t failures_ = 0;
    std::optional<Error> failure_;  ///< the latest
    std::vector<BatchSlots> slots_; ///< by batch
};

} // namespace limen::gpu
