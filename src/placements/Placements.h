#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The placed objects of a world, as a game server keeps them: objects that stand in landblocks, and the
// templates that describe them (docs/placements.md). Plain data. Positions are metres of the landblock, whose
// number is the upper half of the cell's id.
namespace limen::placements {

/// A position and an orientation. All numbers are finite.
struct Spot {
    std::uint32_t cell = 0; ///< an indoor cell; a lower half below 0x0100: outdoors
    std::array<float, 3> origin{};
    std::array<float, 4> angles{1.0f, 0.0f, 0.0f, 0.0f}; ///< quaternion w, x, y, z; may lack unit length
    friend bool operator==(const Spot&, const Spot&) = default;
};

/// The landblock of a position: x in the upper byte, y in the lower one.
[[nodiscard]] constexpr std::uint32_t landblockOf(const Spot& spot) {
    return spot.cell >> 16;
}

/// One object that stands in the world.
struct Placement {
    std::uint32_t guid = 0;       ///< unique in the world
    std::uint32_t templateId = 0; ///< key of Content::templates; the template may be missing
    Spot spot;
    bool isLinkChild = false; ///< it exists because its parent does
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// A dependency: the child is placed when the parent is.
struct Link {
    std::uint32_t parent = 0, child = 0; ///< guids
    friend auto operator<=>(const Link&, const Link&) = default;
};

/// The objects of one landblock.
struct Landblock {
    std::vector<Placement> placements; ///< ascending guids
    std::vector<Link> links;           ///< ascending; of parents that stand in this landblock
    friend bool operator==(const Landblock&, const Landblock&) = default;
};

/// The types of templates that Limen treats in their own way; there are others.
enum class TemplateType : std::int32_t {
    Generic = 1,
    Portal = 7,
    Creature = 10,
    Vendor = 12,
    Door = 19,
    Chest = 20,
    Container = 21,
    PressurePlate = 24,
    Lifestone = 25,
    Switch = 26
};
/// The type's name for people, e.g. "door"; "type 47" for types without a name.
[[nodiscard]] std::string typeName(std::int32_t type);
/// The type that a name of typeName() stands for.
[[nodiscard]] std::optional<std::int32_t> parseType(const std::string& name);

/// Bits of Template::physicsState.
inline constexpr std::uint32_t kEthereal = 0x4, kNoDraw = 0x20, kHidden = 0x4000, kCloaked = 0x100000;

/// A range of a palette that replaces the same range of the base palette.
struct PaletteChange {
    std::uint32_t palette = 0;
    std::uint16_t offset = 0, length = 0; ///< in groups of eight colours; length 0: to the end
    friend bool operator==(const PaletteChange&, const PaletteChange&) = default;
};
/// A texture of one part that is replaced.
struct TextureChange {
    std::uint8_t part = 0;
    std::uint32_t from = 0, to = 0;
    friend bool operator==(const TextureChange&, const TextureChange&) = default;
};
/// A part of the Setup that is replaced.
struct PartChange {
    std::uint8_t part = 0;
    std::uint32_t model = 0;
    friend bool operator==(const PartChange&, const PartChange&) = default;
};
/// An object that the object has from the start.
struct CreatedItem {
    static constexpr std::int32_t kWield = 2; ///< bit of `destination`: worn or wielded
    static constexpr std::int32_t kTreasure =
        8; ///< bit of `destination`: a shade other than 0 is the item's probability
    std::int32_t destination = 0;
    std::uint32_t templateId = 0;
    std::int32_t palette = 0; ///< palette template; 0: that of the item's own template
    float shade = 0.0f;       ///< 0: that of the item's own template
    friend bool operator==(const CreatedItem&, const CreatedItem&) = default;
};
/// An entry of a generator: it makes objects of one template.
struct GeneratorEntry {
    float probability = 1.0f; ///< up to which a random number selects the entry; -1: always
    std::uint32_t templateId = 0;
    std::int32_t initCreate = 1, maxCreate = 1;
    std::uint32_t whenCreate = 2, whereCreate = 4;
    std::optional<std::uint32_t> palette;
    std::optional<float> shade;
    std::optional<Spot> spot; ///< cell 0: relative to the generator
    friend bool operator==(const GeneratorEntry&, const GeneratorEntry&) = default;
};

/// The description that placed objects of one kind share. Ids of records are 0 where there is none.
struct Template {
    std::uint32_t id = 0;
    std::string className;
    std::int32_t type = 0;
    std::string name; ///< for people; empty: none

    std::uint32_t setup = 0, motionTable = 0, paletteBase = 0, clothingBase = 0;
    std::uint32_t physicsEffects = 0; ///< a PhysicsScriptTable, in place of the Setup's
    std::uint32_t physicsScript = 0;  ///< the kind of script of that table that plays from the start; 0: none
    // Of a person's head. A texture replaces the plain one of the same feature.
    std::uint32_t eyesTexture = 0, noseTexture = 0, mouthTexture = 0;
    std::uint32_t plainEyesTexture = 0, plainNoseTexture = 0, plainMouthTexture = 0;
    std::uint32_t hairPalette = 0, eyesPalette = 0, skinPalette = 0, headObject = 0;

    std::optional<std::int32_t> paletteTemplate, physicsState, maxGenerated, initGenerated;
    // Of an item that can be worn or held (Equipment.h).
    std::optional<std::int32_t> itemType, clothingPriority, validLocations, combatStyle, parentLocation,
        placementPosition;
    std::optional<double> shade, scale, translucency, generatorRadius, scriptIntensity;
    std::optional<bool> open, locked, ethereal, visibility, defaultOpen, defaultLocked, noDraw;

    std::vector<PaletteChange> palettes;
    std::vector<TextureChange> textures;
    std::vector<PartChange> parts;
    std::vector<CreatedItem> items;
    std::vector<GeneratorEntry> generator;
    std::optional<Spot> destination; ///< of a travel portal
    friend bool operator==(const Template&, const Template&) = default;
};

/// All placed objects of a world and their templates.
struct Content {
    std::map<std::uint32_t, Landblock> landblocks;
    std::map<std::uint32_t, Template> templates;
    friend bool operator==(const Content&, const Content&) = default;
};

/// The number of placed objects.
[[nodiscard]] std::size_t countPlacements(const Content& content);

} // namespace limen::placements
