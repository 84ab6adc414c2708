#pragma once

#include "core/Error.h"
#include "dat/records/Textures.h"
#include "world/Image.h"

namespace limen::world {

/// How a surface reads its picture.
struct DecodeRules {
    bool clipMap = false;  ///< palette indices 0..7, and black in DXT, are transparent
    bool additive = false; ///< A8: the value is colour and alpha; else white with that alpha
};

/// Whether texels of a format are numbers of a palette's colours.
[[nodiscard]] constexpr bool isIndexed(dat::PixelFormat format) {
    return format == dat::PixelFormat::P8 || format == dat::PixelFormat::Index16;
}

/// Decodes a picture. `palette` is needed for P8 and Index16 only. Errors: dimensions out of 1..4096, a byte
/// count that does not fit them, a missing or empty palette, a damaged JPEG file (whose own size counts). Blend maps (LandscapeAlpha) have their value in all four channels.
[[nodiscard]] Result<Image> decodeImage(const dat::RenderSurface& picture, const dat::Palette* palette,
                                        const DecodeRules& rules);

/// Gives transparent texels the mean colour of their opaque neighbours, so that filtering at a cut-out's
/// border does not mix in black. Alpha is left alone.
void bleedColour(Image& image);

} // namespace limen::world
