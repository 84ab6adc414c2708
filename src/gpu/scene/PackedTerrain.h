#pragma once

#include "frame/GpuLayout.h"

#include <span>
#include <vector>

namespace limen::gpu {

/// The cells' layers with the places of their textures in the array pages, without the layers that a cell lacks.
/// `refs`: by texture. Requires pages, not handles. Repeats are whole numbers up to 255; others are rounded.
[[nodiscard]] std::vector<frame::gpu::PackedCell> packTerrain(std::span<const frame::gpu::TerrainCell> cells,
                                                              std::span<const frame::gpu::TextureRef> refs);

} // namespace limen::gpu
