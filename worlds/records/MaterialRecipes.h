#pragma once

#include "dat/records/Textures.h"
#include "worlds/records/Materials.h"

namespace limen::worlds {

/// The Surface of a material and the format of its picture.
struct MaterialRecipe {
    double metres = 2.0; ///< per repeat of the picture
    dat::PixelFormat format = dat::PixelFormat::Dxt1;
    std::uint32_t type = dat::Surface::kBase1Image;
    float luminosity = 0.0f, diffuse = 1.0f, translucency = 0.0f;
    std::uint32_t colour = 0; ///< of a solid surface
};

[[nodiscard]] MaterialRecipe recipeOf(Material material);

} // namespace limen::worlds
