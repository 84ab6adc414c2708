#include "world/texture/Dxt.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>

namespace limen::world {
namespace {

using Texel = std::array<std::uint8_t, 4>;

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at] | bytes[at + 1] << 8);
}

Texel expand565(std::uint32_t c) {
    const std::uint32_t r = c >> 11, g = (c >> 5) & 63, b = c & 31;
    return {static_cast<std::uint8_t>(r << 3 | r >> 2), static_cast<std::uint8_t>(g << 2 | g >> 4),
            static_cast<std::uint8_t>(b << 3 | b >> 2), 255};
}

Texel mix(const Texel& a, const Texel& b, unsigned wa, unsigned wb) {
    Texel out{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = static_cast<std::uint8_t>((a[i] * wa + b[i] * wb) / (wa + wb));
    return out;
}

/// The four colours of a block. In DXT1, if the first is not greater than the second, the last one is
/// transparent.
std::array<Texel, 4> colours(std::span<const std::uint8_t> block, bool punchThrough) {
    const std::uint32_t c0 = word(block, 0), c1 = word(block, 2);
    const Texel a = expand565(c0), b = expand565(c1);
    if (punchThrough && c0 <= c1)
        return {a, b, mix(a, b, 1, 1), Texel{0, 0, 0, 0}};
    return {a, b, mix(a, b, 2, 1), mix(a, b, 1, 2)};
}

std::array<std::uint8_t, 8> alphas(std::span<const std::uint8_t> block) {
    const unsigned a = block[0], b = block[1];
    std::array<std::uint8_t, 8> out{block[0], block[1], 0, 0, 0, 0, 0, 255};
    const unsigned steps = a > b ? 7 : 5;
    for (unsigned i = 1; i < steps; ++i)
        out[i + 1] = static_cast<std::uint8_t>(((steps - i) * a + i * b) / steps);
    return out;
}

std::uint8_t alphaOf(DxtKind kind, std::span<const std::uint8_t> block, unsigned texel) {
    if (kind == DxtKind::Dxt3)
        return static_cast<std::uint8_t>((block[texel / 2] >> (texel % 2 * 4) & 15) * 17);
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < 6; ++i)
        bits |= static_cast<std::uint64_t>(block[2 + i]) << (8 * i);
    return alphas(block)[bits >> (3 * texel) & 7];
}

void decodeBlock(DxtKind kind, std::span<const std::uint8_t> block, std::array<Texel, 16>& out) {
    const std::span<const std::uint8_t> colour = kind == DxtKind::Dxt1 ? block : block.subspan(8);
    const std::array<Texel, 4> table = colours(colour, kind == DxtKind::Dxt1);
    for (unsigned i = 0; i < 16; ++i) {
        out[i] = table[colour[4 + i / 4] >> (i % 4 * 2) & 3];
        if (kind != DxtKind::Dxt1)
            out[i][3] = alphaOf(kind, block, i);
    }
}

} // namespace

void decodeDxt(DxtKind kind, std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> blocks,
               std::span<std::uint8_t> rgba) {
    const std::size_t blockBytes = kind == DxtKind::Dxt1 ? 8 : 16;
    LIMEN_ASSERT(blocks.size() >= std::size_t{(width + 3) / 4} * ((height + 3) / 4) * blockBytes,
                 "the blocks cover the picture");
    LIMEN_ASSERT(rgba.size() == std::size_t{width} * height * 4, "four bytes a texel");
    std::array<Texel, 16> texels;
    std::size_t at = 0;
    for (std::uint32_t blockY = 0; blockY < height; blockY += 4) {
        for (std::uint32_t blockX = 0; blockX < width; blockX += 4, at += blockBytes) {
            decodeBlock(kind, blocks.subspan(at, blockBytes), texels);
            for (std::uint32_t y = blockY; y < blockY + 4 && y < height; ++y) {
                for (std::uint32_t x = blockX; x < blockX + 4 && x < width; ++x) {
                    const Texel& t = texels[(y - blockY) * 4 + x - blockX];
                    std::copy(t.begin(), t.end(),
                              rgba.begin() + static_cast<std::ptrdiff_t>((std::size_t{y} * width + x) * 4));
                }
            }
        }
    }
}

} // namespace limen::world
