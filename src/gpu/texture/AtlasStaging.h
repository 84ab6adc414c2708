#pragma once

#include "gpu/texture/TextureStaging.h"

namespace limen::gpu {

/// Lays out an atlas of all pictures but those that only the ground samples, as out.textures[0]; sets `inAtlas`, `paged` and `grains`.
/// Leaves `out` as it is if they do not fit.
void stageAtlas(std::span<const frame::TextureUpload> pictures, const TextureUses& uses,
                const Capabilities& capabilities, StagedTextures& out);

/// Draws the layers of the atlas that stageAtlas laid out.
void fillAtlas(std::span<const frame::TextureUpload> pictures, StagedTextures& out);

} // namespace limen::gpu
