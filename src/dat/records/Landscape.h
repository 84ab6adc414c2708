#pragma once

#include "dat/records/Primitives.h"

#include <array>
#include <optional>

// Region (0x13) and Scene (0x12): docs/formats/landscape.md, docs/formats/sky_weather.md.
LIMEN_API_BEGIN
namespace limen::dat {

/// Strings keep their bytes (Windows-1252).
struct LandDefs {
    std::int32_t numBlockLength = 255, numBlockWidth = 255;
    float squareLength = 24.0f;
    std::int32_t lblockLength = 8, vertexPerCell = 1;
    float maxObjHeight = 0.0f, skyHeight = 0.0f, roadWidth = 5.0f;
    std::array<float, 256> heights{};
};

struct TimeOfDay {
    float start = 0.0f;
    std::uint32_t isNight = 0;
    std::string name;
};

struct Season {
    std::uint32_t startDay = 0;
    std::string name;
};

struct GameTime {
    double zeroTimeOfYear = 0.0;
    std::uint32_t zeroYear = 0;
    float dayLength = 7620.0f;
    std::uint32_t daysPerYear = 360;
    std::string yearSpec;
    std::vector<TimeOfDay> timesOfDay;
    std::vector<std::string> daysOfWeek;
    std::vector<Season> seasons;
};

struct SkyObject {
    float beginTime = 0.0f, endTime = 0.0f, beginAngle = 0.0f, endAngle = 0.0f;
    float texVelocityX = 0.0f, texVelocityY = 0.0f;
    std::uint32_t object = 0; ///< GfxObj or Setup
    std::uint32_t script = 0;
    std::uint32_t properties = 0;
};

struct SkyObjectReplace {
    std::uint32_t objectIndex = 0, gfxObj = 0;
    float rotate = 0.0f, transparent = 0.0f, luminosity = 0.0f, maxBright = 0.0f;
};

struct SkyTimeOfDay {
    float begin = 0.0f, dirBright = 0.0f, dirHeading = 0.0f, dirPitch = 0.0f;
    Colour dirColour;
    float ambBright = 0.0f;
    Colour ambColour;
    float minFog = 0.0f, maxFog = 0.0f;
    Colour fogColour;
    std::uint32_t fogMode = 0;
    std::vector<SkyObjectReplace> replaces;
};

struct DayGroup {
    float chance = 0.0f;
    std::string name;
    std::vector<SkyObject> objects;
    std::vector<SkyTimeOfDay> times;
};

struct SkyDesc {
    double tickSize = 0.0, lightTickSize = 0.0;
    std::vector<DayGroup> dayGroups;
};

struct AmbientSound {
    std::uint32_t soundType = 0;
    float volume = 0.0f, chance = 0.0f, minRate = 0.0f, maxRate = 0.0f;
};

struct AmbientSoundTable {
    std::uint32_t soundTable = 0;
    std::vector<AmbientSound> sounds;
};

struct SceneType {
    std::uint32_t ambientSound = 0;
    std::vector<std::uint32_t> scenes; ///< Scene ids
};

struct TerrainType {
    std::string name;
    Colour colour;
    std::vector<std::uint32_t> sceneTypes; ///< indices into Region::sceneTypes
};

/// A blend map; `code` is its tcode (corner 8, side 9) or rcode (road).
struct AlphaMap {
    std::uint32_t code = 0;
    std::uint32_t texture = 0; ///< SurfaceTexture id
};

struct TerrainTexture {
    std::uint32_t terrainType = 0; ///< 0..31, 0x20 = road
    std::uint32_t texture = 0;     ///< SurfaceTexture id
    std::uint32_t tiling = 1;      ///< repeats per landcell
    std::uint32_t maxBright = 0, minBright = 0, maxSaturate = 0, minSaturate = 0, maxHue = 0, minHue = 0;
    std::uint32_t detailTiling = 0, detailTexture = 0;
};

struct TexMerge {
    std::uint32_t baseTexSize = 0x400;
    std::vector<AlphaMap> corners, sides, roads;
    std::vector<TerrainTexture> textures;
};

struct RegionMisc {
    std::uint32_t version = 0, gameMap = 0, autotestMap = 0, autotestMapSize = 0, clearCell = 0,
                  clearMonster = 0;
};

struct Region {
    static constexpr std::uint32_t kSound = 1, kScene = 2, kSky = 0x10, kMisc = 0x200;
    std::uint32_t id = 0, regionNumber = 1, version = 3;
    std::string name;
    LandDefs landDefs;
    GameTime gameTime;
    std::uint32_t partsMask = 0;
    SkyDesc sky;                           ///< partsMask & kSky
    std::vector<AmbientSoundTable> sounds; ///< partsMask & kSound
    std::vector<SceneType> sceneTypes;     ///< partsMask & kScene
    std::vector<TerrainType> terrainTypes;
    std::uint32_t landSurfType = 0;
    TexMerge texMerge;
    RegionMisc misc; ///< partsMask & kMisc
};

/// A model that a Scene scatters, and its parameters.
struct SceneObject {
    std::uint32_t object = 0;
    Frame baseLoc;
    float frequency = 0.0f, displaceX = 0.0f, displaceY = 0.0f, minScale = 1.0f, maxScale = 1.0f,
          maxRotation = 0.0f;
    float minSlope = 0.0f, maxSlope = 1.0f;
    std::int32_t align = 0, orient = 0;
    std::uint32_t weenieObj = 0;
};

struct Scene {
    std::uint32_t id = 0;
    std::vector<SceneObject> objects;
};

} // namespace limen::dat
LIMEN_API_END
