#include "engine/map/LandscapeMap.h"

#include "world/World.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limen::engine {

Vec2 LandscapeMap::southWest() const {
    return Vec2(left, bottom) * world::kBlockSize;
}

Vec2 LandscapeMap::northEast() const {
    return Vec2(left + columns, bottom + rows) * world::kBlockSize;
}

Vec2 LandscapeMap::texelAt(const Vec2& point) const {
    const double texels = scale / world::kBlockSize;
    return {(point.x - southWest().x) * texels, (northEast().y - point.y) * texels};
}

Vec2 LandscapeMap::pointAt(const Vec2& texel) const {
    const double metres = world::kBlockSize / scale;
    return {southWest().x + texel.x * metres, northEast().y - texel.y * metres};
}

const LandscapeMap::Block* LandscapeMap::find(dat::BlockCoord coord) const {
    const auto key = [](dat::BlockCoord c) { return std::tuple(c.x, c.y); };
    const auto found =
        std::lower_bound(blocks.begin(), blocks.end(), coord,
                         [&](const Block& block, dat::BlockCoord c) { return key(block.coord) < key(c); });
    return found != blocks.end() && found->coord == coord ? &*found : nullptr;
}

std::optional<std::array<std::uint8_t, 3>> LandscapeMap::colourAt(const Vec2& point) const {
    const Vec2 texel = glm::floor(texelAt(point));
    if (!(texel.x >= 0.0 && texel.y >= 0.0 && texel.x < width() && texel.y < height()) || rgb.empty())
        return std::nullopt;
    const std::size_t i =
        (static_cast<std::size_t>(texel.y) * width() + static_cast<std::size_t>(texel.x)) * 3;
    return std::array{rgb[i], rgb[i + 1], rgb[i + 2]};
}

} // namespace limen::engine
