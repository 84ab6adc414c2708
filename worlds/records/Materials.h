#pragma once

#include "worlds/pictures/Canvas.h"
#include "worlds/records/WorldRecords.h"

#include <cstdint>

namespace limen::worlds {

/// Surface materials of the built-in world. The order determines the ids of the records.
enum class Material : std::uint8_t {
    Planks,    ///< floor boards, grain along u
    OldPlanks, ///< rough grey-brown boards: fences, crates, doors
    Beam,      ///< dark oak, grain along u
    Oak,       ///< furniture wood, grain along u
    Plaster,   ///< lime-washed outer walls
    InnerPlaster,
    StoneWall,
    Flagstones,
    Brick,
    Thatch, ///< stalks run down v
    Bark,
    Rock,
    Leaves,      ///< cut-out
    BirchLeaves, ///< cut-out
    PineBranch,  ///< cut-out, stem along u from 0
    GrassTuft,   ///< cut-out, roots at v = 1
    Flowers,     ///< cut-out, roots at v = 1
    Rug,
    Blanket,
    Linen,
    Books,
    BarrelStaves,
    LogEnds,
    Iron,      ///< solid colour
    Wax,       ///< solid colour
    Embers,    ///< glows
    Flame,     ///< glows, additive
    LampGlass, ///< glows, translucent
    WaterDark,
    SkyNight,
    SkyDay,
    SkyDusk,
    Sun,
    Moon,
    Clouds,
    Glass,     ///< translucent: leaded panes
    Smoke,     ///< sprite, translucent
    Fire,      ///< sprite, glows, additive
    Firefly,   ///< sprite, glows, additive
    Swirl,     ///< sprite, glows, additive
    Snowflake, ///< sprite, translucent
    SkySnow,   ///< a sky that is one cloud
    Rain,      ///< streaks, additive
    Skin,      ///< solid colours from here on
    Hair,
    BlueCloth,
    GreenCloth,
    BrownCloth,
    RedCloth,
    FarPlants, ///< cut-out: plants drawn from the side, for their far levels of detail
    Sacking,   ///< coarse brown cloth
    Shadow,    ///< translucent: a soft dark disc on the ground below a body
    Count
};

/// Ground pictures, in the order of their ids.
enum class Ground : std::uint8_t {
    Grassland,
    LushGrass,
    PatchyGrass,
    PackedDirt,
    ForestFloor,
    Rock,
    Moss,
    Road,
    Stream,
    Count
};

/// Metres of surface that one repeat of the picture covers, along u and v. Unused for pictures on cards.
[[nodiscard]] double metresPerTile(Material material);
/// Whether the picture is not opaque or shows one thing, so that its border must not wrap around.
[[nodiscard]] bool isCard(Material material);
/// Whether the picture is added to the background whole, whatever its alpha.
[[nodiscard]] bool isAdded(Material material);
/// Id of the Surface record.
[[nodiscard]] dat::RecordId surfaceId(Material material);
/// Id of the SurfaceTexture of a ground picture, or of the `index`-th blend map.
[[nodiscard]] dat::RecordId groundTextureId(Ground ground);
[[nodiscard]] dat::RecordId blendTextureId(std::uint32_t index);
/// Ids of the SurfaceTextures of the detail pictures.
[[nodiscard]] dat::RecordId groundGrainId();
[[nodiscard]] dat::RecordId wallGrainId();

/// The picture of a material as painted, before it is encoded; empty (0 × 0) for solid colours.
[[nodiscard]] Canvas paintMaterial(Material material);

/// Blank: pictures are small grey squares in their formats. For tests of shapes: painting takes nearly all of
/// the time.
enum class Pictures : std::uint8_t { Painted, Blank };

/// A grey square, in place of a picture.
[[nodiscard]] Canvas blankPicture();

/// Adds Surface, SurfaceTexture, RenderSurface and Palette records for all materials, grounds and blend maps.
/// FarPlants is blank until its picture is set.
void addMaterials(WorldRecords& records, Pictures pictures);

/// Replaces the picture of a material. Requires: addMaterials; a format without a palette.
void setPicture(WorldRecords& records, Material material, const Canvas& canvas);

} // namespace limen::worlds
