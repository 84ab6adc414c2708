#pragma once

#include "dat/records/Primitives.h"

// PaletteSet (0x0F), ClothingTable (0x10): docs/formats/textures.md.
LIMEN_API_BEGIN
namespace limen::dat {

/// Palettes of one thing in several shades.
struct PaletteSet {
    std::uint32_t id = 0;
    std::vector<std::uint32_t> palettes; ///< Palette (0x04) ids
};

/// Replaces a SurfaceTexture (0x05) of a part of a model.
struct TextureChange {
    std::uint32_t from = 0, to = 0;
};

/// Replaces the mesh of a part of a model, and textures on it.
struct PartChange {
    std::uint32_t part = 0;
    std::uint32_t gfxObj = 0;
    std::vector<TextureChange> textures;
};

/// Replaces ranges of colours of a palette.
struct PaletteRange {
    std::uint32_t offset = 0, count = 0;
};

struct PaletteChange {
    std::vector<PaletteRange> ranges;
    std::uint32_t palettes = 0; ///< PaletteSet (0x0F) or Palette (0x04) id
};

struct PaletteTemplate {
    std::uint32_t icon = 0; ///< RenderSurface (0x06) id
    std::vector<PaletteChange> changes;
};

/// The changes that a piece of clothing makes to a model.
struct ClothingTable {
    std::uint32_t id = 0;
    PackedHashTable<std::vector<PartChange>> parts; ///< by Setup (0x02) id
    PackedHashTable<PaletteTemplate> palettes;      ///< by palette template
};

} // namespace limen::dat
LIMEN_API_END
