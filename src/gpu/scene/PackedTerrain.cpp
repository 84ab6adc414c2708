#include "gpu/scene/PackedTerrain.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limen::gpu {

namespace {

namespace layout = frame::gpu;

std::uint32_t placeOf(std::uint32_t texture, std::span<const layout::TextureRef> refs) {
    const layout::uvec4& place = refs[texture].place; // layer, page
    LIMEN_ASSERT(place.y < 256 && place.x < 65536, "a page and a layer of an array page");
    return place.y | place.x << 8;
}

layout::uvec2 pack(const layout::TerrainLayer& layer, std::span<const layout::TextureRef> refs) {
    constexpr float kMostRepeats = 255.0f;
    const auto repeats = static_cast<std::uint32_t>(std::clamp(std::round(layer.tiling), 1.0f, kMostRepeats));
    layout::uvec2 packed{placeOf(layer.texture, refs) | repeats << layout::kPackedTiling,
                         layout::kPackedLayer | (layer.rotation & 3u) << layout::kPackedTurns};
    if (layer.alpha != layout::kNoTexture)
        packed.y |= layout::kPackedMap | placeOf(layer.alpha, refs);
    return packed;
}

/// The layers of a cell after its base, as far as they exist.
class Overlays {
public:
    explicit Overlays(const layout::TerrainCell& cell) {
        for (const layout::TerrainLayer& overlay : cell.overlays)
            add(overlay);
        for (const layout::TerrainLayer& road : cell.roads)
            add(road);
    }
    [[nodiscard]] std::span<const layout::TerrainLayer* const> all() const {
        return {layers_.data(), count_};
    }
    /// Whether their textures are in one page, and their maps.
    [[nodiscard]] bool haveCommonPages(std::span<const layout::TextureRef> refs) const {
        const auto pageOf = [&](std::uint32_t texture) { return refs[texture].place.y; };
        return std::all_of(all().begin(), all().end(), [&](const layout::TerrainLayer* layer) {
            return layer->alpha != layout::kNoTexture &&
                   pageOf(layer->texture) == pageOf(layers_[0]->texture) &&
                   pageOf(layer->alpha) == pageOf(layers_[0]->alpha);
        });
    }

private:
    void add(const layout::TerrainLayer& layer) {
        if (layer.texture != layout::kNoTexture)
            layers_[count_++] = &layer;
    }
    std::array<const layout::TerrainLayer*, layout::kLayersPerCell - 1> layers_{};
    std::size_t count_ = 0;
};

/// The parts in which the layers show: two words each.
void packParts(const Overlays& overlays, std::span<const layout::TextureRef> refs,
               std::span<const ShownParts> maps, layout::PackedCell& out) {
    const bool byMap = overlays.haveCommonPages(refs);
    std::size_t count = 0;
    for (const layout::TerrainLayer* layer : overlays.all()) {
        const ShownParts parts = byMap ? turned(maps[layer->alpha], layer->rotation) : kEverywhere;
        layout::uvec4& pair = out.shown[count / 2];
        (count % 2 == 0 ? pair.x : pair.z) = static_cast<std::uint32_t>(parts);
        (count % 2 == 0 ? pair.y : pair.w) = static_cast<std::uint32_t>(parts >> 32);
        ++count;
    }
}

layout::PackedCell pack(const layout::TerrainCell& cell, std::span<const layout::TextureRef> refs,
                        std::span<const ShownParts> maps) {
    layout::PackedCell out;
    std::size_t count = 0;
    const auto add = [&](const layout::TerrainLayer& layer) {
        if (layer.texture == layout::kNoTexture)
            return;
        const layout::uvec2 packed = pack(layer, refs);
        layout::uvec4& pair = out.layers[count / 2];
        (count % 2 == 0 ? pair.x : pair.z) = packed.x;
        (count % 2 == 0 ? pair.y : pair.w) = packed.y;
        ++count;
    };
    add(cell.base);
    for (const layout::TerrainLayer& overlay : cell.overlays)
        add(overlay);
    for (const layout::TerrainLayer& road : cell.roads)
        add(road);
    packParts(Overlays(cell), refs, maps, out);
    return out;
}

/// With the texture of the first road in the second.
layout::TerrainCell withOneRoad(layout::TerrainCell cell) {
    layout::TerrainLayer& second = cell.roads[1];
    if (cell.roads[0].texture != layout::kNoTexture && second.texture != layout::kNoTexture) {
        second.texture = cell.roads[0].texture;
        second.tiling = cell.roads[0].tiling;
    }
    return cell;
}

/// Whether a page holds all pictures.
bool holds(std::uint32_t page, std::span<const std::uint32_t> pictures,
           std::span<const TextureLocation> locations) {
    return std::all_of(pictures.begin(), pictures.end(),
                       [&](std::uint32_t picture) { return locations[picture].page == page; });
}

} // namespace

GroundTextures groundTexturesOf(std::span<const layout::TerrainCell> cells) {
    GroundTextures ground;
    const auto add = [&](const layout::TerrainLayer& layer) {
        if (layer.texture == layout::kNoTexture)
            return;
        ground.colours.push_back(layer.texture);
        if (layer.alpha != layout::kNoTexture)
            ground.maps.push_back(layer.alpha);
    };
    for (const layout::TerrainCell& cell : cells) {
        add(cell.base);
        std::for_each(std::begin(cell.overlays), std::end(cell.overlays), add);
        std::for_each(std::begin(cell.roads), std::end(cell.roads), add);
    }
    return ground;
}

std::optional<GroundPages> groundPagesOf(const GroundTextures& ground,
                                         std::span<const TextureLocation> locations) {
    if (ground.colours.empty())
        return std::nullopt;
    const std::uint32_t colours = locations[ground.colours[0]].page;
    const GroundPages pages{colours, ground.maps.empty() ? colours : locations[ground.maps[0]].page};
    return areIn(pages, ground, locations) ? std::optional(pages) : std::nullopt;
}

bool areIn(const GroundPages& pages, const GroundTextures& ground,
           std::span<const TextureLocation> locations) {
    return holds(pages.colours, ground.colours, locations) && holds(pages.maps, ground.maps, locations);
}

std::vector<layout::PackedCell> packTerrain(std::span<const layout::TerrainCell> cells,
                                            std::span<const layout::TextureRef> refs,
                                            std::span<const ShownParts> maps) {
    std::vector<layout::PackedCell> out;
    out.reserve(cells.size());
    for (const layout::TerrainCell& cell : cells)
        out.push_back(pack(withOneRoad(cell), refs, maps));
    return out;
}

} // namespace limen::gpu
