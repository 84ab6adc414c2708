#include "world/records/Clothing.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::world {
namespace {

template <class Value>
const Value* findKey(const dat::PackedHashTable<Value>& table, std::uint32_t key) {
    const auto found = std::find_if(table.entries.begin(), table.entries.end(),
                                    [key](const auto& entry) { return entry.first == key; });
    return found != table.entries.end() ? &found->second : nullptr;
}

/// A swap to a mesh that does not exist keeps the limb.
void changeParts(const std::vector<dat::PartChange>& changes, Records& records, Dress& dress) {
    for (const dat::PartChange& change : changes) {
        DressedPart& part = dress.parts[change.part];
        if (change.gfxObj != 0 && records.gfxObj(change.gfxObj) != nullptr)
            part.gfxObj = change.gfxObj;
        part.textures.insert(part.textures.end(), change.textures.begin(), change.textures.end());
    }
}

constexpr std::uint32_t kWholePalette = 0xFFFFFFFF; ///< a count; it is cut to the palette

/// The palette that a change names, directly or as one shade of a set; 0 if there is none, as for a shade outside
/// 0..1.
dat::RecordId paletteOf(const dat::PaletteChange& change, double shade, Records& records) {
    if (change.palettes >> 24 == 0x04)
        return change.palettes;
    const dat::PaletteSet* set = records.paletteSet(change.palettes);
    if (set == nullptr || set->palettes.empty() || !(shade >= 0.0 && shade <= 1.0))
        return 0;
    return set->palettes[shadeIndex(set->palettes.size(), shade)];
}

void changeColours(const dat::PaletteTemplate& colours, std::span<const double> shades, Records& records,
                   Dress& dress) {
    LIMEN_ASSERT(!shades.empty(), "a garment has a shade");
    for (std::size_t i = 0; i < colours.changes.size(); ++i) {
        const dat::PaletteChange& change = colours.changes[i];
        const dat::RecordId palette = paletteOf(change, shades[std::min(i, shades.size() - 1)], records);
        for (const dat::PaletteRange& range : change.ranges)
            if (palette != 0)
                dress.overlays.push_back({palette, range.offset, range.count});
    }
}

} // namespace

std::size_t shadeIndex(std::size_t count, double shade) {
    LIMEN_ASSERT(count > 0, "the set has a palette");
    const double at = (static_cast<double>(count) - 0.000001) * std::clamp(shade, 0.0, 1.0);
    return at > 0.0 ? std::min(static_cast<std::size_t>(at), count - 1) : 0;
}

Dress dressOf(dat::RecordId setup, const Outfit& outfit, Records& records) {
    Dress dress;
    if (outfit.basePalette != 0)
        dress.overlays.push_back({outfit.basePalette, 0, kWholePalette});
    if (outfit.beneath != nullptr)
        applyLook(*outfit.beneath, records, dress);
    for (const ClothingEntry& piece : outfit.garments) {
        const dat::ClothingTable* table = records.clothingTable(piece.table);
        if (table == nullptr)
            continue;
        if (const std::vector<dat::PartChange>* changes = findKey(table->parts, setup))
            changeParts(*changes, records, dress);
        const dat::PaletteTemplate* colours =
            piece.palette != 0 ? findKey(table->palettes, piece.palette) : nullptr;
        if (colours != nullptr)
            changeColours(*colours, piece.shades, records, dress);
        else if (piece.palette != 0)
            records.report({piece.table, "has no palette template " + std::to_string(piece.palette) +
                                             ", which world.json names"});
    }
    return dress;
}

void applyLook(const LookEntry& look, Records& records, Dress& dress) {
    for (const LookEntry::Part& change : look.parts)
        if (change.gfxObj != 0 && records.gfxObj(change.gfxObj) != nullptr)
            dress.parts[change.part].gfxObj = change.gfxObj;
    for (const LookEntry::Texture& change : look.textures)
        dress.parts[change.part].textures.push_back({change.from, change.to});
    for (const LookEntry::Colours& change : look.colours)
        dress.overlays.push_back({change.palette, change.offset, change.count});
}

std::vector<HeldThing> heldThings(dat::RecordId holder, double scale, std::span<const HeldEntry> entries,
                                  Records& records) {
    LIMEN_ASSERT(scale > 0.0, "an object has a size");
    std::vector<HeldThing> held;
    const dat::Setup* setup = !entries.empty() && isSetup(holder) ? records.setup(holder) : nullptr;
    if (setup == nullptr)
        return held;
    for (const HeldEntry& entry : entries) {
        const auto location = std::find_if(
            setup->holdingLocations.begin(), setup->holdingLocations.end(),
            [&](const dat::Location& l) { return l.key == static_cast<std::int32_t>(entry.location); });
        if (location == setup->holdingLocations.end() || !isSetup(entry.model) ||
            records.setup(entry.model) == nullptr)
            continue;
        HeldThing thing;
        thing.model = entry.model;
        if (location->part >= 0 && static_cast<std::size_t>(location->part) < setup->parts.size())
            thing.part = static_cast<std::uint32_t>(location->part);
        thing.at = poseOf(location->frame);
        thing.at.origin /= scale; // neither its place on the part nor its size follows the holder's scale
        thing.placement = entry.placement;
        thing.scale = entry.scale / scale;
        Dress dress = dressOf(entry.model, {entry.clothing, entry.basePalette}, records);
        applyLook(entry.look, records, dress);
        thing.dress = std::make_shared<const Dress>(std::move(dress));
        held.push_back(std::move(thing));
    }
    return held;
}

dat::Palette withOverlays(const dat::Palette& base, std::span<const PaletteOverlay> overlays,
                          Records& records) {
    dat::Palette palette = base;
    for (const PaletteOverlay& overlay : overlays) {
        const dat::Palette* source = records.palette(overlay.palette);
        if (source == nullptr)
            continue;
        const std::size_t common = std::min(palette.colours.size(), source->colours.size());
        const std::size_t end = std::min(common, std::size_t{overlay.offset} + overlay.count);
        for (std::size_t i = overlay.offset; i < end; ++i)
            palette.colours[i] = source->colours[i];
    }
    return palette;
}

} // namespace limen::world
