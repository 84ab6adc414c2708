#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <optional>
#include <string>
#include <vector>

namespace limen::world {

/// One garment: a ClothingTable and its colours.
struct ClothingEntry {
    dat::RecordId table = 0;
    std::uint32_t palette = 0; ///< one of its palette templates; 0: colours unchanged
    /// One to four, by palette change of the template; later changes have the last. Each picks a palette of a
    /// set: 0 the first .. 1 the last. Outside 0..1 the change has no effect.
    std::vector<double> shades{0.5};
};

/// Changes to the look of one object, beside its clothes.
struct LookEntry {
    struct Colours {
        dat::RecordId palette = 0;
        std::uint32_t offset = 0, count = 0; ///< in colours
    };
    struct Texture {
        std::uint32_t part = 0;
        dat::RecordId from = 0, to = 0; ///< SurfaceTextures (0x05)
    };
    struct Part {
        std::uint32_t part = 0;
        dat::RecordId gfxObj = 0;
    };
    std::vector<Colours> colours; ///< over the colours of the clothes
    std::vector<Texture> textures;
    std::vector<Part> parts;
};

/// A thing in an object's hands.
struct HeldEntry {
    dat::RecordId model = 0;     ///< a Setup
    std::uint32_t location = 0;  ///< key of a holding location of the holder's Setup
    std::uint32_t placement = 0; ///< key of a placement frame of its own Setup
    double scale = 1.0;          ///< its own, whatever the holder's is
    std::vector<ClothingEntry> clothing;
    dat::RecordId basePalette = 0;
    LookEntry look;
};

/// A script of a PhysicsScriptTable that plays from the start of the world.
struct PlayEntry {
    std::uint32_t kind = 0; ///< 0: none
    double intensity = 0.0;
};

/// The place that a travel portal leads to.
struct TravelEntry {
    dat::RecordId cell = 0; ///< 0: outside
    Vec3 feet{0.0};         ///< global
    double yaw = 0.0;       ///< compass direction, degrees
    friend bool operator==(const TravelEntry&, const TravelEntry&) = default;
};

/// An object that a world database places, with everything that its look needs (docs/placements.md).
struct PlacedEntry {
    enum class Kind : std::uint8_t {
        Thing, ///< stands still, or moves in place
        Door   ///< opens and shuts, in the opening that it stands before
    };
    Kind kind = Kind::Thing;
    std::uint64_t id = 0;                     ///< unique in the world, below 2^56
    std::uint32_t templateId = 0;             ///< for people
    std::string name;                         ///< unique in the world
    dat::RecordId model = 0, motionTable = 0; ///< motionTable 0: that of the Setup
    dat::RecordId cell = 0;                   ///< 0: outside
    dat::BlockCoord block;                    ///< the landblock that it belongs to
    Vec3 position{0.0};                       ///< global
    Quat orientation{1.0, 0.0, 0.0, 0.0};     ///< a unit quaternion
    double scale = 1.0;
    double opacity = 1.0;
    bool isOpen = false;                 ///< of a door or a thing that opens, initially
    bool isLocked = false;               ///< nobody opens it by hand
    bool mayOpen = false;                ///< a thing that opens if its motion table can show it shut and open
    bool stopsBodies = true;             ///< false: bodies walk through it
    bool isOnGround = false;             ///< outside: its height is that of the ground, where there is ground
    std::vector<ClothingEntry> clothing; ///< later entries cover earlier ones
    dat::RecordId basePalette = 0;       ///< of all indexed pictures; 0: each has its own
    LookEntry beneath;                   ///< of the body: its skin, and a person's head; clothes cover it
    LookEntry look;
    std::vector<HeldEntry> held;
    dat::RecordId scriptTable = 0; ///< of its effects; 0: that of the Setup
    PlayEntry play;
    std::optional<TravelEntry> travel; ///< of a travel portal
};

} // namespace limen::world
