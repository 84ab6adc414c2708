#pragma once

#include "world/block/BlockContent.h"
#include "world/mesh/ModelCache.h"
#include "world/texture/PictureCache.h"

#include <compare>

namespace limen::world {

/// How much of a block is built.
enum class Tier : std::uint8_t {
    Near, ///< everything
    Far   ///< the ground alone
};

/// The inputs that determine the content of a block, besides the archive.
struct BlockKey {
    int x = 0, y = 0;
    Tier tier = Tier::Near;
    bool mergeZones = true;
    LevelLimits levels{};
    auto operator<=>(const BlockKey&) const = default;
};

/// Blocks, models and pictures of one archive, kept for later loads. A load with the cache yields the same
/// World, byte for byte, as a load without it. Thread-safe.
class LoadCache {
public:
    /// `mostBytes`: approximate capacity. The least recently used entries are dropped first.
    explicit LoadCache(std::size_t mostBytes = std::size_t{112} << 20)
        : blocks(mostBytes / 2), models(mostBytes / 16, mostBytes / 4), pictures(mostBytes / 4) {}

    LruCache<BlockKey, BlockContent> blocks;
    ModelCache models;
    PictureCache pictures;
};

/// Estimated size in memory, bytes.
[[nodiscard]] std::size_t bytesOf(const BlockContent& block);

} // namespace limen::world
