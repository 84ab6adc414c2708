#include "worlds/builtin/land/RegionBuilder.h"

#include "worlds/builtin/land/TerrainShape.h"

#include <array>

namespace limen::worlds {

namespace {

/// Scene types of the Region, in order; each has one or two Scene records.
enum class Growth : std::uint32_t {
    Nothing,
    Meadow,
    Forest,
    DeepForest,
    WoodEdge,
    LaneSide,
    Rocks,
    Yard,
    Bank,
    Count
};

struct Sprinkle {
    dat::RecordId object = 0;
    int count = 1;          ///< number of entries
    double frequency = 0.7; ///< share of vertices that get one
    double minScale = 0.8, maxScale = 1.2;
};

/// Offsets of a scene's entries from their vertex, metres; the engine turns them by a random quarter.
struct Spread {
    double from = -2.0, to = 22.0;
    double displacement = 4.5; ///< the greatest random addition
};
/// Entries end 17 m before the next vertex. Water reaches 16.6 m around its vertices: half a landcell, and its rough, swaying border.
constexpr Spread kBesideWater{-7.0, 5.0, 2.0};

/// Spreads entries by a fixed pattern: each entry has its own patch and a random offset inside it.
dat::Scene makeScene(dat::RecordId id, const std::vector<Sprinkle>& sprinkles, const Spread& spread) {
    dat::Scene scene;
    scene.id = id;
    int slot = 0;
    for (const Sprinkle& s : sprinkles) {
        for (int k = 0; k < s.count; ++k, ++slot) {
            dat::SceneObject object;
            object.object = s.object;
            const double width = spread.to - spread.from;
            const double x = width * (slot * 0.7548776662 - std::floor(slot * 0.7548776662)) + spread.from;
            const double y = width * (slot * 0.5698402910 - std::floor(slot * 0.5698402910)) + spread.from;
            object.baseLoc.origin = Vec3f(static_cast<float>(x), static_cast<float>(y), 0.0f);
            object.frequency = static_cast<float>(s.frequency);
            object.displaceX = static_cast<float>(spread.displacement);
            object.displaceY = static_cast<float>(spread.displacement);
            object.minScale = static_cast<float>(s.minScale);
            object.maxScale = static_cast<float>(s.maxScale);
            object.maxRotation = 360.0f;
            object.minSlope = 0.55f;
            object.maxSlope = 1.0f;
            scene.objects.push_back(object);
        }
    }
    return scene;
}

std::vector<std::vector<Sprinkle>> scenesOf(Growth growth, const Plants& p) {
    switch (growth) {
    case Growth::Meadow:
        return {{{p.grass, 11, 0.7, 0.8, 1.5},
                 {p.tallGrass, 3, 0.5, 0.8, 1.2},
                 {p.flowers, 3, 0.45},
                 {p.bush, 1, 0.06},
                 {p.rock, 1, 0.08, 0.4, 0.9}},
                {{p.grass, 8, 0.7, 0.8, 1.5},
                 {p.flowers, 6, 0.6},
                 {p.tallGrass, 4, 0.5},
                 {p.oak, 1, 0.05, 0.9, 1.2}}};
    case Growth::Forest:
        return {{{p.oak, 5, 0.65, 0.9, 1.35},
                 {p.birch, 3, 0.6, 0.85, 1.25},
                 {p.pine, 3, 0.6, 0.85, 1.25},
                 {p.bush, 2, 0.5},
                 {p.fern, 4, 0.6, 0.7, 1.3},
                 {p.stump, 1, 0.12}},
                {{p.oak, 5, 0.7, 0.9, 1.4},
                 {p.pine, 2, 0.6, 0.85, 1.2},
                 {p.youngPine, 3, 0.5, 0.7, 1.3},
                 {p.fern, 5, 0.6, 0.7, 1.3},
                 {p.bush, 1, 0.5},
                 {p.rock, 1, 0.3, 0.6, 1.2}}};
    case Growth::DeepForest:
        return {{{p.pine, 9, 0.75, 0.9, 1.4},
                 {p.youngPine, 4, 0.5, 0.7, 1.3},
                 {p.fern, 5, 0.6},
                 {p.stump, 1, 0.15},
                 {p.boulder, 1, 0.06, 0.6, 1.1}}};
    case Growth::WoodEdge:
        return {{{p.bush, 3, 0.5, 0.8, 1.5},
                 {p.birch, 1, 0.35, 0.7, 1.1},
                 {p.oak, 1, 0.2, 0.7, 1.1},
                 {p.grass, 7, 0.7, 0.9, 1.6},
                 {p.flowers, 2, 0.5},
                 {p.fern, 2, 0.5}}};
    case Growth::LaneSide:
        return {{{p.grass, 10, 0.7, 0.7, 1.3},
                 {p.flowers, 4, 0.55},
                 {p.tallGrass, 4, 0.6},
                 {p.bush, 1, 0.18, 0.7, 1.1},
                 {p.rock, 2, 0.2, 0.25, 0.6},
                 {p.birch, 1, 0.07}}};
    case Growth::Rocks:
        return {{{p.boulder, 2, 0.45, 0.5, 1.3},
                 {p.rock, 4, 0.5, 0.5, 1.4},
                 {p.grass, 4, 0.5, 0.7, 1.1},
                 {p.youngPine, 1, 0.2, 0.6, 1.0}}};
    case Growth::Yard:
        return {{{p.grass, 9, 0.6, 0.6, 1.1}, {p.flowers, 5, 0.6}}};
    case Growth::Bank:
        return {{{p.tallGrass, 9, 0.6, 0.9, 1.5},
                 {p.grass, 6, 0.6, 0.8, 1.4},
                 {p.rock, 3, 0.35, 0.4, 1.0},
                 {p.fern, 2, 0.5},
                 {p.flowers, 2, 0.4}}};
    case Growth::Nothing:
    case Growth::Count:
        break;
    }
    return {};
}

void addScenes(dat::Region& region, WorldRecords& records, const Plants& plants) {
    for (std::uint32_t g = 0; g < static_cast<std::uint32_t>(Growth::Count); ++g) {
        dat::SceneType type;
        for (const std::vector<Sprinkle>& sprinkles : scenesOf(static_cast<Growth>(g), plants)) {
            const dat::RecordId id = 0x12000100u + static_cast<dat::RecordId>(records.scenes.size());
            const bool bank = static_cast<Growth>(g) == Growth::Bank;
            records.scenes.push_back(makeScene(id, sprinkles, bank ? kBesideWater : Spread{}));
            type.scenes.push_back(id);
        }
        region.sceneTypes.push_back(std::move(type));
    }
}

struct TerrainLook {
    TerrainKind kind;
    const char* name;
    std::uint32_t colour;
    Ground ground;
    std::uint32_t tiling;
    std::vector<Growth> growth; ///< by scenery index of the terrain word
};

std::vector<TerrainLook> terrainLooks() {
    using enum Growth;
    return {
        {TerrainKind::Grassland, "Grassland", 0xFF5C7030, Ground::Grassland, 4, {Nothing, Meadow, WoodEdge}},
        {TerrainKind::BarrenRock, "BarrenRock", 0xFF77726A, Ground::Rock, 4, {Nothing, Rocks}},
        {TerrainKind::LushGrass, "LushGrass", 0xFF4A6B24, Ground::LushGrass, 4, {Nothing, Meadow, Bank}},
        {TerrainKind::PackedDirt, "PackedDirt", 0xFF6A5438, Ground::PackedDirt, 4, {Nothing, Yard}},
        {TerrainKind::PatchyGrass,
         "PatchyGrassland",
         0xFF707042,
         Ground::PatchyGrass,
         4,
         {Nothing, LaneSide}},
        {TerrainKind::RunningWater, "WaterRunning", 0xFF2C4244, Ground::Stream, 1, {Nothing}},
        {TerrainKind::ForestFloor,
         "ForestFloor",
         0xFF37401E,
         Ground::ForestFloor,
         5,
         {Nothing, Forest, DeepForest}},
        {TerrainKind::Moss, "Moss", 0xFF4C5A22, Ground::Moss, 4, {Nothing, Forest}}};
}

void addTerrainTypes(dat::Region& region) {
    constexpr std::uint32_t kTypes = 32;
    for (std::uint32_t t = 0; t < kTypes; ++t) {
        dat::TerrainType type;
        type.name = "Unused";
        type.colour.argb = 0xFF5C7030;
        for (const TerrainLook& look : terrainLooks()) {
            if (static_cast<std::uint32_t>(look.kind) == t) {
                type.name = look.name;
                type.colour.argb = look.colour;
                for (const Growth growth : look.growth)
                    type.sceneTypes.push_back(static_cast<std::uint32_t>(growth));
            }
        }
        region.terrainTypes.push_back(std::move(type));
    }
}

void addTexMerge(dat::TexMerge& merge) {
    std::uint32_t blend = 0;
    for (int k = 0; k < 3; ++k)
        merge.corners.push_back({8, blendTextureId(blend++)});
    for (int k = 0; k < 3; ++k)
        merge.sides.push_back({9, blendTextureId(blend++)});
    for (const std::uint32_t code : {8u, 9u, 9u, 10u})
        merge.roads.push_back({code, blendTextureId(blend++)});
    // Unused types show the first entry.
    for (const TerrainLook& look : terrainLooks()) {
        dat::TerrainTexture texture;
        texture.terrainType = static_cast<std::uint32_t>(look.kind);
        texture.texture = groundTextureId(look.ground);
        texture.tiling = look.tiling;
        merge.textures.push_back(texture);
    }
    dat::TerrainTexture road;
    road.terrainType = 0x20;
    road.texture = groundTextureId(Ground::Road);
    road.tiling = 3;
    merge.textures.push_back(road);
    // By row: grain of the ground, of exteriors and of shells.
    constexpr std::uint32_t kGrainTiling = 4;
    const std::array grains{groundGrainId(), wallGrainId(), wallGrainId()};
    for (std::size_t row = 0; row < grains.size(); ++row) {
        merge.textures[row].detailTexture = grains[row];
        merge.textures[row].detailTiling = kGrainTiling;
    }
}

dat::GameTime calendar() {
    dat::GameTime time;
    time.zeroTimeOfYear = 3600.0;
    time.zeroYear = 1;
    time.yearSpec = "Y";
    constexpr int kHours = 16;
    for (int h = 0; h < kHours; ++h) {
        dat::TimeOfDay hour;
        hour.start = static_cast<float>(h) / kHours;
        hour.isNight = h < 4 || h >= 12 ? 1u : 0u;
        hour.name = (hour.isNight != 0 ? "Watch " : "Bell ") + std::to_string(h + 1);
        time.timesOfDay.push_back(std::move(hour));
    }
    for (const char* day : {"Threshold", "Hearth", "Lane", "Hill", "Wood", "Cellar"})
        time.daysOfWeek.emplace_back(day);
    std::uint32_t start = 0;
    for (const char* season : {"Budding", "High Sun", "Harvest", "Frost"}) {
        time.seasons.push_back({start, season});
        start += 90;
    }
    return time;
}

} // namespace

void addRegion(ModelWriter& writer, const Plants& plants) {
    dat::Region region;
    region.id = dat::kRegionId;
    region.name = "Limen";
    region.partsMask = dat::Region::kScene | dat::Region::kSky;
    region.landDefs.maxObjHeight = 200.0f;
    region.landDefs.skyHeight = 1000.0f;
    region.landDefs.roadWidth = 5.0f;
    for (int i = 0; i < 256; ++i)
        region.landDefs.heights[static_cast<std::size_t>(i)] = static_cast<float>(heightOfIndex(i));
    region.gameTime = calendar();
    region.sky = buildSky(writer);
    addScenes(region, writer.records(), plants);
    addTerrainTypes(region);
    addTexMerge(region.texMerge);
    writer.records().regions.push_back(std::move(region));
}

} // namespace limen::worlds
