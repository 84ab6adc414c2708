#include "world/Materials.h"

#include <algorithm>

namespace limen::world {
namespace {

Vec4f colourOf(std::uint32_t argb, float alpha) {
    const auto channel = [argb](int shift) { return static_cast<float>(argb >> shift & 255u) / 255.0f; };
    return {channel(16), channel(8), channel(0), alpha};
}

float fraction(float value) {
    return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f;
}

std::uint32_t flagsOf(const dat::Surface& surface, bool clamp) {
    std::uint32_t flags = clamp ? Material::kClamp : 0;
    flags |= (surface.type & dat::Surface::kAdditive) != 0 ? Material::kAdditive : 0;
    flags |= (surface.type & dat::Surface::kInvAlpha) != 0 ? Material::kInvAlpha : 0;
    flags |= (surface.type & dat::Surface::kAlpha) != 0 ? Material::kAlpha : 0;
    flags |= isSplit(surface) ? Material::kSplit : 0;
    return flags;
}

} // namespace

std::uint32_t Materials::material(dat::RecordId id, bool clamp) {
    const auto [entry, fresh] =
        materials_.try_emplace({id, clamp}, static_cast<std::uint32_t>(world_.materials.size()));
    if (!fresh)
        return entry->second;
    Material material;
    material.surface = id;
    const dat::Surface* surface = records_.surface(id);
    if (surface == nullptr) {
        material.colour = Vec4f(0.5f, 0.5f, 0.5f, 1.0f);
        world_.materials.push_back(material);
        return entry->second;
    }
    material.surfaceClass = surfaceClassOf(*surface);
    material.flags = flagsOf(*surface, clamp);
    material.luminosity =
        (surface->type & dat::Surface::kLuminous) != 0 ? fraction(surface->luminosity) : 0.0f;
    material.diffuse = (surface->type & dat::Surface::kDiffuse) != 0 ? fraction(surface->diffuse) : 1.0f;
    material.colour = colourOf(surface->hasImage() ? 0xFFFFFFu : surface->colour.argb, alphaOf(*surface));
    if (surface->hasImage()) {
        const DecodeRules rules{(surface->type & dat::Surface::kBase1ClipMap) != 0,
                                (surface->type & dat::Surface::kAdditive) != 0};
        material.texture = texture(surface->texture, surface->palette, rules);
    }
    world_.materials.push_back(material);
    return entry->second;
}

std::uint32_t Materials::texture(dat::RecordId id, dat::RecordId palette, const DecodeRules& rules) {
    const auto [entry, fresh] = textures_.try_emplace({id, palette, rules.clipMap, rules.additive}, kNone);
    if (!fresh)
        return entry->second;
    const dat::SurfaceTexture* record = records_.surfaceTexture(id);
    const dat::RecordId picture = record != nullptr ? firstPicture(*record) : 0;
    if (picture != 0)
        entry->second = decoded(picture, palette, rules);
    else
        entry->second = fallback(record != nullptr ? id : 0, "none of its pictures exists");
    return entry->second;
}

dat::RecordId Materials::firstPicture(const dat::SurfaceTexture& texture) const {
    const auto found = std::find_if(texture.images.begin(), texture.images.end(), [&](dat::RecordId id) {
        return records_.archive().contains<dat::RenderSurface>(id);
    });
    return found == texture.images.end() ? 0 : *found;
}

std::uint32_t Materials::decoded(dat::RecordId id, dat::RecordId palette, const DecodeRules& rules) {
    const auto [entry, fresh] = pictures_.try_emplace({id, palette, rules.clipMap, rules.additive}, kNone);
    if (!fresh)
        return entry->second;
    const Result<dat::RenderSurface> picture = records_.archive().load<dat::RenderSurface>(id);
    if (!picture)
        return entry->second = fallback(id, picture.error().message());
    const dat::RecordId paletteId = palette != 0 ? palette : picture->defaultPalette;
    Result<Image> image =
        decodeImage(*picture, paletteId != 0 ? records_.palette(paletteId) : nullptr, rules);
    if (!image)
        return entry->second = fallback(id, image.error().message());
    if (rules.clipMap && image->hasAlpha)
        bleedColour(*image);
    world_.textures.push_back(std::move(*image));
    return entry->second = static_cast<std::uint32_t>(world_.textures.size() - 1);
}

std::uint32_t Materials::fallback(dat::RecordId record, std::string what) {
    if (record != 0)
        note(world_.findings, record, std::move(what));
    if (grey_ == kNone) {
        Image image;
        image.width = image.height = 4;
        image.rgba.assign(64, 128);
        for (std::size_t i = 3; i < image.rgba.size(); i += 4)
            image.rgba[i] = 255;
        grey_ = static_cast<std::uint32_t>(world_.textures.size());
        world_.textures.push_back(std::move(image));
    }
    return grey_;
}

} // namespace limen::world
