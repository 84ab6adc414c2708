#pragma once

#include "frame/FramePlan.h"
#include "gpu/Device.h"
#include "gpu/RenderOptions.h"

namespace limen::gpu {

/// Makes the draw commands of a plan's pieces, on the device, and leaves out triangles that cover no pixel's centre or face
/// away, by a compute program (shaders/cull.comp). Never changes a picture of exact outlines. Programs and memory are the
/// device's, which must outlive it.
class DrawCulling {
public:
    /// `leavesOut`: whether triangles are ever left out. Errors: Driver, if the program does not build.
    [[nodiscard]] static Result<DrawCulling> create(Device& device, std::span<const std::string> defines,
                                                    bool leavesOut);
    DrawCulling(DrawCulling&& other) noexcept;
    DrawCulling& operator=(DrawCulling&& other) noexcept;
    ~DrawCulling();

    /// Takes up what a frame draws by indices. `keepsTriangles`: they are all drawn; so they are where there are more than memory
    /// is kept for. Not during a frame.
    void prepare(const frame::FramePlan& plan, const RenderOptions& options, bool keepsTriangles);
    /// How many draw commands that makes: each has a slot.
    [[nodiscard]] std::uint32_t slotCount() const { return slotCount_; }
    /// Fills in all slots, straight into the frame's memory. Plan and options are those of `prepare`.
    void writeSlots(const frame::FramePlan& plan, const RenderOptions& options,
                    std::span<frame::gpu::DrawSlot> slots) const;
    /// The slot of a batch's first draw command; those of the others follow.
    [[nodiscard]] std::uint32_t firstSlot(std::size_t batch) const { return firstSlots_[batch]; }
    /// Whether the draws read the static indices; else they read those that are kept, and no others.
    [[nodiscard]] bool keepsTriangles() const { return keepsTriangles_; }
    /// The indices that are kept. Invalid while none ever were.
    [[nodiscard]] StorageRange keptIndices() const {
        return {kept_, 0, capacity_ * kFramesInFlight * kIndexSize};
    }
    /// Tells the shader what is to be done.
    void describe(frame::gpu::FrameConstants& constants) const;
    /// Within a frame whose slots, pieces, commands and indices are bound: writes the commands and indices that are drawn.
    void run();

private:
    static constexpr std::size_t kIndexSize = sizeof(std::uint32_t);
    DrawCulling(Device& device, ProgramHandle program, bool leavesOut)
        : device_(&device), program_(program), leavesOut_(leavesOut) {}
    void reserve(std::size_t indices);

    Device* device_ = nullptr;
    ProgramHandle program_ = ProgramHandle::Invalid;
    bool leavesOut_ = true;
    bool keepsTriangles_ = false; ///< this frame's
    BufferHandle kept_ = BufferHandle::Invalid;
    std::size_t capacity_ = 0; ///< indices a frame
    std::size_t place_ = 0;    ///< of the frames under way
    std::uint32_t slotCount_ = 0;
    std::vector<std::uint32_t> firstSlots_; ///< by batch
};

} // namespace limen::gpu
