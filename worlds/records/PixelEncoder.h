#pragma once

#include "dat/records/Textures.h"
#include "worlds/pictures/Canvas.h"

namespace limen::worlds {

/// A picture as records: the image, and its palette when the format has one.
struct EncodedImage {
    dat::RenderSurface image;
    dat::Palette palette; ///< P8 and Index16 only: 256 or 2048 colours; otherwise empty
};

/// Encodes a canvas. For P8 and Index16 texels with alpha < 0.5 get index 0 and entries 0..7 are left for
/// them (docs/formats/textures.md#clip-maps). DXT1 stores texels with alpha < 0.5 as punch-through. Formats:
/// R8G8B8, A8R8G8B8, R5G6B5, A4R4G4B4, A8 and LandscapeAlpha (alpha channel), LandscapeR8G8B8, P8, Index16,
/// Dxt1 (sides must be multiples of 4). Ids are left 0.
[[nodiscard]] EncodedImage encodeImage(const Canvas& canvas, dat::PixelFormat format);

} // namespace limen::worlds
