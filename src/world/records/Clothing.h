#pragma once

#include "world/MovingEntries.h"
#include "world/records/Records.h"

#include <compare>
#include <map>
#include <span>

// Clothes: how ClothingTable records (0x10) change the look of a model. docs/formats/textures.md#clothing.
namespace limen::world {

/// A range of a palette's colours, which replaces the same range of the palette beneath.
struct PaletteOverlay {
    dat::RecordId palette = 0;
    std::uint32_t offset = 0, count = 0; ///< in colours
    friend auto operator<=>(const PaletteOverlay&, const PaletteOverlay&) = default;
};

/// The changes to one part of a Setup.
struct DressedPart {
    dat::RecordId gfxObj = 0; ///< replaces the part's own; 0: unchanged
    std::vector<dat::TextureChange> textures;
};

/// The changes to a Setup.
struct Dress {
    std::map<std::uint32_t, DressedPart> parts; ///< by part
    /// Applied in order to the palettes of all its indexed pictures. A base palette comes first and covers all.
    std::vector<PaletteOverlay> overlays;

    [[nodiscard]] bool empty() const { return parts.empty() && overlays.empty(); }
    /// Null if the part is unchanged.
    [[nodiscard]] const DressedPart* part(std::uint32_t part) const {
        const auto found = parts.find(part);
        return found != parts.end() ? &found->second : nullptr;
    }
};

/// Garments on a body. `basePalette` takes the place of each indexed picture's own palette; 0: none does.
struct Outfit {
    std::span<const ClothingEntry> garments;
    dat::RecordId basePalette = 0;
};

/// The look of a Setup in these clothes. First the parts of all garments are swapped, then all textures are
/// changed: of two changes of one texture of a part the later counts. A missing or damaged record changes nothing
/// and is reported. A table without an entry for the Setup changes colours only.
[[nodiscard]] Dress dressOf(dat::RecordId setup, const Outfit& outfit, Records& records);

/// A palette with overlays applied. An overlay is cut to the size of both palettes; one whose palette is
/// missing has no effect.
[[nodiscard]] dat::Palette withOverlays(const dat::Palette& base, std::span<const PaletteOverlay> overlays,
                                        Records& records);

/// The index of a shade in a PaletteSet of `count` palettes; `shade` 0 is the first, 1 the last. Requires
/// count > 0.
[[nodiscard]] std::size_t shadeIndex(std::size_t count, double shade);

} // namespace limen::world
