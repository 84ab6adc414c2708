#include "worlds/records/Materials.h"

#include "core/Assert.h"
#include "worlds/pictures/Painters.h"
#include "worlds/records/MaterialRecipes.h"
#include "worlds/records/PixelEncoder.h"

#include <array>

namespace limen::worlds {

namespace {

using dat::PixelFormat;
using S = dat::Surface;

// Texture ids in one range, in this order: pictures of materials, of the ground, blend maps, detail
// pictures.
constexpr std::uint32_t kFirstRecord = 0x100;
constexpr auto kMaterialCount = static_cast<std::uint32_t>(Material::Count);
constexpr auto kGroundCount = static_cast<std::uint32_t>(Ground::Count);
constexpr std::array kBlends{BlendShape::Corner,      BlendShape::Corner,   BlendShape::Corner,
                             BlendShape::Side,        BlendShape::Side,     BlendShape::Side,
                             BlendShape::RoadCorner,  BlendShape::RoadSide, BlendShape::RoadSide,
                             BlendShape::RoadDiagonal};
constexpr std::uint32_t kGroundGrain = kMaterialCount + kGroundCount + kBlends.size();
constexpr std::uint32_t kWallGrain = kGroundGrain + 1;

Canvas paintSprite(Material material) {
    switch (material) {
    case Material::Glass:
        return paintGlass();
    case Material::Smoke:
        return paintSmoke();
    case Material::Fire:
        return paintFire();
    case Material::Firefly:
        return paintFirefly();
    case Material::Snowflake:
        return paintSnowflake();
    case Material::Swirl:
        return paintSwirl();
    case Material::Shadow:
        return paintShadow();
    case Material::Sacking:
        return paintLinen({0.46f, 0.37f, 0.25f}, 40);
    default:
        return Canvas(0, 0);
    }
}

Canvas paintNature(Material material) {
    switch (material) {
    case Material::Bark:
        return paintBark();
    case Material::Rock:
        return paintRock(256);
    case Material::Leaves:
        return paintLeaves({0.42f, 0.52f, 0.17f}, {0.10f, 0.18f, 0.055f}, 900, 2101);
    case Material::BirchLeaves:
        return paintLeaves({0.62f, 0.62f, 0.20f}, {0.22f, 0.30f, 0.09f}, 640, 2103);
    case Material::PineBranch:
        return paintPineBranch();
    case Material::GrassTuft:
        return paintGrassTuft();
    case Material::Flowers:
        return paintFlowers();
    case Material::FarPlants:
        return blankPicture();
    case Material::WaterDark:
        return paintWater();
    case Material::SkyNight:
        return paintNightSky();
    case Material::SkyDay:
        return paintDaySky();
    case Material::SkyDusk:
        return paintDuskSky();
    case Material::SkySnow:
        return paintSnowSky();
    case Material::Rain:
        return paintRain();
    case Material::Sun:
        return paintSun();
    case Material::Moon:
        return paintMoon();
    case Material::Clouds:
        return paintClouds();
    default:
        return paintSprite(material);
    }
}

Canvas paintGround(Ground ground) {
    switch (ground) {
    case Ground::Grassland:
        return paintGrass({.seed = 2201});
    case Ground::LushGrass:
        return paintGrass({.light = {0.37f, 0.44f, 0.18f}, .dark = {0.16f, 0.22f, 0.08f}, .seed = 2203});
    case Ground::PatchyGrass:
        return paintGrass(
            {.light = {0.52f, 0.54f, 0.25f}, .dark = {0.25f, 0.29f, 0.11f}, .bare = 0.32, .seed = 2205});
    case Ground::PackedDirt:
        return paintDirt();
    case Ground::ForestFloor:
        return paintForestFloor();
    case Ground::Rock:
        return paintRock(512);
    case Ground::Moss:
        return paintGrass({.light = {0.34f, 0.42f, 0.12f},
                           .dark = {0.12f, 0.19f, 0.05f},
                           .earth = {0.20f, 0.15f, 0.09f},
                           .bare = 0.2,
                           .seed = 2207});
    case Ground::Road:
        return paintRoad();
    case Ground::Stream:
        return paintStream();
    case Ground::Count:
        break;
    }
    return Canvas(0, 0);
}

dat::RecordId textureId(std::uint32_t index) {
    return 0x05000000u + kFirstRecord + index;
}

dat::RecordId pictureId(std::uint32_t index) {
    return 0x06000000u + kFirstRecord + index;
}

void addTexture(WorldRecords& records, std::uint32_t index, const Canvas& canvas, PixelFormat format) {
    EncodedImage encoded = encodeImage(canvas, format);
    encoded.image.id = pictureId(index);
    if (!encoded.palette.colours.empty()) {
        encoded.palette.id = 0x04000000u + kFirstRecord + index;
        encoded.image.defaultPalette = encoded.palette.id;
        records.palettes.push_back(std::move(encoded.palette));
    }
    dat::SurfaceTexture texture;
    texture.id = textureId(index);
    texture.images.push_back(encoded.image.id);
    records.surfaceTextures.push_back(std::move(texture));
    records.renderSurfaces.push_back(std::move(encoded.image));
}

void addMaterial(WorldRecords& records, Material material, Pictures pictures) {
    const MaterialRecipe r = recipeOf(material);
    dat::Surface surface;
    surface.type = r.type;
    surface.translucency = r.translucency;
    surface.luminosity = r.luminosity;
    surface.diffuse = r.diffuse;
    if (surface.hasImage()) {
        const auto index = static_cast<std::uint32_t>(material);
        surface.texture = textureId(index);
        const Canvas painted = pictures == Pictures::Painted ? paintMaterial(material) : blankPicture();
        addTexture(records, index, isAdded(material) ? shining(painted) : painted, r.format);
    } else {
        surface.colour.argb = r.colour;
    }
    records.surfaces.emplace_back(surfaceId(material), surface);
}

} // namespace

Canvas blankPicture() {
    return Canvas(4, 4, Vec4f(0.5f, 0.5f, 0.5f, 1.0f));
}

double metresPerTile(Material material) {
    return recipeOf(material).metres;
}

bool isCard(Material material) {
    return (recipeOf(material).type & (S::kBase1ClipMap | S::kAlpha | S::kAdditive | S::kTranslucent)) != 0;
}

bool isAdded(Material material) {
    return (recipeOf(material).type & (S::kAdditive | S::kAlpha)) == S::kAdditive;
}

dat::RecordId surfaceId(Material material) {
    return 0x08000000u + kFirstRecord + static_cast<std::uint32_t>(material);
}
dat::RecordId groundTextureId(Ground ground) {
    return textureId(kMaterialCount + static_cast<std::uint32_t>(ground));
}
dat::RecordId blendTextureId(std::uint32_t index) {
    return textureId(kMaterialCount + kGroundCount + index);
}

dat::RecordId groundGrainId() {
    return textureId(kGroundGrain);
}
dat::RecordId wallGrainId() {
    return textureId(kWallGrain);
}

Canvas paintMaterial(Material material) {
    switch (material) {
    case Material::Planks:
        return paintBoards({.boards = 9, .seed = 2301});
    case Material::OldPlanks:
        return paintBoards({.boards = 8,
                            .light = {0.50f, 0.42f, 0.31f},
                            .dark = {0.25f, 0.20f, 0.145f},
                            .weathering = 0.7,
                            .seed = 2303});
    case Material::Beam:
        return paintBeam();
    case Material::Oak:
        return paintBoards({.boards = 3,
                            .light = {0.55f, 0.38f, 0.21f},
                            .dark = {0.31f, 0.19f, 0.10f},
                            .weathering = 0.05,
                            .endJoints = false,
                            .seed = 2305});
    case Material::Plaster:
        return paintPlaster({0.86f, 0.82f, 0.72f}, 0.55, 2307);
    case Material::InnerPlaster:
        return paintPlaster({0.84f, 0.79f, 0.69f}, 0.25, 2309);
    case Material::StoneWall:
        return paintStoneWall();
    case Material::Flagstones:
        return paintFlagstones();
    case Material::Brick:
        return paintBricks();
    case Material::Thatch:
        return paintThatch();
    case Material::Rug:
        return paintRug();
    case Material::Blanket:
        return paintBlanket();
    case Material::Linen:
        return paintLinen({0.80f, 0.76f, 0.67f}, 80);
    case Material::Books:
        return paintBooks();
    case Material::BarrelStaves:
        return paintBarrelStaves();
    case Material::LogEnds:
        return paintLogEnds();
    case Material::Embers:
        return paintEmbers();
    case Material::Flame:
        return paintFlame();
    default:
        return paintNature(material);
    }
}

void addMaterials(WorldRecords& records, Pictures pictures) {
    const bool painted = pictures == Pictures::Painted;
    for (std::uint32_t m = 0; m < kMaterialCount; ++m)
        addMaterial(records, static_cast<Material>(m), pictures);
    for (std::uint32_t g = 0; g < kGroundCount; ++g) {
        // One picture in the landscape's own format, the others in the common ones.
        const PixelFormat format = g == 0       ? PixelFormat::LandscapeR8G8B8
                                   : g % 2 == 0 ? PixelFormat::Dxt1
                                                : PixelFormat::R8G8B8;
        addTexture(records, kMaterialCount + g,
                   painted ? paintGround(static_cast<Ground>(g)) : blankPicture(), format);
    }
    for (std::uint32_t b = 0; b < kBlends.size(); ++b) {
        addTexture(records, kMaterialCount + kGroundCount + b,
                   painted ? paintBlend(kBlends[b], 2401 + b) : blankPicture(), PixelFormat::LandscapeAlpha);
    }
    // Blank ones leave colours as they are.
    const Canvas none(4, 4, Vec4f(0.0f));
    addTexture(records, kGroundGrain, painted ? paintGroundGrain() : none, PixelFormat::A8R8G8B8);
    addTexture(records, kWallGrain, painted ? paintWallGrain() : none, PixelFormat::A8R8G8B8);
}

void setPicture(WorldRecords& records, Material material, const Canvas& canvas) {
    const dat::RecordId id = pictureId(static_cast<std::uint32_t>(material));
    for (dat::RenderSurface& image : records.renderSurfaces) {
        if (image.id == id) {
            image = encodeImage(canvas, recipeOf(material).format).image;
            image.id = id;
        }
    }
}

} // namespace limen::worlds
