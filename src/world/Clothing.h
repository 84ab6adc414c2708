#pragma once

#include "world/MovingEntries.h"
#include "world/Records.h"

#include <compare>
#include <map>
#include <span>

// What one wears: how ClothingTables (0x10) change the look of a model. After docs/formats/textures.md#clothing.
namespace limen::world {

/// Colours of a palette that take the places, at the same numbers, of those of the palette beneath.
struct PaletteOverlay {
    dat::RecordId palette = 0;
    std::uint32_t offset = 0, count = 0;
    friend auto operator<=>(const PaletteOverlay&, const PaletteOverlay&) = default;
};

/// What is changed of one part of a Setup.
struct DressedPart {
    dat::RecordId gfxObj = 0; ///< in the place of its own; 0: its own
    std::vector<dat::TextureChange> textures;
};

/// What is changed of a Setup.
struct Dress {
    std::map<std::uint32_t, DressedPart> parts; ///< by part
    std::vector<PaletteOverlay> overlays;       ///< of all its indexed pictures' palettes, in order

    [[nodiscard]] bool empty() const { return parts.empty() && overlays.empty(); }
    /// Null if the part is as it was.
    [[nodiscard]] const DressedPart* part(std::uint32_t part) const {
        const auto found = parts.find(part);
        return found != parts.end() ? &found->second : nullptr;
    }
};

/// What a Setup looks like in these clothes, of which later ones lie over earlier ones. What is missing or damaged changes nothing
/// and is said in the records' findings; a table that does not know the Setup changes colours only.
[[nodiscard]] Dress dressOf(dat::RecordId setup, std::span<const ClothingEntry> clothes, Records& records);

/// A palette with others laid over it. Overlays that are missing, or reach beyond either palette, change what is there.
[[nodiscard]] dat::Palette withOverlays(const dat::Palette& base, std::span<const PaletteOverlay> overlays,
                                        Records& records);

/// The place in a PaletteSet of `count` palettes of a shade, 0 the first .. 1 the last. Requires count > 0.
[[nodiscard]] std::size_t shadeIndex(std::size_t count, double shade);

} // namespace limen::world
