#include "gpu/DrawCulling.h"

#include "core/Assert.h"

#include <algorithm>
#include <utility>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr std::size_t kSmallestCapacity = std::size_t{1} << 18; // indices per frame
// All frames in flight share one storage range. 128 MiB is the least MAX_SHADER_STORAGE_BLOCK_SIZE of OpenGL
// 4.5.
constexpr std::size_t kLargestCapacity = (std::size_t{1} << 27) / sizeof(std::uint32_t) / kFramesInFlight;

// Failed allocations before it stops retrying.
constexpr std::uint32_t kMostFailures = 3;

std::size_t indicesOf(const frame::FramePlan& plan, const frame::Batch& batch) {
    std::size_t sum = 0;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i)
        sum += plan.runs[i].indexCount;
    return sum;
}

/// Adds a run's slots to their groups. Writes only, because reading mapped memory may be slow.
void addToGroups(const layout::RunOffsets& offsets, std::uint32_t run, std::uint32_t firstSlot,
                 std::uint32_t count, std::span<layout::SlotGroup> groups) {
    std::uint32_t group = firstSlot / layout::kSlotsPerGroup;
    if (firstSlot % layout::kSlotsPerGroup != 0)
        groups[group++].lastRun = run;
    for (; group * layout::kSlotsPerGroup < firstSlot + count; ++group)
        groups[group] = {offsets, run, run};
}

} // namespace

Result<DrawCulling> DrawCulling::create(Device& device, std::span<const std::string> defines, Culling which) {
    // One program object per mode, from one source, so that selecting a mode costs a frame no call beside
    // glUseProgram. Programs that use different buffers crash zink (Mesa 25):
    // docs/decisions/0119-culling-mode-is-a-uniform.md.
    constexpr std::array<const char*, layout::kCullModes> kNames{"cull occluders", "cull occludees"};
    CullPrograms programs;
    for (std::uint32_t mode = 0; mode < layout::kCullModes; ++mode) {
        const Result<ProgramHandle> program =
            device.createProgram({.label = kNames[mode],
                                  .defines = {defines.begin(), defines.end()},
                                  .computeShader = "cull.comp",
                                  .uniforms = {{layout::kUniformCullMode, mode}}});
        if (!program)
            return Failure(program.error());
        programs[mode] = OwnedProgram(device, *program);
    }
    return DrawCulling(device, std::move(programs), which);
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
    assignSlots(plan, options, slots_);
    slotCount_ = slots_.empty() ? 0 : slots_.back().end;
    std::size_t indices = 0;
    for (const frame::Batch& batch : plan.batches)
        indices += hasSlots(batch, options) ? indicesOf(plan, batch) : 0;
    drawsStaticIndices_ =
        target.options().samples > 0 || culling_ == Culling::None || indices > kLargestCapacity;
    drawsStaticIndices_ = drawsStaticIndices_ || failures_ >= kMostFailures || !isMade(reserve(indices));
    firstOccludee_ = slotCount_;
    usesOcclusion_ = culling_ == Culling::Hidden && options.occlusion && !drawsStaticIndices_ &&
                     !target.isTile() && isMade(tiles_.prepare(target.width(), target.height()));
    if (usesOcclusion_) {
        if (plan.firstOccludee < slots_.size())
            firstOccludee_ = slots_[plan.firstOccludee].first;
    }
    place_ = (place_ + 1) % kFramesInFlight; // earlier frames still read theirs
}

void DrawCulling::bind(StorageBindings& storage) const {
    // Without culling or occlusion nothing writes these buffers, but every frame makes the same calls.
    const StorageRange& nothing = storage[layout::kBindIndices];
    storage[layout::kBindKeptIndices] =
        drawsStaticIndices_ ? nothing
                            : StorageRange{kept_.get(), 0, capacity_ * kFramesInFlight * kIndexSize};
    storage[layout::kBindTiles] = usesOcclusion_ ? tiles_.range() : nothing;
}

void DrawCulling::writeRuns(const frame::FramePlan& plan, const RenderOptions& options,
                            std::span<layout::SlotGroup> groups, std::span<layout::DrawRun> runs) const {
    auto kept = static_cast<std::uint32_t>(place_ * capacity_);
    std::uint32_t slot = 0, number = 0;
    for (const frame::Batch& batch : plan.batches) {
        for (std::uint32_t i = batch.first; hasSlots(batch, options) && i < batch.first + batch.count; ++i) {
            const frame::PieceRun& run = plan.runs[i];
            const std::uint32_t toPiece = (run.firstPiece - slot) & ~layout::kGated;
            const layout::RunOffsets offsets{toPiece | (run.gated ? layout::kGated : 0),
                                             kept - run.indicesBefore};
            runs[number] = {offsets, slot, run.rects.first | std::uint32_t{run.rects.count} << 16};
            addToGroups(offsets, number, slot, run.pieceCount, groups);
            slot += run.pieceCount;
            kept += run.indexCount;
            ++number;
        }
    }
    LIMEN_ASSERT(slot == slotCount_, "a batch's draws are the pieces of its runs");
}

void DrawCulling::describe(layout::DeviceConstants& constants) const {
    constants.slotCount = slotCount_;
    constants.firstOccludee = firstOccludee_;
    constants.flags |= drawsStaticIndices_ ? layout::kFrameStaticIndices : 0;
}

void DrawCulling::cull() {
    device_->compute(programs_[layout::kCullOccluders].get(), WorkGroups::atLeast(firstOccludee_));
}

void DrawCulling::cullOccluded() {
    LIMEN_ASSERT(usesOcclusion_, "all slots were culled first");
    constexpr std::uint32_t kThreads = layout::kCullThreads;
    device_->readDrawn();                                                  // the depth so far
    const ProgramHandle program = programs_[layout::kCullOccludees].get(); // of both, which saves a GL call
    device_->compute(program,
                     WorkGroups::atLeast((tiles_.count() + kThreads - 1) / kThreads, layout::kTileLayers));
    device_->compute(program, WorkGroups::atLeast(slotCount_ - firstOccludee_));
}

} // namespace limen::gpu
