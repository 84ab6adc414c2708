#pragma once

#include "frame/FramePlan.h"
#include "gpu/Device.h"
#include "gpu/RenderOptions.h"

namespace limen::gpu {

/// Leaves out triangles that cover no pixel's centre or face away, by a compute program (shaders/cull.comp). Never changes a
/// picture of exact outlines. Programs and memory are the device's, which must outlive it.
class TriangleCulling {
public:
    /// Errors: Driver, if the program does not build.
    [[nodiscard]] static Result<TriangleCulling> create(Device& device, std::span<const std::string> defines);
    TriangleCulling(TriangleCulling&& other) noexcept;
    TriangleCulling& operator=(TriangleCulling&& other) noexcept;
    ~TriangleCulling();

    /// Takes up what a frame draws by indices. False if their triangles are more than memory is kept for; the frame is then drawn
    /// as planned. Not during a frame.
    [[nodiscard]] bool prepare(const frame::FramePlan& plan, const RenderOptions& options);
    /// What to do, one for each indexed draw; of very many some are there twice.
    [[nodiscard]] std::span<const frame::gpu::CullTask> tasks() const { return tasks_; }
    /// The indices that are kept; the draws read these and no others.
    [[nodiscard]] StorageRange keptIndices() const {
        return {kept_, 0, capacity_ * kFramesInFlight * kIndexSize};
    }
    /// Within a frame whose tasks, commands and indices are bound: writes the commands and indices that are drawn.
    void run();

private:
    static constexpr std::size_t kIndexSize = sizeof(std::uint32_t);
    TriangleCulling(Device& device, ProgramHandle program) : device_(&device), program_(program) {}
    void addTasks(const frame::FramePlan& plan, const frame::Batch& batch);
    void reserve(std::size_t indices);
    /// Lays the tasks out in rows of equal length, none longer than drivers run.
    void fillRows();

    Device* device_ = nullptr;
    ProgramHandle program_ = ProgramHandle::Invalid;
    BufferHandle kept_ = BufferHandle::Invalid;
    std::size_t capacity_ = 0;             ///< indices a frame
    std::size_t slot_ = 0;                 ///< of the frames under way
    std::uint32_t indices_ = 0;            ///< of all tasks
    std::uint32_t columns_ = 0, rows_ = 1; ///< of the tasks
    std::vector<frame::gpu::CullTask> tasks_;
};

} // namespace limen::gpu
