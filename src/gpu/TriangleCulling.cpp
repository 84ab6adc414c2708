#include "gpu/TriangleCulling.h"

#include "core/Assert.h"
#include "gpu/Programs.h"

#include <algorithm>
#include <utility>

namespace limen::gpu {
namespace {

constexpr std::size_t kSmallestCapacity = std::size_t{1} << 18; // indices a frame
// All frames under way share one storage range, and 128 MiB is the longest that every driver reads and writes
// (the least MAX_SHADER_STORAGE_BLOCK_SIZE of OpenGL 4.5).
constexpr std::size_t kLargestCapacity = (std::size_t{1} << 27) / sizeof(std::uint32_t) / kFramesInFlight;

bool isIndexed(frame::Program program) {
    return program != frame::Program::Ownership && program != frame::Program::SkyPlain;
}

std::size_t indicesOf(const frame::FramePlan& plan) {
    std::size_t sum = 0;
    for (const frame::gpu::DrawCommand& command : plan.commands) {
        sum += command.indexCount;
    }
    return sum;
}

} // namespace

Result<TriangleCulling> TriangleCulling::create(Device& device, std::span<const std::string> defines) {
    const ProgramSource source{
        .label = "cull", .defines = {defines.begin(), defines.end()}, .computeShader = "cull.comp"};
    const Result<ProgramHandle> program = device.createProgram(source);
    if (!program) {
        return tl::unexpected(program.error());
    }
    return TriangleCulling(device, *program);
}

TriangleCulling::TriangleCulling(TriangleCulling&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)), program_(other.program_), kept_(other.kept_),
      capacity_(other.capacity_), slot_(other.slot_), indices_(other.indices_), columns_(other.columns_),
      rows_(other.rows_), tasks_(std::move(other.tasks_)) {}

TriangleCulling& TriangleCulling::operator=(TriangleCulling&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(program_, other.program_);
    std::swap(kept_, other.kept_);
    std::swap(capacity_, other.capacity_);
    std::swap(slot_, other.slot_);
    std::swap(indices_, other.indices_);
    std::swap(columns_, other.columns_);
    std::swap(rows_, other.rows_);
    std::swap(tasks_, other.tasks_);
    return *this;
}

TriangleCulling::~TriangleCulling() {
    if (device_ == nullptr) {
        return;
    }
    device_->destroyProgram(program_);
    if (kept_ != BufferHandle::Invalid) {
        device_->destroyBuffer(kept_);
    }
}

void TriangleCulling::reserve(std::size_t indices) {
    if (kept_ != BufferHandle::Invalid && indices <= capacity_) {
        return;
    }
    if (kept_ != BufferHandle::Invalid) {
        device_->destroyBuffer(kept_);
    }
    capacity_ = std::clamp(indices + indices / 2, kSmallestCapacity, kLargestCapacity);
    kept_ = device_->createScratch("kept indices", capacity_ * kFramesInFlight * kIndexSize);
}

bool TriangleCulling::prepare(const frame::FramePlan& plan, const RenderOptions& options) {
    const std::size_t indices = indicesOf(plan);
    if (indices > kLargestCapacity) {
        return false;
    }
    reserve(indices);
    slot_ = (slot_ + 1) % kFramesInFlight; // frames before still read their own
    tasks_.clear();
    indices_ = 0;
    for (const frame::Batch& batch : plan.batches) {
        if (isIndexed(batch.program) && isDrawn(batch.program, options)) {
            addTasks(plan, batch);
        }
    }
    fillRows();
    return true;
}

void TriangleCulling::addTasks(const frame::FramePlan& plan, const frame::Batch& batch) {
    // Sky objects are infinitely far, and drawn in a way of their own.
    const std::uint32_t keepsAll = batch.program == frame::Program::SkyObjects ? frame::gpu::kKeepsAll : 0;
    for (std::uint32_t i = batch.firstCommand; i < batch.firstCommand + batch.commandCount; ++i) {
        const frame::gpu::DrawCommand& command = plan.commands[i];
        LIMEN_ASSERT(command.indexCount / 3 <= frame::gpu::kTrianglesPerCommand, "a work group's worth");
        frame::gpu::CullTask task;
        task.indices = {command.firstIndex, command.indexCount / 3,
                        static_cast<std::uint32_t>(slot_ * capacity_) + indices_, keepsAll};
        task.drawing = {i, static_cast<std::uint32_t>(command.baseVertex), command.baseInstance, 0};
        tasks_.push_back(task);
        indices_ += command.indexCount;
    }
}

void TriangleCulling::fillRows() {
    const auto count = static_cast<std::uint32_t>(tasks_.size());
    rows_ = std::max((count + kMostGroups - 1) / kMostGroups, 1u);
    columns_ = (count + rows_ - 1) / rows_;
    if (count > 0) {
        tasks_.resize(std::size_t{rows_} * columns_,
                      tasks_.back()); // once more is no harm: it writes the same
    }
}

void TriangleCulling::run() {
    device_->compute(program_, columns_, rows_);
}

} // namespace limen::gpu
