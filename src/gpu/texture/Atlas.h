#pragma once

#include "frame/GpuLayout.h"
#include "gpu/texture/MipChain.h"
#include "gpu/texture/PageLayout.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../../../shaders/include/AtlasLayout.h"

namespace limen::gpu {

/// An atlas has textures of all sizes in the layers of one array texture without mip levels. The levels of a texture
/// are there side by side, each with a border of one texel that repeats or clamps it, so a bilinear sample of one level
/// needs neither the driver's wrapping nor its mip levels. `inAtlas` of textures.glsl finds them.

/// Upper left corner of a texture, at the border of its level 0; in texels, y downwards.
struct AtlasSpot {
    std::uint32_t layer = 0, x = 0, y = 0;
    bool operator==(const AtlasSpot&) const = default;
};

/// Layers of an atlas, of `width` x `height` texels, and the spot of each texture, in order.
struct AtlasLayout {
    std::uint32_t width = 0, height = 0, layers = 0;
    std::vector<AtlasSpot> spots;
};

/// None if a texture is too large, or if more than `maxLayers` layers of at most `maxSide` texels a side are needed. The result depends
/// on the textures and their order alone.
[[nodiscard]] std::optional<AtlasLayout> layOutAtlas(std::span<const TextureClass> textures, bool hasGrains,
                                                     std::uint32_t maxSide, std::uint32_t maxLayers);

/// Spots of the grains of exteriors and of shells; `hasGrains` keeps them free.
[[nodiscard]] std::array<AtlasSpot, 2> grainSpots();

/// TextureRef::place.xy of a texture.
[[nodiscard]] frame::gpu::uvec2 atlasPlace(const TextureClass& texture, const AtlasSpot& spot);

/// Writes all levels of a texture and their borders into a layer. Requires: `levels` is its mipChain.
void putIntoAtlas(std::span<const MipLevel> levels, bool clamp, const AtlasSpot& spot, MipLevel& layer);

} // namespace limen::gpu
