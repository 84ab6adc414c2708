#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace limen::gpu {

/// One level of a picture: R,G,B,A bytes, top row first.
struct MipLevel {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Levels from the picture itself down to 1 x 1; each texel is the mean of the two by two (by odd sizes: up
/// to three) that it covers. Colour is weighted by alpha, so that hidden colours of transparent texels do not
/// bleed in. The same bytes on every machine, whatever the driver. Requires width, height >= 1 and 4 bytes a
/// texel.
[[nodiscard]] std::vector<MipLevel> mipChain(std::uint32_t width, std::uint32_t height,
                                             std::span<const std::uint8_t> rgba);

/// Number of levels mipChain yields.
[[nodiscard]] std::uint32_t mipLevelCount(std::uint32_t width, std::uint32_t height);

/// The picture at a larger size by repeating texels: when the size is a multiple, every smaller mip and every
/// nearest texel are those of the original. Requires newWidth >= width and newHeight >= height.
[[nodiscard]] MipLevel enlarged(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba,
                                std::uint32_t newWidth, std::uint32_t newHeight);

} // namespace limen::gpu
