#pragma once

#include "core/Error.h"
#include "dat/records/Textures.h"
#include "world/Image.h"

namespace limen::world {

/// The rules by which a surface reads its picture.
struct DecodeRules {
    bool clipMap = false;  ///< palette indices 0..7 are transparent
    bool additive = false; ///< for A8. true: the value is colour and alpha; false: white with that alpha
};

/// True if the texels of a format are indices into a palette.
[[nodiscard]] constexpr bool isIndexed(dat::PixelFormat format) {
    return format == dat::PixelFormat::P8 || format == dat::PixelFormat::Index16;
}

/// Decodes a picture. `palette` is needed for P8 and Index16 only. Blend maps (LandscapeAlpha) get their
/// value in all four channels. A JPEG file has its own size. Errors: dimensions out of 1..4096, a byte count
/// that does not fit them, a missing or empty palette, a damaged JPEG file.
[[nodiscard]] Result<Image> decodeImage(const dat::RenderSurface& picture, const dat::Palette* palette,
                                        const DecodeRules& rules);

/// Gives transparent texels the mean colour of their neighbours that are not, so that filtering at the border
/// of a cut-out does not mix in black. Alpha is unchanged.
void bleedColour(Image& image);

} // namespace limen::world
