#pragma once

#include "frame/GpuLayout.h"
#include "gpu/scene/BlendMapParts.h"

#include <span>
#include <vector>

namespace limen::gpu {

/// The cells' layers with the places of their textures in the array pages, without the layers that a cell lacks.
/// `refs`: by texture. `maps`: partsOfMaps(). Requires pages, not handles. Repeats are whole numbers up to 255; others are rounded.
/// A layer shows in the parts of its map if all layers of the cell have one page for their textures and one for their maps;
/// else everywhere, because software drivers sample one page at a time.
[[nodiscard]] std::vector<frame::gpu::PackedCell> packTerrain(std::span<const frame::gpu::TerrainCell> cells,
                                                              std::span<const frame::gpu::TextureRef> refs,
                                                              std::span<const ShownParts> maps);

} // namespace limen::gpu
