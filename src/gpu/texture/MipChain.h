#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace limen::gpu {

/// One mip level: R,G,B,A bytes, top row first.
struct MipLevel {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Mip levels from the picture down to 1 x 1. Each texel is the mean of the 2 x 2 texels it covers (up to 3
/// with odd sizes), with colour weighted by alpha, so that the colour of transparent texels does not bleed
/// in. Independent of the driver. Requires width, height >= 1 and 4 bytes a texel.
[[nodiscard]] std::vector<MipLevel> mipChain(std::uint32_t width, std::uint32_t height,
                                             std::span<const std::uint8_t> rgba);

/// Number of levels of mipChain.
[[nodiscard]] std::uint32_t mipLevelCount(std::uint32_t width, std::uint32_t height);

/// Enlarges a picture by repeating texels. If the new size is a multiple, every smaller mip level and every
/// nearest texel equal the original's. Requires newWidth >= width and newHeight >= height.
[[nodiscard]] MipLevel enlarged(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba,
                                std::uint32_t newWidth, std::uint32_t newHeight);

/// A picture that repeats, given by its mipChain, at another size: its last level that is not smaller, bilinearly sampled
/// at the middles of the new texels. A level of the same size comes out as it is.
[[nodiscard]] MipLevel resized(std::span<const MipLevel> levels, std::uint32_t width, std::uint32_t height);

} // namespace limen::gpu
