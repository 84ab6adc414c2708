#pragma once

#include "frame/FramePlan.h"
#include "gpu/device/Device.h"

#include <array>

namespace limen::gpu {

/// Where the records of a frame's draws are made: by shaders, from instances and runs; or on the CPU, a record
/// for each slot.
enum class RingUse { Instances, DrawRecords };

/// Writes the plan's instances: the dynamic ones with their changes, then its records.
void writeInstances(const frame::FramePlan& plan, std::span<frame::gpu::Instance> out);

/// Layout of one frame's arrays in the ring memory: those of the plan, its runs, and its draw commands.
class FrameRing {
public:
    /// `slots`: number of draw commands. `alignment`: Capabilities::storageAlignment. The plan must outlive
    /// it.
    FrameRing(const frame::FramePlan& plan, std::size_t slots, std::size_t alignment,
              RingUse use = RingUse::Instances);

    [[nodiscard]] std::size_t size() const { return size_; } ///< bytes of ring memory
    [[nodiscard]] std::size_t commands() const { return places_[kCommands].offset; }
    [[nodiscard]] std::size_t records() const { return places_[kRecords].offset; }

    [[nodiscard]] std::span<frame::gpu::SlotGroup> slotGroups(std::span<std::byte> memory) const;
    [[nodiscard]] std::span<frame::gpu::DrawRun> runs(std::span<std::byte> memory) const;
    [[nodiscard]] std::span<frame::gpu::DrawCommand> commands(std::span<std::byte> memory) const;
    [[nodiscard]] std::span<frame::gpu::DrawRecord> records(std::span<std::byte> memory) const;

    /// Sets the first texel of each array that shaders read as texels.
    void locate(frame::gpu::DeviceConstants& constants) const;
    /// Sets the bindings of the arrays that shaders read as storage.
    void bind(StorageBindings& storage) const;

    /// Writes the plan's own arrays, and instances unless the CPU makes draw records.
    void write(const frame::gpu::DeviceConstants& constants, std::span<std::byte> memory) const;

private:
    // In the order of writing.
    enum Array : std::size_t {
        kConstants,
        kBlocks,
        kRects,
        kVisits,
        kOwnership,
        kClipSets,
        kSky,
        kInstances,
        kMembers,
        kReplacements,
        kPieces,
        kLamps,
        kSlotGroups, // written by DrawCulling
        kRuns,       // written by DrawCulling
        kCommands,   // written on the GPU or by FastDraws
        kRecords,    // written by FastDraws
        kArrays
    };
    [[nodiscard]] std::span<const std::byte> bytes(Array array) const;
    [[nodiscard]] std::size_t sizeOf(Array array) const;
    [[nodiscard]] std::uint32_t texel(Array array) const;
    template <class T>
    [[nodiscard]] std::span<T> in(std::span<std::byte> memory, Array array) const;

    const frame::FramePlan& plan_;
    std::size_t slots_;
    RingUse use_;
    std::array<StorageRange, kArrays> places_{}; ///< in the ring
    std::size_t size_ = 0;
};

} // namespace limen::gpu
