#pragma once

#include <cstdint>

// The hash that all random choices of the landscape use. docs/formats/landscape.md#random-numbers.
namespace limen::world {

namespace seed {
inline constexpr std::uint32_t kSplit = 3, kScene = 0x2BF9, kFrequency = 0x5B67, kDisplaceX = 0xB2CD,
                               kDisplaceY = 0x11C0F, kScale = 0x7F51, kQuadrant = 0xE7EB, kRotation = 0xF697;
}

/// The hash of a global vertex or landcell; arithmetic is modulo 2^32.
[[nodiscard]] constexpr std::uint32_t landHash(std::uint32_t x, std::uint32_t y, std::uint32_t s) {
    return 1813693831u * y - 1109124029u * x - s * (1360117743u * x * y + 1888038839u);
}

/// The hash as a fraction in [0, 1).
[[nodiscard]] constexpr double landRandom(std::uint32_t x, std::uint32_t y, std::uint32_t s) {
    return landHash(x, y, s) * (1.0 / 4294967296.0);
}

/// True if a landcell is cut from south-west to north-east, else from south-east to north-west.
[[nodiscard]] constexpr bool splitsSouthWestNorthEast(std::uint32_t x, std::uint32_t y) {
    return landHash(x, y, seed::kSplit) >= 0x80000000u;
}

} // namespace limen::world
