#include "gpu/FrameRing.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace limen::gpu {

namespace layout = frame::gpu;

static_assert(std::has_single_bit(sizeof(layout::DrawRecord)),
              "a multiple of the larger of two alignments is one of both");

void writeInstances(const frame::FramePlan& plan, std::span<layout::Instance> out) {
    const std::size_t dynamic = plan.dynamicInstances.size();
    if (dynamic > 0)
        plan.dynamicRecords.write(plan.dynamicRecords.instances, plan.dynamicInstances, out.first(dynamic));
    for (const frame::DynamicChange& change : plan.dynamicChanges)
        change.applyTo(out[change.instance]);
    std::copy(plan.records.begin(), plan.records.end(), out.begin() + static_cast<std::ptrdiff_t>(dynamic));
}

FrameRing::FrameRing(const frame::FramePlan& plan, std::size_t slots, std::size_t alignment, RingUse use)
    : plan_(plan), slots_(slots), use_(use) {
    for (std::size_t i = 0; i < kArrays; ++i) {
        const std::size_t size = sizeOf(static_cast<Array>(i));
        // Records are found by their number in the ring (Device::baseInstanceAt).
        const std::size_t step = i == kRecords ? std::max(alignment, sizeof(layout::DrawRecord)) : alignment;
        const std::size_t offset = (size_ + step - 1) / step * step;
        places_[i] = {BufferHandle::Invalid, offset, std::max(size, kSmallestRange)};
        size_ = offset + places_[i].size;
    }
}

std::span<const std::byte> FrameRing::bytes(Array array) const {
    const auto of = [](const auto& values) { return std::as_bytes(std::span(values)); };
    switch (array) {
    case kBlocks:
        return of(plan_.blocks);
    case kRects:
        return of(plan_.rects);
    case kVisits:
        return of(plan_.visits);
    case kOwnership:
        return of(plan_.ownershipVertices);
    case kClipSets:
        return of(plan_.clipSets);
    case kSky:
        return of(plan_.skyInstances);
    case kMembers:
        return of(plan_.members);
    case kReplacements:
        return of(plan_.replacements);
    case kPieces:
        return of(plan_.pieces);
    case kLamps:
        return of(plan_.lamps);
    case kConstants:
    case kInstances:
    case kSlotGroups:
    case kRuns:
    case kCommands:
    case kRecords:
    case kArrays:
        break;
    }
    return {};
}

std::size_t FrameRing::sizeOf(Array array) const {
    const bool records = use_ == RingUse::DrawRecords;
    switch (array) {
    case kConstants:
        return sizeof(layout::FrameConstants);
    case kInstances:
        return records ? 0
                       : (plan_.dynamicInstances.size() + plan_.records.size()) * sizeof(layout::Instance);
    case kSlotGroups:
        return records ? 0
                       : (slots_ + layout::kSlotsPerGroup - 1) / layout::kSlotsPerGroup *
                             sizeof(layout::SlotGroup);
    case kRuns:
        return records ? 0 : plan_.runs.size() * sizeof(layout::DrawRun);
    case kRecords:
        return records ? slots_ * sizeof(layout::DrawRecord) : 0;
    case kCommands:
        return slots_ * sizeof(layout::DrawCommand);
    default:
        return bytes(array).size();
    }
}

template <class T>
std::span<T> FrameRing::in(std::span<std::byte> memory, Array array) const {
    return {reinterpret_cast<T*>(memory.data() + places_[array].offset), sizeOf(array) / sizeof(T)};
}

std::span<layout::SlotGroup> FrameRing::slotGroups(std::span<std::byte> memory) const {
    return in<layout::SlotGroup>(memory, kSlotGroups);
}

std::span<layout::DrawRun> FrameRing::runs(std::span<std::byte> memory) const {
    return in<layout::DrawRun>(memory, kRuns);
}

std::span<layout::DrawCommand> FrameRing::commands(std::span<std::byte> memory) const {
    return in<layout::DrawCommand>(memory, kCommands);
}

std::span<layout::DrawRecord> FrameRing::records(std::span<std::byte> memory) const {
    return in<layout::DrawRecord>(memory, kRecords);
}

std::uint32_t FrameRing::texel(Array array) const {
    return static_cast<std::uint32_t>(places_[array].offset / kBytesPerTexel);
}

void FrameRing::locate(layout::DeviceConstants& constants) const {
    constants.firstBlock = texel(kBlocks);
    constants.firstRect = texel(kRects);
    constants.firstVisit = texel(kVisits);
    constants.firstInstance = texel(kInstances);
    constants.firstMember = texel(kMembers);
    constants.firstReplacement = texel(kReplacements);
    constants.firstPiece = texel(kPieces);
    constants.firstSlotGroup = texel(kSlotGroups);
    constants.firstRun = texel(kRuns);
    constants.firstLamp = texel(kLamps);
}

void FrameRing::bind(StorageBindings& storage) const {
    storage[layout::kBindFrame] = places_[kConstants];
    storage[layout::kBindOwnership] = places_[kOwnership];
    storage[layout::kBindClipSets] = places_[kClipSets];
    storage[layout::kBindSky] = places_[kSky];
    storage[layout::kBindCommands] = places_[kCommands];
}

void FrameRing::write(const layout::DeviceConstants& constants, std::span<std::byte> memory) const {
    const layout::FrameConstants both{plan_.constants, constants};
    const std::span<const std::byte> raw = std::as_bytes(std::span(&both, 1));
    std::copy(raw.begin(), raw.end(), memory.data() + places_[kConstants].offset);
    for (std::size_t i = 0; i < kArrays; ++i) {
        const std::span<const std::byte> array = bytes(static_cast<Array>(i));
        if (!array.empty())
            std::memcpy(memory.data() + places_[i].offset, array.data(), array.size());
    }
    if (use_ != RingUse::DrawRecords)
        writeInstances(plan_, in<layout::Instance>(memory, kInstances));
}

} // namespace limen::gpu
