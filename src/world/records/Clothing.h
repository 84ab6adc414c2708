#pragma once

#include "world/MovingEntries.h"
#include "world/records/Pose.h"
#include "world/records/Records.h"

#include <compare>
#include <map>
#include <memory>
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

struct Dress;

/// A thing that a Setup holds.
struct HeldThing {
    dat::RecordId model = 0;
    std::uint32_t part = kNone; ///< of the holder; kNone: the holder itself
    Pose at;                    ///< in the frame of that part
    std::uint32_t placement = 0;
    double scale = 1.0;                 ///< in the holder's frame
    std::shared_ptr<const Dress> dress; ///< never null
};

/// The changes to a Setup.
struct Dress {
    std::map<std::uint32_t, DressedPart> parts; ///< by part
    /// Applied in order to the palettes of all its indexed pictures. A base palette comes first and covers all.
    std::vector<PaletteOverlay> overlays;
    std::vector<HeldThing> held;

    [[nodiscard]] bool empty() const { return parts.empty() && overlays.empty() && held.empty(); }
    /// Whether it changes or adds meshes, and not materials alone.
    [[nodiscard]] bool changesModel() const { return !parts.empty() || !held.empty(); }
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
    const LookEntry* beneath = nullptr; ///< of the body, which the garments cover; null: none
};

/// The look of a Setup in these clothes. First the parts of all garments are swapped, then all textures are
/// changed: of two changes of one texture of a part the later counts. A missing or damaged record changes nothing
/// and is reported. A table without an entry for the Setup changes colours only.
[[nodiscard]] Dress dressOf(dat::RecordId setup, const Outfit& outfit, Records& records);

/// Adds changes of one object to its dress. A swap to a mesh that does not exist keeps the part.
void applyLook(const LookEntry& look, Records& records, Dress& dress);

/// The things in the hands of a holder that is drawn at `scale`. A thing without a Setup is left out; one whose location the
/// holder's Setup lacks is left out, too.
[[nodiscard]] std::vector<HeldThing> heldThings(dat::RecordId holder, double scale,
                                                std::span<const HeldEntry> entries, Records& records);

/// A palette with overlays applied. An overlay is cut to the size of both palettes; one whose palette is
/// missing has no effect.
[[nodiscard]] dat::Palette withOverlays(const dat::Palette& base, std::span<const PaletteOverlay> overlays,
                                        Records& records);

/// The index of a shade in a PaletteSet of `count` palettes; `shade` 0 is the first, 1 the last. Requires
/// count > 0.
[[nodiscard]] std::size_t shadeIndex(std::size_t count, double shade);

} // namespace limen::world
