#pragma once

#include "gpu/device/Owned.h"

namespace limen::gpu {

/// Where a compute program keeps how far a picture is covered, tile by tile. The device must outlive it.
class DepthTiles {
public:
    explicit DepthTiles(Device& device) : device_(&device) {}

    /// For a frame of that many pixels. Not during a frame. Errors: Driver, if there is no memory for them.
    [[nodiscard]] Result<void> prepare(std::uint32_t width, std::uint32_t height);
    /// Of this frame.
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// The depth of each, row by row from the bottom.
    [[nodiscard]] StorageRange range() const;

private:
    Device* device_;
    OwnedBuffer buffer_;
    std::uint32_t count_ = 0;
    std::size_t capacity_ = 0; ///< tiles a frame
    std::size_t place_ = 0;    ///< of the frames under way
};

} // namespace limen::gpu
