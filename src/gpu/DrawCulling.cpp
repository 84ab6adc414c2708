#include "gpu/DrawCulling.h"

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

bool isTaken(const frame::Batch& batch, const RenderOptions& options) {
    return isIndexed(batch.program) && isDrawn(batch.program, options);
}

std::size_t indicesOf(const frame::FramePlan& plan, const frame::Batch& batch) {
    std::size_t sum = 0;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
        sum += plan.runs[i].indexCount;
    }
    return sum;
}

} // namespace

Result<DrawCulling> DrawCulling::create(Device& device, std::span<const std::string> defines,
                                        bool leavesOut) {
    const ProgramSource source{
        .label = "cull", .defines = {defines.begin(), defines.end()}, .computeShader = "cull.comp"};
    const Result<ProgramHandle> program = device.createProgram(source);
    if (!program) {
        return tl::unexpected(program.error());
    }
    return DrawCulling(device, *program, leavesOut);
}

DrawCulling::DrawCulling(DrawCulling&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)), program_(other.program_), leavesOut_(other.leavesOut_),
      keepsTriangles_(other.keepsTriangles_), kept_(other.kept_), capacity_(other.capacity_),
      place_(other.place_), slotCount_(other.slotCount_), firstSlots_(std::move(other.firstSlots_)) {}

DrawCulling& DrawCulling::operator=(DrawCulling&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(program_, other.program_);
    std::swap(leavesOut_, other.leavesOut_);
    std::swap(keepsTriangles_, other.keepsTriangles_);
    std::swap(kept_, other.kept_);
    std::swap(capacity_, other.capacity_);
    std::swap(place_, other.place_);
    std::swap(slotCount_, other.slotCount_);
    std::swap(firstSlots_, other.firstSlots_);
    return *this;
}

DrawCulling::~DrawCulling() {
    if (device_ == nullptr) {
        return;
    }
    device_->destroyProgram(program_);
    if (kept_ != BufferHandle::Invalid) {
        device_->destroyBuffer(kept_);
    }
}

void DrawCulling::reserve(std::size_t indices) {
    if (kept_ != BufferHandle::Invalid && indices <= capacity_) {
        return;
    }
    if (kept_ != BufferHandle::Invalid) {
        device_->destroyBuffer(kept_);
    }
    capacity_ = std::clamp(indices + indices / 2, kSmallestCapacity, kLargestCapacity);
    kept_ = device_->createScratch("kept indices", capacity_ * kFramesInFlight * kIndexSize);
}

void DrawCulling::prepare(const frame::FramePlan& plan, const RenderOptions& options, bool keepsTriangles) {
    std::size_t indices = 0;
    slotCount_ = 0;
    firstSlots_.clear();
    for (const frame::Batch& batch : plan.batches) {
        firstSlots_.push_back(slotCount_);
        if (isTaken(batch, options)) {
            slotCount_ += batch.draws;
            indices += indicesOf(plan, batch);
        }
    }
    keepsTriangles_ = keepsTriangles || !leavesOut_ || indices > kLargestCapacity;
    if (!keepsTriangles_) {
        reserve(indices);
    }
    place_ = (place_ + 1) % kFramesInFlight; // frames before still read their own
}

void DrawCulling::writeSlots(const frame::FramePlan& plan, const RenderOptions& options,
                             std::span<frame::gpu::DrawSlot> slots) const {
    auto kept = static_cast<std::uint32_t>(place_ * capacity_);
    std::uint32_t slot = 0;
    for (const frame::Batch& batch : plan.batches) {
        for (std::uint32_t i = batch.first; isTaken(batch, options) && i < batch.first + batch.count; ++i) {
            const frame::PieceRun& run = plan.runs[i];
            LIMEN_ASSERT(run.pieceCount <= slots.size() - slot, "a batch counts the pieces of its runs");
            const frame::gpu::DrawSlot filled{run.firstPiece - slot, kept - run.indicesBefore};
            std::fill_n(slots.begin() + slot, run.pieceCount, filled);
            slot += run.pieceCount;
            kept += run.indexCount;
        }
    }
}

void DrawCulling::describe(frame::gpu::FrameConstants& constants) const {
    constants.slotCount = slotCount_;
    constants.flags |= keepsTriangles_ ? frame::gpu::kFrameKeepsTriangles : 0;
}

void DrawCulling::run() {
    // In rows of equal length, none longer than drivers run.
    const std::uint32_t rows = std::max((slotCount_ + kMostGroups - 1) / kMostGroups, 1u);
    device_->compute(program_, (slotCount_ + rows - 1) / rows, rows);
}

} // namespace limen::gpu
