#include "gpu/scene/PackedTerrain.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::gpu {

namespace {

namespace layout = frame::gpu;

std::uint32_t placeOf(std::uint32_t texture, std::span<const layout::TextureRef> refs) {
    const layout::uvec4& place = refs[texture].place; // layer, page
    LIMEN_ASSERT(place.y < 256 && place.x < 65536, "a page and a layer of an array page");
    return place.y | place.x << 8;
}

layout::uvec2 pack(const layout::TerrainLayer& layer, bool isRoad, std::span<const layout::TextureRef> refs) {
    constexpr float kMostRepeats = 255.0f;
    const auto repeats = static_cast<std::uint32_t>(std::clamp(std::round(layer.tiling), 1.0f, kMostRepeats));
    layout::uvec2 packed{placeOf(layer.texture, refs) | repeats << layout::kPackedTiling,
                         layout::kPackedLayer | (layer.rotation & 3u) << layout::kPackedTurns |
                             (isRoad ? layout::kPackedRoad : 0)};
    if (layer.alpha != layout::kNoTexture)
        packed.y |= layout::kPackedMap | placeOf(layer.alpha, refs);
    return packed;
}

layout::PackedCell pack(const layout::TerrainCell& cell, std::span<const layout::TextureRef> refs) {
    layout::PackedCell out;
    std::size_t count = 0;
    const auto add = [&](const layout::TerrainLayer& layer, bool isRoad) {
        if (layer.texture == layout::kNoTexture)
            return;
        const layout::uvec2 packed = pack(layer, isRoad, refs);
        layout::uvec4& pair = out.layers[count / 2];
        (count % 2 == 0 ? pair.x : pair.z) = packed.x;
        (count % 2 == 0 ? pair.y : pair.w) = packed.y;
        ++count;
    };
    add(cell.base, false);
    for (const layout::TerrainLayer& overlay : cell.overlays)
        add(overlay, false);
    for (const layout::TerrainLayer& road : cell.roads)
        add(road, true);
    return out;
}

} // namespace

std::vector<layout::PackedCell> packTerrain(std::span<const layout::TerrainCell> cells,
                                            std::span<const layout::TextureRef> refs) {
    std::vector<layout::PackedCell> out;
    out.reserve(cells.size());
    for (const layout::TerrainCell& cell : cells)
        out.push_back(pack(cell, refs));
    return out;
}

} // namespace limen::gpu
