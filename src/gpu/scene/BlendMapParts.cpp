#include "gpu/scene/BlendMapParts.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr std::uint32_t kParts = layout::kShownParts;
static_assert(kParts * kParts == 64, "a bit for each part");
constexpr double kBeside = 1.0 / 64.0; // of the cell

/// The texels of a part along one side of `size` texels, with those beside it.
struct Range {
    std::uint32_t first = 0, end = 0;
};
Range texelsOf(std::uint32_t part, std::uint32_t size) {
    const double low = std::floor((static_cast<double>(part) / kParts - kBeside) * size) - 1.0;
    const double high = std::ceil((static_cast<double>(part + 1) / kParts + kBeside) * size) + 1.0;
    return {static_cast<std::uint32_t>(std::max(low, 0.0)),
            static_cast<std::uint32_t>(std::min(high, static_cast<double>(size)))};
}

bool showsIn(const frame::TextureUpload& map, Range columns, Range rows) {
    for (std::uint32_t y = rows.first; y < rows.end; ++y)
        for (std::uint32_t x = columns.first; x < columns.end; ++x)
            if (map.rgba[4 * (std::size_t{y} * map.width + x) + 3] < 255)
                return true;
    return false;
}

} // namespace

ShownParts partsOf(const frame::TextureUpload& map) {
    LIMEN_ASSERT(map.rgba.size() >= std::size_t{4} * map.width * map.height && !map.rgba.empty(),
                 "the map has texels");
    ShownParts parts = 0;
    for (std::uint32_t y = 0; y < kParts; ++y)
        for (std::uint32_t x = 0; x < kParts; ++x)
            if (showsIn(map, texelsOf(x, map.width), texelsOf(y, map.height)))
                parts |= ShownParts{1} << (y * kParts + x);
    return parts;
}

ShownParts turned(ShownParts parts, std::uint32_t quarterTurns) {
    constexpr std::uint32_t kLast = kParts - 1;
    for (; quarterTurns % 4 != 0; --quarterTurns) {
        ShownParts once = 0;
        for (std::uint32_t y = 0; y < kParts; ++y)
            for (std::uint32_t x = 0; x < kParts; ++x) // the map is read at (-y, x) about its middle
                once |= (parts >> (x * kParts + (kLast - y)) & 1) << (y * kParts + x);
        parts = once;
    }
    return parts;
}

std::vector<ShownParts> partsOfMaps(std::span<const layout::TerrainCell> cells,
                                    std::span<const frame::TextureUpload> textures) {
    std::vector<bool> isMap(textures.size());
    const auto mark = [&](const layout::TerrainLayer& layer) {
        if (layer.texture != layout::kNoTexture && layer.alpha != layout::kNoTexture)
            isMap[layer.alpha] = true;
    };
    for (const layout::TerrainCell& cell : cells) {
        std::for_each(std::begin(cell.overlays), std::end(cell.overlays), mark);
        std::for_each(std::begin(cell.roads), std::end(cell.roads), mark);
    }
    std::vector<ShownParts> parts(textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i)
        parts[i] = isMap[i] ? partsOf(textures[i]) : 0;
    return parts;
}

} // namespace limen::gpu
