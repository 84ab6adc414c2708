#pragma once

#include "world/BlockContent.h"
#include "world/LruCache.h"
#include "world/Materials.h"

#include <compare>

namespace limen::world {

/// How much of a block is built.
enum class Tier : std::uint8_t {
    Near, ///< everything
    Far   ///< the ground alone
};

/// What a block's content follows from, beside the archive.
struct BlockKey {
    int x = 0, y = 0;
    Tier tier = Tier::Near;
    bool mergeZones = true;
    double detail = 1.0;
    auto operator<=>(const BlockKey&) const = default;
};

/// What loads of one archive make, kept for those that follow. A load with it yields the same World, byte for byte, as one without.
/// Safe to use from several threads.
class LoadCache {
public:
    /// `mostBytes`: that it keeps, about; what was needed longest ago goes first.
    explicit LoadCache(std::size_t mostBytes = std::size_t{112} << 20)
        : blocks(mostBytes / 2), models(mostBytes / 16), parts(mostBytes / 4), pictures(mostBytes / 4) {}

    LruCache<BlockKey, BlockContent> blocks;
    LruCache<std::pair<dat::RecordId, double>, Found<Model>> models;     ///< with Models' `detail`
    LruCache<dat::RecordId, Found<std::optional<PartMesh>>> parts;       ///< none: damaged
    LruCache<KeptPicture, Found<std::shared_ptr<const Image>>> pictures; ///< those that can be decoded
};

/// Bytes that something takes up, about.
[[nodiscard]] std::size_t bytesOf(const BlockContent& block);
[[nodiscard]] std::size_t bytesOf(const Model& model);
[[nodiscard]] std::size_t bytesOf(const std::optional<PartMesh>& part);

} // namespace limen::world
