#include "worlds/generate/SmallPictures.h"

#include "worlds/pictures/Noise.h"
#include "worlds/records/Materials.h"
#include "worlds/records/PixelEncoder.h"

#include <array>

namespace limen::worlds {

namespace {

constexpr auto kMaterials = static_cast<std::uint32_t>(Material::Count);
constexpr auto kGrounds = static_cast<std::uint32_t>(Ground::Count);
constexpr std::uint32_t kFirstPicture = 0x06000100u;

enum class Pattern { Grain, Boards, Courses, Slabs, Lattice, Bars, Glow, Wisps, Horizon };

struct Look {
    Vec3f light, dark;
    Pattern pattern = Pattern::Grain;
};

Look lookOf(Material material) {
    switch (material) {
    case Material::Planks:
        return {{0.62f, 0.45f, 0.28f}, {0.36f, 0.24f, 0.14f}, Pattern::Boards};
    case Material::OldPlanks:
    case Material::BarrelStaves:
        return {{0.50f, 0.44f, 0.36f}, {0.26f, 0.22f, 0.17f}, Pattern::Boards};
    case Material::Beam:
    case Material::Oak:
    case Material::Bark:
        return {{0.45f, 0.30f, 0.17f}, {0.24f, 0.15f, 0.08f}, Pattern::Boards};
    case Material::Plaster:
    case Material::InnerPlaster:
    case Material::Linen:
        return {{0.84f, 0.79f, 0.68f}, {0.74f, 0.68f, 0.57f}, Pattern::Grain};
    case Material::StoneWall:
        return {{0.58f, 0.56f, 0.52f}, {0.33f, 0.32f, 0.31f}, Pattern::Courses};
    case Material::Brick:
        return {{0.62f, 0.33f, 0.24f}, {0.55f, 0.52f, 0.47f}, Pattern::Courses};
    case Material::Flagstones:
        return {{0.50f, 0.49f, 0.45f}, {0.24f, 0.24f, 0.23f}, Pattern::Slabs};
    case Material::Rock:
        return {{0.48f, 0.45f, 0.41f}, {0.30f, 0.28f, 0.26f}, Pattern::Grain};
    case Material::Thatch:
        return {{0.66f, 0.55f, 0.30f}, {0.40f, 0.31f, 0.15f}, Pattern::Boards};
    case Material::Leaves:
    case Material::BirchLeaves:
    case Material::PineBranch:
        return {{0.36f, 0.48f, 0.16f}, {0.12f, 0.20f, 0.06f}, Pattern::Lattice};
    case Material::GrassTuft:
    case Material::Flowers:
        return {{0.42f, 0.52f, 0.18f}, {0.18f, 0.26f, 0.08f}, Pattern::Bars};
    case Material::Flame:
    case Material::Sun:
    case Material::Moon:
        return {{1.0f, 0.95f, 0.85f}, {1.0f, 0.7f, 0.4f}, Pattern::Glow};
    case Material::Clouds:
        return {{1.0f, 1.0f, 1.0f}, {0.9f, 0.92f, 0.95f}, Pattern::Wisps};
    case Material::SkyDay:
        return {{0.30f, 0.50f, 0.80f}, {0.72f, 0.82f, 0.90f}, Pattern::Horizon};
    case Material::SkyNight:
        return {{0.01f, 0.02f, 0.06f}, {0.05f, 0.06f, 0.12f}, Pattern::Horizon};
    case Material::Embers:
        return {{1.0f, 0.55f, 0.15f}, {0.45f, 0.10f, 0.02f}, Pattern::Grain};
    case Material::Shadow:
        return {{0.02f, 0.02f, 0.03f}, {0.02f, 0.02f, 0.03f}, Pattern::Glow};
    case Material::WaterDark:
        return {{0.10f, 0.18f, 0.22f}, {0.05f, 0.09f, 0.12f}, Pattern::Grain};
    default:
        return {{0.56f, 0.32f, 0.30f}, {0.34f, 0.18f, 0.20f}, Pattern::Slabs};
    }
}

Look lookOf(Ground ground) {
    switch (ground) {
    case Ground::PackedDirt:
        return {{0.50f, 0.41f, 0.28f}, {0.38f, 0.30f, 0.20f}, Pattern::Grain};
    case Ground::Road:
        return {{0.56f, 0.50f, 0.41f}, {0.40f, 0.35f, 0.28f}, Pattern::Slabs};
    case Ground::Rock:
        return {{0.52f, 0.50f, 0.46f}, {0.34f, 0.33f, 0.30f}, Pattern::Grain};
    case Ground::Stream:
        return {{0.20f, 0.30f, 0.31f}, {0.12f, 0.20f, 0.21f}, Pattern::Grain};
    case Ground::ForestFloor:
        return {{0.34f, 0.30f, 0.17f}, {0.20f, 0.18f, 0.09f}, Pattern::Grain};
    default: {
        const float shade = 0.02f * static_cast<float>(ground);
        return {{0.38f + shade, 0.48f, 0.19f}, {0.24f + shade, 0.33f, 0.11f}, Pattern::Grain};
    }
    }
}

/// Brightness 0..1 and alpha of a texel.
struct Texel {
    double light = 1.0, alpha = 1.0;
};

bool nearZero(double v, double within) {
    const double f = v - std::floor(v);
    return f < within || f > 1.0 - within;
}

Texel texelOf(Pattern pattern, double u, double v, double grain) {
    switch (pattern) {
    case Pattern::Boards:
        return {nearZero(4.0 * v, 0.1) ? 0.0 : 0.5 + 0.5 * grain};
    case Pattern::Courses: {
        const double row = std::floor(4.0 * v);
        const bool joint = nearZero(4.0 * v, 0.1) || nearZero(2.0 * u + 0.5 * row, 0.05);
        return {joint ? 0.0 : 0.6 + 0.4 * grain};
    }
    case Pattern::Slabs:
        return {nearZero(2.0 * u, 0.06) || nearZero(2.0 * v, 0.06) ? 0.0 : 0.6 + 0.4 * grain};
    case Pattern::Lattice:
        return {grain, nearZero(4.0 * u, 0.17) || nearZero(4.0 * v, 0.17) ? 1.0 : 0.0};
    case Pattern::Bars:
        return {grain, nearZero(6.0 * u, 0.2) ? 1.0 : 0.0};
    case Pattern::Glow: {
        const double r = std::hypot(u - 0.5, v - 0.5);
        return {1.0 - r, 1.0 - smoothStep(0.15, 0.5, r)};
    }
    case Pattern::Wisps:
        return {1.0, 0.5 * smoothStep(0.5, 0.9, grain)};
    case Pattern::Horizon:
        return {1.0 - smoothStep(0.2, 0.8, v)};
    case Pattern::Grain:
        break;
    }
    return {grain};
}

Canvas paintSmall(const Look& look, std::uint32_t seed) {
    return Canvas::paint(kSmallPicture, kSmallPicture, [&](double u, double v) {
        const double grain = 0.5 + 0.5 * gradientNoise(u, v, 8, 8, seed);
        const Texel texel = texelOf(look.pattern, u, v, std::clamp(grain, 0.0, 1.0));
        return Vec4f(glm::mix(look.dark, look.light, static_cast<float>(texel.light)),
                     static_cast<float>(texel.alpha));
    });
}

Canvas paintSmallMaterial(Material material, std::uint32_t seed) {
    const Canvas canvas = paintSmall(lookOf(material), seed);
    return isAdded(material) ? shining(canvas) : canvas;
}

/// The upper layer shows where alpha is 0; north is up.
Canvas paintSmallBlend(std::uint32_t index) {
    return Canvas::paint(kSmallPicture, kSmallPicture, [=](double u, double v) {
        const bool road = index >= 6;
        const bool corner = index < 3 || index == 6;
        const double reach = road ? 0.15 : 0.5;
        const double distance = index == 9 ? std::abs(u - v) * 0.7 : corner ? std::hypot(u, v) : u;
        const double alpha = smoothStep(reach - 0.08, reach + 0.08, distance);
        return Vec4f(1.0f, 1.0f, 1.0f, static_cast<float>(alpha));
    });
}

} // namespace

void addSmallMaterials(WorldRecords& records) {
    addMaterials(records, Pictures::Blank);
    records.palettes.clear();
    for (dat::RenderSurface& image : records.renderSurfaces) {
        const std::uint32_t index = image.id - kFirstPicture;
        if (index >= (groundGrainId() & 0xFFFFFFu) - (kFirstPicture & 0xFFFFFFu))
            continue; // detail pictures
        const bool blend = index >= kMaterials + kGrounds;
        const bool ground = !blend && index >= kMaterials;
        const Canvas canvas = blend    ? paintSmallBlend(index - kMaterials - kGrounds)
                              : ground ? paintSmall(lookOf(static_cast<Ground>(index - kMaterials)), index)
                                       : paintSmallMaterial(static_cast<Material>(index), index);
        const dat::RecordId id = image.id;
        image =
            encodeImage(canvas, blend ? dat::PixelFormat::LandscapeAlpha : dat::PixelFormat::A8R8G8B8).image;
        image.id = id;
    }
}

void addGeneratedMaterials(WorldRecords& records, bool furnished) {
    if (furnished)
        addMaterials(records, Pictures::Painted);
    else
        addSmallMaterials(records);
}

Plants addGeneratedPlants(ModelWriter& writer, bool furnished) {
    constexpr int kField = 64; // texels across a plant
    return furnished ? addPlants(writer, paintMaterial, kField) : addSmallPlants(writer);
}

Plants addSmallPlants(ModelWriter& writer) {
    return addPlants(
        writer,
        [](Material material) { return paintSmall(lookOf(material), static_cast<std::uint32_t>(material)); },
        32);
}

} // namespace limen::worlds
