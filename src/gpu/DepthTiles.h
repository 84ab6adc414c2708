#pragma once

#include "gpu/Owned.h"

#include <span>
#include <string>

namespace limen::gpu {

/// How far a picture is covered so far, tile by tile, found on the device (shaders/tiles.comp). The device must outlive it.
class DepthTiles {
public:
    /// Errors: Driver, if the program does not build.
    [[nodiscard]] static Result<DepthTiles> create(Device& device, std::span<const std::string> defines);

    /// For a frame of that many pixels. Not during a frame.
    void prepare(std::uint32_t width, std::uint32_t height);
    /// Where the frame's are: the farthest depth of each, row by row from the bottom.
    [[nodiscard]] StorageRange range() const;
    /// Within a frame, between draws: from the depth of what has been drawn.
    void run();

private:
    DepthTiles(Device& device, OwnedProgram program) : device_(&device), program_(std::move(program)) {}

    Device* device_;
    OwnedProgram program_;
    OwnedBuffer buffer_;
    std::uint32_t columns_ = 0, rows_ = 0; ///< tiles of this frame
    std::size_t capacity_ = 0;             ///< tiles a frame
    std::size_t place_ = 0;                ///< of the frames under way
};

} // namespace limen::gpu
