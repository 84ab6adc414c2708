#include "gpu/DrawCulling.h"

#include "core/Assert.h"
#include "gpu/Programs.h"

#include <algorithm>
#include <utility>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr std::size_t kSmallestCapacity = std::size_t{1} << 18; // indices a frame
// All frames under way share one storage range, and 128 MiB is the longest that every driver reads and writes
// (the least MAX_SHADER_STORAGE_BLOCK_SIZE of OpenGL 4.5).
constexpr std::size_t kLargestCapacity = (std::size_t{1} << 27) / sizeof(std::uint32_t) / kFramesInFlight;

// Times that memory is asked for in vain.
constexpr std::uint32_t kMostFailures = 3;

bool isIndexed(frame::Program program) {
    return program != frame::Program::Ownership && program != frame::Program::SkyPlain;
}

bool isTaken(const frame::Batch& batch, const RenderOptions& options) {
    return isIndexed(batch.program) && isDrawn(batch.program, options);
}

std::size_t indicesOf(const frame::FramePlan& plan, const frame::Batch& batch) {
    std::size_t sum = 0;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i)
        sum += plan.runs[i].indexCount;
    return sum;
}

/// Of a run's slots. Only writes: the memory may be slow to read.
void addToGroups(const layout::RunPlace& place, std::uint32_t run, std::uint32_t firstSlot,
                 std::uint32_t count, std::span<layout::SlotGroup> groups) {
    std::uint32_t group = firstSlot / layout::kSlotsPerGroup;
    if (firstSlot % layout::kSlotsPerGroup != 0)
        groups[group++].lastRun = run;
    for (; group * layout::kSlotsPerGroup < firstSlot + count; ++group)
        groups[group] = {place, run, run};
}

} // namespace

Result<DrawCulling> DrawCulling::create(Device& device, std::span<const std::string> defines, Culling which) {
    const ProgramSource source{
        .label = "cull", .defines = {defines.begin(), defines.end()}, .computeShader = "cull.comp"};
    return device.createProgram(source).map(
        [&](ProgramHandle program) { return DrawCulling(device, OwnedProgram(device, program), which); });
}

Result<void> DrawCulling::reserve(std::size_t indices) {
    if (!kept_.empty() && indices <= capacity_)
        return {};
    capacity_ = std::clamp(indices + indices / 2, kSmallestCapacity, kLargestCapacity);
    kept_.reset();
    return device_->createScratch("kept indices", capacity_ * kFramesInFlight * kIndexSize)
        .map([&](BufferHandle buffer) {
            kept_ = {*device_, buffer};
        });
}

bool DrawCulling::isMade(const Result<void>& made) {
    if (!made) {
        ++failures_;
        failure_ = made.error();
    }
    return made.has_value();
}

void DrawCulling::prepare(const frame::FramePlan& plan, const RenderOptions& options,
                          const RenderTarget& target) {
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
    keepsTriangles_ = target.options().samples > 0 || culling_ == Culling::None || indices > kLargestCapacity;
    keepsTriangles_ = keepsTriangles_ || failures_ >= kMostFailures || !isMade(reserve(indices));
    firstHideable_ = slotCount_;
    leavesOutHidden_ = culling_ == Culling::Hidden && options.occlusion && !keepsTriangles_ &&
                       isMade(tiles_.prepare(target.width(), target.height()));
    if (leavesOutHidden_) {
        if (plan.firstHideable < firstSlots_.size())
            firstHideable_ = firstSlots_[plan.firstHideable];
    }
    place_ = (place_ + 1) % kFramesInFlight; // frames before still read their own
}

void DrawCulling::bind(StorageBindings& storage) const {
    // Where all triangles are kept nobody writes them, and where none is hidden no tiles; all frames make the same calls.
    const StorageRange& nothing = storage[layout::kBindIndices];
    storage[layout::kBindKeptIndices] =
        keepsTriangles_ ? nothing : StorageRange{kept_.get(), 0, capacity_ * kFramesInFlight * kIndexSize};
    storage[layout::kBindTiles] = leavesOutHidden_ ? tiles_.range() : nothing;
}

void DrawCulling::writeRuns(const frame::FramePlan& plan, const RenderOptions& options,
                            std::span<layout::SlotGroup> groups, std::span<layout::DrawRun> runs) const {
    auto kept = static_cast<std::uint32_t>(place_ * capacity_);
    std::uint32_t slot = 0, number = 0;
    for (const frame::Batch& batch : plan.batches) {
        for (std::uint32_t i = batch.first; isTaken(batch, options) && i < batch.first + batch.count; ++i) {
            const frame::PieceRun& run = plan.runs[i];
            const std::uint32_t toPiece = (run.firstPiece - slot) & ~layout::kGated;
            const layout::RunPlace place{toPiece | (run.gated ? layout::kGated : 0),
                                         kept - run.indicesBefore};
            runs[number] = {place, slot, run.rects.first | std::uint32_t{run.rects.count} << 16};
            addToGroups(place, number, slot, run.pieceCount, groups);
            slot += run.pieceCount;
            kept += run.indexCount;
            ++number;
        }
    }
    LIMEN_ASSERT(slot == slotCount_, "batches count the pieces of their runs");
}

void DrawCulling::describe(layout::DeviceConstants& constants) const {
    constants.slotCount = slotCount_;
    constants.firstHideable = firstHideable_;
    constants.flags |= keepsTriangles_ ? layout::kFrameKeepsTriangles : 0;
}

void DrawCulling::run(std::uint32_t purpose, std::uint32_t groups) {
    // In rows of equal length, none longer than drivers run.
    const std::uint32_t rows = std::max((groups + purpose * kMostGroups - 1) / (purpose * kMostGroups), 1u);
    const std::uint32_t columns = (groups + rows * purpose - 1) / (rows * purpose);
    device_->compute(program_.get(), {columns, rows, purpose});
}

void DrawCulling::runFirst() {
    run(layout::kCullFirst, firstHideable_);
}

void DrawCulling::runBehind() {
    LIMEN_ASSERT(leavesOutHidden_, "all slots were run first");
    constexpr std::uint32_t kThreads = layout::kCullThreads;
    run(layout::kCullTiles, (tiles_.count() + kThreads - 1) / kThreads);
    run(layout::kCullBehind, slotCount_ - firstHideable_);
}

} // namespace limen::gpu
