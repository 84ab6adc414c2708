#include "worlds/records/MaterialRecipes.h"

namespace limen::worlds {

namespace {

using dat::PixelFormat;
using S = dat::Surface;

MaterialRecipe solid(std::uint32_t argb, float luminosity = 0.0f) {
    return {1.0,
            PixelFormat::A8R8G8B8,
            luminosity > 0.0f ? S::kBase1Solid | S::kLuminous : S::kBase1Solid,
            luminosity,
            1.0f,
            0.0f,
            argb};
}
MaterialRecipe image(double metres, PixelFormat format) {
    return {metres, format, S::kBase1Image, 0.0f, 1.0f, 0.0f, 0};
}
MaterialRecipe cutOut(PixelFormat format) {
    return {1.0, format, S::kBase1ClipMap, 0.0f, 1.0f, 0.0f, 0};
}
MaterialRecipe glow(PixelFormat format, std::uint32_t type) {
    return {1.0, format, S::kBase1Image | S::kLuminous | type, 1.0f, 0.0f, 0.0f, 0};
}

MaterialRecipe folkRecipe(Material material) {
    switch (material) {
    case Material::Sacking:
        return image(1.0, PixelFormat::Dxt1);
    case Material::Glass:
        return {0.5, PixelFormat::A8R8G8B8, S::kBase1Image | S::kAlpha, 0.0f, 1.0f, 0.0f, 0};
    case Material::Snowflake: // bright from all sides
        return {1.0, PixelFormat::A8R8G8B8, S::kBase1Image | S::kAlpha | S::kLuminous, 0.62f, 1.0f, 0.0f, 0};
    case Material::Smoke:
    case Material::Shadow:
        return {1.0, PixelFormat::A8R8G8B8, S::kBase1Image | S::kAlpha, 0.0f, 1.0f, 0.0f, 0};
    case Material::Fire:
    case Material::Firefly:
    case Material::Swirl:
        return glow(PixelFormat::A8R8G8B8, S::kAdditive);
    case Material::Skin:
        return solid(0xFFC99A78);
    case Material::Hair:
        return solid(0xFF3E2B1E);
    case Material::BlueCloth:
        return solid(0xFF3D4F73);
    case Material::GreenCloth:
        return solid(0xFF4F5F36);
    case Material::BrownCloth:
        return solid(0xFF6B4E35);
    case Material::RedCloth:
        return solid(0xFF8A3B30);
    default:
        return {};
    }
}

MaterialRecipe natureRecipe(Material material) {
    switch (material) {
    case Material::Bark:
        return image(1.4, PixelFormat::Dxt1);
    case Material::Rock:
        return image(2.5, PixelFormat::Dxt1);
    case Material::Leaves:
        return cutOut(PixelFormat::P8);
    case Material::BirchLeaves:
        return cutOut(PixelFormat::Dxt1);
    case Material::PineBranch:
        return cutOut(PixelFormat::Index16);
    case Material::GrassTuft:
        return cutOut(PixelFormat::P8);
    case Material::Flowers:
    case Material::FarPlants:
        return cutOut(PixelFormat::A8R8G8B8);
    case Material::WaterDark:
        return image(1.0, PixelFormat::R5G6B5);
    case Material::SkyNight:
        return glow(PixelFormat::R8G8B8, 0);
    case Material::SkyDay:
    case Material::SkySnow:
        return glow(PixelFormat::R8G8B8, S::kTranslucent);
    case Material::SkyDusk:
        return glow(PixelFormat::A8R8G8B8, S::kAlpha);
    case Material::Rain:
        return {1.0,
                PixelFormat::A8R8G8B8,
                S::kBase1Image | S::kAlpha | S::kAdditive | S::kTranslucent,
                0.148f,
                1.0f,
                0.5f,
                0};
    case Material::Sun:
        return glow(PixelFormat::A8, S::kAdditive);
    case Material::Moon:
        return glow(PixelFormat::A8R8G8B8, S::kAlpha);
    case Material::Clouds: // lit by the sky
        return {1.0, PixelFormat::A8R8G8B8, S::kBase1Image | S::kAlpha, 0.0f, 1.0f, 0.0f, 0};
    default:
        return folkRecipe(material);
    }
}

} // namespace

MaterialRecipe recipeOf(Material material) {
    switch (material) {
    case Material::Planks:
        return image(2.0, PixelFormat::R8G8B8);
    case Material::OldPlanks:
        return image(1.6, PixelFormat::Dxt1);
    case Material::Beam:
        return image(1.5, PixelFormat::Dxt1);
    case Material::Oak:
        return image(1.5, PixelFormat::R5G6B5);
    case Material::Plaster:
    case Material::InnerPlaster:
        return image(3.0, PixelFormat::R8G8B8);
    case Material::StoneWall:
        return image(1.9, PixelFormat::A8R8G8B8);
    case Material::Flagstones:
        return image(2.2, PixelFormat::Index16);
    case Material::Brick:
        return image(1.0, PixelFormat::P8);
    case Material::Thatch:
        return image(2.5, PixelFormat::R8G8B8);
    case Material::Rug:
        return image(1.0, PixelFormat::P8);
    case Material::Blanket:
        return image(1.0, PixelFormat::R5G6B5);
    case Material::Linen:
    case Material::Books:
    case Material::BarrelStaves:
    case Material::LogEnds:
        return image(1.0, PixelFormat::Dxt1);
    case Material::Iron:
        return solid(0xFF37363A);
    case Material::Wax:
        return solid(0xFFE6DCC0, 0.25f);
    case Material::Embers:
        return {0.6, PixelFormat::R8G8B8, S::kBase1Image | S::kLuminous, 1.0f, 0.0f, 0.0f, 0};
    case Material::Flame:
        return {1.0, PixelFormat::A8R8G8B8, S::kBase1Image | S::kLuminous | S::kAlpha, 1.0f, 0.0f, 0.0f, 0};
    case Material::LampGlass:
        return {1.0,
                PixelFormat::A8R8G8B8,
                S::kBase1Solid | S::kLuminous | S::kTranslucent,
                1.0f,
                0.0f,
                0.45f,
                0xFFFFD98A};
    default:
        return natureRecipe(material);
    }
}

} // namespace limen::worlds
