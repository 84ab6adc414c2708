#pragma once

#include "frame/GpuLayout.h"
#include "gpu/device/ShaderLibrary.h"
#include "gpu/scene/BlendMapParts.h"
#include "gpu/texture/TextureStaging.h"

#include <optional>
#include <span>
#include <vector>

namespace limen::gpu {

/// The textures of the ground, by their indices; one that several layers have is there several times.
struct GroundTextures {
    std::vector<std::uint32_t> colours, maps;
};
[[nodiscard]] GroundTextures groundTexturesOf(std::span<const frame::gpu::TerrainCell> cells);

/// None without a texture, if the textures are in several pages, or if the blend maps are. Without maps, `maps` is the textures' page.
[[nodiscard]] std::optional<GroundPages> groundPagesOf(const GroundTextures& ground,
                                                       std::span<const TextureLocation> locations);

/// Whether these pages hold all textures and all blend maps of the ground.
[[nodiscard]] bool areIn(const GroundPages& pages, const GroundTextures& ground,
                         std::span<const TextureLocation> locations);

/// The cells' layers with the places of their textures in the array pages, without the layers that a cell lacks.
/// `refs`: by texture. `maps`: partsOfMaps(). Requires pages, not handles. Repeats are whole numbers up to 255; others are rounded.
/// A layer shows in the parts of its map if all layers of the cell have one page for their textures and one for their maps;
/// else everywhere, because software drivers sample one page at a time.
[[nodiscard]] std::vector<frame::gpu::PackedCell> packTerrain(std::span<const frame::gpu::TerrainCell> cells,
                                                              std::span<const frame::gpu::TextureRef> refs,
                                                              std::span<const ShownParts> maps);

} // namespace limen::gpu
