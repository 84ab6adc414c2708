#include "gpu/FrameRing.h"

#include "core/Assert.h"

#include <algorithm>
#include <cstring>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace limen::gpu {

namespace layout = frame::gpu;

namespace {

/// Prefetch distance in records, which are scattered in memory.
constexpr std::size_t kFetchedAhead = 16;

/// Bytes of records from which on they are written with non-temporal stores: half of a core's own cache. With
/// 100,000 dynamic instances this saves 50 of 700 microseconds; smaller arrays gain nothing.
constexpr std::size_t kPastCache = std::size_t{1} << 20;

#ifdef __SSE2__
/// RecordArray::copyTo with non-temporal stores.
void copyPastCache(const frame::RecordArray& records, std::uint32_t number, layout::Instance& out) {
    constexpr std::size_t kQuarters = sizeof out / sizeof(__m128i);
    static_assert(sizeof out % sizeof(__m128i) == 0 &&
                  offsetof(layout::Instance, highlight) == (kQuarters - 1) * sizeof(__m128i) + 8);
    const auto* const from = reinterpret_cast<const __m128i*>(records.at(number));
    auto* const to = reinterpret_cast<__m128i*>(&out);
    for (std::size_t i = 0; i + 1 < kQuarters; ++i)
        _mm_stream_si128(to + i, _mm_loadu_si128(from + i));
    const __m128i allButHighlight = _mm_set_epi32(-1, 0, -1, -1);
    _mm_stream_si128(to + kQuarters - 1,
                     _mm_and_si128(_mm_loadu_si128(from + kQuarters - 1), allButHighlight));
}
#endif

} // namespace

FrameRing::FrameRing(const frame::FramePlan& plan, std::size_t slots, std::size_t alignment)
    : plan_(plan), slots_(slots) {
    for (std::size_t i = 0; i < kArrays; ++i) {
        const std::size_t size = sizeOf(static_cast<Array>(i));
        const std::size_t offset = (size_ + alignment - 1) / alignment * alignment;
        places_[i] = {BufferHandle::Invalid, offset, std::max(size, kSmallestRange)};
        size_ = offset + places_[i].size;
    }
}

std::span<const std::byte> FrameRing::bytes(Array array, const layout::FrameConstants& constants) const {
    const auto of = [](const auto& values) { return std::as_bytes(std::span(values)); };
    switch (array) {
    case kConstants:
        return std::as_bytes(std::span(&constants, 1));
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
    case kMoverMembers:
        return of(plan_.moverMembers);
    case kReplacements:
        return of(plan_.replacements);
    case kPieces:
        return of(plan_.pieces);
    case kMovers:
    case kSlotGroups:
    case kRuns:
    case kCommands:
    case kArrays:
        break;
    }
    return {};
}

std::size_t FrameRing::sizeOf(Array array) const {
    switch (array) {
    case kMovers:
        return (plan_.movers.size() + plan_.records.size()) * sizeof(layout::Instance);
    case kSlotGroups:
        return (slots_ + layout::kSlotsPerGroup - 1) / layout::kSlotsPerGroup * sizeof(layout::SlotGroup);
    case kRuns:
        return plan_.runs.size() * sizeof(layout::DrawRun);
    case kCommands:
        return slots_ * sizeof(layout::DrawCommand);
    default:
        return bytes(array, plan_.constants).size();
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

std::uint32_t FrameRing::texel(Array array) const {
    return static_cast<std::uint32_t>(places_[array].offset / kBytesPerTexel);
}

void FrameRing::locate(layout::FrameConstants& constants) const {
    constants.firstBlock = texel(kBlocks);
    constants.firstRect = texel(kRects);
    constants.firstVisit = texel(kVisits);
    constants.firstMover = texel(kMovers);
    constants.firstMoverMember = texel(kMoverMembers);
    constants.firstReplacement = texel(kReplacements);
    constants.firstMoverPiece = texel(kPieces);
    constants.firstSlotGroup = texel(kSlotGroups);
    constants.firstRun = texel(kRuns);
}

void FrameRing::bind(StorageBindings& storage) const {
    storage[layout::kBindFrame] = places_[kConstants];
    storage[layout::kBindOwnership] = places_[kOwnership];
    storage[layout::kBindClipSets] = places_[kClipSets];
    storage[layout::kBindSky] = places_[kSky];
    storage[layout::kBindCommands] = places_[kCommands];
}

void FrameRing::write(const layout::FrameConstants& constants, std::span<std::byte> memory) const {
    for (std::size_t i = 0; i < kArrays; ++i) {
        const std::span<const std::byte> array = bytes(static_cast<Array>(i), constants);
        if (!array.empty())
            std::memcpy(memory.data() + places_[i].offset, array.data(), array.size());
    }
    writeMovers(in<layout::Instance>(memory, kMovers));
}

void FrameRing::writeMovers(std::span<layout::Instance> out) const {
#ifdef __SSE2__
    if (out.size_bytes() >= kPastCache) {
        LIMEN_ASSERT(reinterpret_cast<std::uintptr_t>(out.data()) % sizeof(__m128i) == 0,
                     "texel arrays are aligned to a texel");
        copyMovers(out, copyPastCache);
        _mm_sfence(); // visible to the GPU before the frame is drawn
    } else
#endif
    {
        copyMovers(out, [](const frame::RecordArray& records, std::uint32_t number, layout::Instance& to) {
            records.copyTo(to, number);
        });
    }
    for (const frame::MoverChange& change : plan_.moverChanges)
        change.applyTo(out[change.mover]);
    std::copy(plan_.records.begin(), plan_.records.end(),
              out.begin() + static_cast<std::ptrdiff_t>(plan_.movers.size()));
}

template <class Copy>
void FrameRing::copyMovers(std::span<layout::Instance> out, const Copy& copy) const {
    const std::vector<std::uint32_t>& movers = plan_.movers;
    for (std::size_t i = 0; i < movers.size(); ++i) {
        if (i + kFetchedAhead < movers.size()) {
            const std::byte* const next = plan_.moving.at(movers[i + kFetchedAhead]);
            __builtin_prefetch(next);
            __builtin_prefetch(next + sizeof(layout::Instance) - 1);
        }
        copy(plan_.moving, movers[i], out[i]);
    }
}

} // namespace limen::gpu
