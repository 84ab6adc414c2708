#pragma once

#include <cstdint>
#include <vector>

namespace limen::world {

/// A decoded picture: R,G,B,A bytes, top row first, no padding.
struct Image {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    bool hasAlpha = false;  ///< some texel has alpha < 255
    bool isIndexed = false; ///< its texels were indices into a palette
    /// Identifies its source within one archive; 0: unknown.
    std::uint64_t contentKey = 0;
    friend bool operator==(const Image&, const Image&) = default;
};

} // namespace limen::world
