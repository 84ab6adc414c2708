#pragma once

#include "frame/SceneUpload.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limen::gpu {

/// The parts of a cell in which a layer shows: a bit for each of kShownParts columns and rows, row by row, from the corner
/// where the texture coordinates are 0.
using ShownParts = std::uint64_t;
inline constexpr ShownParts kEverywhere = ~ShownParts{0};

/// The parts of an unturned blend map in which it lets its layer show: alpha is below 1 within the part, or a 64th of the
/// cell and one texel beside it. That covers filtering; in coarser mip levels a pixel or two beside the part can lack a faint share of
/// the layer. Requires a picture with texels.
[[nodiscard]] ShownParts partsOf(const frame::TextureUpload& map);

/// The same after quarter turns, as terrainblend.glsl turns the map.
[[nodiscard]] ShownParts turned(ShownParts parts, std::uint32_t quarterTurns);

/// partsOf() of each texture that is a blend map of some cell; 0 for others.
[[nodiscard]] std::vector<ShownParts> partsOfMaps(std::span<const frame::gpu::TerrainCell> cells,
                                                  std::span<const frame::TextureUpload> textures);

} // namespace limen::gpu
