#include "worlds/builtin/people/FolkClothes.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::worlds {

namespace {

constexpr dat::RecordId kCloak = 0x10000100, kDyes = 0x0F000100, kFirstDye = 0x04000F00;

template <class Record>
const Record& recordOf(const std::vector<Record>& records, dat::RecordId id) {
    const auto found =
        std::find_if(records.begin(), records.end(), [id](const Record& r) { return r.id == id; });
    LIMEN_ASSERT(found != records.end(), "materials come before models");
    return *found;
}

/// The palette of a material's picture.
const dat::Palette& paletteOf(const WorldRecords& records, Material material) {
    const auto surface = std::find_if(records.surfaces.begin(), records.surfaces.end(),
                                      [&](const auto& s) { return s.first == surfaceId(material); });
    LIMEN_ASSERT(surface != records.surfaces.end(), "materials come before models");
    const dat::SurfaceTexture& texture = recordOf(records.surfaceTextures, surface->second.texture);
    return recordOf(records.palettes,
                    recordOf(records.renderSurfaces, texture.images.front()).defaultPalette);
}

/// Blue shades of a palette, at `percent` of its brightness.
dat::Palette dyed(dat::Palette palette, dat::RecordId id, std::uint32_t percent) {
    palette.id = id;
    for (dat::Colour& colour : palette.colours) {
        const auto channel = [&](int shift) { return colour.argb >> shift & 255u; };
        const std::uint32_t grey = (channel(16) + channel(8) + channel(0)) / 3u * percent / 100u;
        colour.argb = (colour.argb & 0xFF000000u) | grey / 3u << 16 | grey / 2u << 8 | grey;
    }
    return palette;
}

} // namespace

dat::RecordId addCloak(ModelWriter& writer, const std::vector<dat::RecordId>& setups, dat::RecordId cloaked) {
    WorldRecords& records = writer.records();
    const dat::Palette cloth =
        paletteOf(records, Material::Rug); // a copy, because adding palettes moves them
    dat::PaletteSet dyes{kDyes, {}};
    for (const std::uint32_t percent : {150u, 110u, 70u}) {
        const auto id = kFirstDye + static_cast<dat::RecordId>(dyes.palettes.size());
        records.palettes.push_back(dyed(cloth, id, percent));
        dyes.palettes.push_back(id);
    }
    const auto all = static_cast<std::uint32_t>(cloth.colours.size());
    dat::ClothingTable table;
    table.id = kCloak;
    for (const dat::RecordId setup : setups)
        table.parts.entries.push_back({setup, {{0, cloaked, {}}}});
    table.palettes.entries = {{kUndyed, {}}, {kDyed, {0, {{{{0, all}}, kDyes}}}}};
    records.paletteSets.push_back(dyes);
    records.clothingTables.push_back(table);
    return table.id;
}

} // namespace limen::worlds
