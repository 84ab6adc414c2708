#pragma once

#include "frame/FramePlan.h"
#include "gpu/Device.h"

#include <array>

namespace limen::gpu {

/// Every storage binding of a frame, by number.
using StorageBindings = std::array<StorageRange, frame::gpu::kStorageBindings>;

/// What an empty array is bound as, bytes: a range may not be empty.
inline constexpr std::size_t kSmallestRange = 256;
/// Where one frame's arrays lie in the ring memory: the plan's, and the runs and room of its draw commands.
class FrameRing {
public:
    /// `slots`: one for each draw command. Has room for all of the plan's runs. `alignment`: Capabilities::storageAlignment. The plan must outlive it.
    FrameRing(const frame::FramePlan& plan, std::size_t slots, std::size_t alignment);

    [[nodiscard]] std::size_t size() const { return size_; } ///< bytes of ring memory
    [[nodiscard]] std::size_t commands() const { return places_[kCommands].offset; }

    [[nodiscard]] std::span<frame::gpu::SlotGroup> slotGroups(std::span<std::byte> memory) const;
    [[nodiscard]] std::span<frame::gpu::DrawRun> runs(std::span<std::byte> memory) const;

    /// Tells the shaders where the arrays are that they read as texels.
    void locate(frame::gpu::DeviceConstants& constants) const;
    /// Binds the arrays that shaders read as storage.
    void bind(StorageBindings& storage) const;
    /// Writes all arrays but runs, their groups and draw commands.
    void write(const frame::gpu::DeviceConstants& constants, std::span<std::byte> memory) const;

private:
    // In the order they are written.
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
        kSlotGroups, // written by whoever has them,
        kRuns,       // likewise,
        kCommands,   // and on the device
        kArrays
    };
    [[nodiscard]] std::span<const std::byte> bytes(Array array) const;
    [[nodiscard]] std::size_t sizeOf(Array array) const;
    [[nodiscard]] std::uint32_t texel(Array array) const;
    void writeInstances(std::span<frame::gpu::Instance> out) const;
    template <class T>
    [[nodiscard]] std::span<T> in(std::span<std::byte> memory, Array array) const;

    const frame::FramePlan& plan_;
    std::size_t slots_;
    std::array<StorageRange, kArrays> places_{}; ///< in the ring
    std::size_t size_ = 0;
};

} // namespace limen::gpu
