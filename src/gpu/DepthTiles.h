#pragma once

#include "gpu/device/Owned.h"

namespace limen::gpu {

/// Buffer for the farthest depth of each tile of a picture (shaders/cull.comp, kTileLayers). The device
/// must outlive it.
class DepthTiles {
public:
    explicit DepthTiles(Device& device) : device_(&device) {}

    /// Reserves tiles for a picture of this size. Between frames. Errors: Driver, if out of memory.
    [[nodiscard]] Result<void> prepare(std::uint32_t width, std::uint32_t height);
    /// Tiles of this frame.
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Their depths, row by row from the bottom.
    [[nodiscard]] StorageRange range() const;

private:
    Device* device_;
    OwnedBuffer buffer_;
    std::uint32_t count_ = 0;
    std::size_t capacity_ = 0; ///< tiles per frame
    std::size_t place_ = 0;    ///< index among the frames in flight
};

} // namespace limen::gpu
