#include "world/texture/Materials.h"

#include "core/Assert.h"

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

constexpr std::uint64_t kGreyKey = 1; ///< the key of no picture

/// Unique in an archive: ids of pictures, and of palettes, differ in their lower three bytes only.
std::uint64_t contentKeyOf(const PictureKey& key) {
    const auto [picture, palette, clipMap, additive] = key;
    const std::uint64_t rules = (clipMap ? 2u : 0u) | (additive ? 1u : 0u);
    return 1ull << 63 | rules << 48 | std::uint64_t{palette & 0xFFFFFFu} << 24 | (picture & 0xFFFFFFu);
}

Result<Image> decode(const PictureKey& key, Records& records) {
    const auto [id, palette, clipMap, additive] = key;
    const Result<dat::RenderSurface> picture = records.archive().load<dat::RenderSurface>(id);
    if (!picture)
        return Failure(picture.error());
    const dat::RecordId paletteId = palette != 0 ? palette : picture->defaultPalette;
    Result<Image> image =
        decodeImage(*picture, paletteId != 0 ? records.palette(paletteId) : nullptr, {clipMap, additive});
    if (!image)
        return image;
    if (clipMap && image->hasAlpha)
        bleedColour(*image);
    image->contentKey = contentKeyOf(key);
    return image;
}

} // namespace

std::uint32_t Materials::material(dat::RecordId id, bool clamp, std::span<const dat::TextureChange> textures,
                                  std::span<const PaletteOverlay> overlays) {
    const dat::Surface* surface = records_.surface(id);
    MaterialKey key{id, 0, clamp, 0};
    if (surface != nullptr && surface->hasImage()) {
        key.texture = surface->texture;
        for (const dat::TextureChange& change : textures) // the last change of a texture counts
            key.texture = change.from == surface->texture ? change.to : key.texture;
        key.overlays = overlayNumber(overlays);
    }
    const auto [entry, fresh] =
        materials_.try_emplace(key, static_cast<std::uint32_t>(world_.materials.size()));
    if (!fresh)
        return entry->second;
    Material material;
    material.surface = id;
    if (surface == nullptr) {
        material.colour = Vec4f(0.5f, 0.5f, 0.5f, 1.0f);
        world_.materials.push_back(material);
        return entry->second;
    }
    material.surfaceClass = surfaceClassOf(*surface);
    material.flags = flagsOf(*surface, clamp);
    material.luminosity = fraction(surface->luminosity); // kLuminous has no effect
    material.diffuse = fraction(surface->diffuse);
    material.colour = colourOf(surface->hasImage() ? 0xFFFFFFu : surface->colour.argb, alphaOf(*surface));
    if (surface->hasImage())
        material.texture =
            texture({key.texture, surface->palette, (surface->type & dat::Surface::kBase1ClipMap) != 0,
                     (surface->type & dat::Surface::kAdditive) != 0, key.overlays, clamp});
    if (material.texture != kNone && world_.textures[material.texture]->isIndexed)
        material.flags |= Material::kIndexed;
    world_.materials.push_back(material);
    return entry->second;
}

std::uint32_t Materials::overlayNumber(std::span<const PaletteOverlay> overlays) {
    const auto found = std::find_if(overlays_.begin(), overlays_.end(), [&](const auto& known) {
        return std::equal(known.begin(), known.end(), overlays.begin(), overlays.end());
    });
    const auto number = static_cast<std::uint32_t>(found - overlays_.begin());
    if (found == overlays_.end())
        overlays_.emplace_back(overlays.begin(), overlays.end());
    return number;
}

const dat::Palette* Materials::palette(dat::RecordId id, std::uint32_t overlays) {
    LIMEN_ASSERT(overlays < overlays_.size(), "overlayNumber() gave this number");
    const dat::Palette* base = id != 0 ? records_.palette(id) : nullptr;
    if (base == nullptr || overlays == 0)
        return base;
    const auto [entry, fresh] = overlaid_.try_emplace({id, overlays});
    if (fresh)
        entry->second = withOverlays(*base, overlays_[overlays], records_);
    return &entry->second;
}

std::uint32_t Materials::texture(const TextureKey& key) {
    const auto [entry, fresh] = textures_.try_emplace(key, kNone);
    if (!fresh)
        return entry->second;
    const dat::SurfaceTexture* record = records_.surfaceTexture(key.picture);
    TextureKey picture = key;
    picture.picture = record != nullptr ? firstPicture(*record) : 0;
    if (picture.picture != 0)
        entry->second = decoded(picture);
    else
        entry->second = fallback(record != nullptr ? key.picture : 0, "none of its pictures exists");
    return entry->second;
}

dat::RecordId Materials::firstPicture(const dat::SurfaceTexture& texture) const {
    const auto found = std::find_if(texture.images.begin(), texture.images.end(), [&](dat::RecordId id) {
        return records_.archive().contains<dat::RenderSurface>(id);
    });
    return found == texture.images.end() ? 0 : *found;
}

std::uint32_t Materials::decoded(const TextureKey& key) {
    const auto [entry, fresh] = pictures_.try_emplace(key, kNone);
    if (!fresh)
        return entry->second;
    if (key.overlays != 0 && !hasPalette(key.picture)) {
        TextureKey plain = key; // the picture has no palette for the overlays to change
        plain.overlays = 0;
        return entry->second = decoded(plain);
    }
    Result<std::shared_ptr<const Image>> image =
        key.overlays == 0 ? picture({key.picture, key.palette, key.clipMap, key.additive}) : overlaid(key);
    if (!image)
        return entry->second = fallback(key.picture, image.error().message());
    LIMEN_ASSERT(*image != nullptr, "World::textures are never null");
    world_.textures.push_back(std::move(*image));
    return entry->second = static_cast<std::uint32_t>(world_.textures.size() - 1);
}

bool Materials::hasPalette(dat::RecordId picture) const {
    const Result<dat::RenderSurface> record = records_.archive().load<dat::RenderSurface>(picture);
    return record && isIndexed(record->format);
}

Result<std::shared_ptr<const Image>> Materials::overlaid(const TextureKey& key) {
    LIMEN_ASSERT(key.overlays != 0, "a picture without overlays comes from the cache");
    const Result<dat::RenderSurface> picture = records_.archive().load<dat::RenderSurface>(key.picture);
    if (!picture)
        return Failure(picture.error());
    const dat::RecordId paletteId = key.palette != 0 ? key.palette : picture->defaultPalette;
    Result<Image> image =
        decodeImage(*picture, palette(paletteId, key.overlays), {key.clipMap, key.additive});
    if (!image)
        return Failure(image.error());
    if (key.clipMap && image->hasAlpha)
        bleedColour(*image);
    // The image has no content key: overlays have other numbers in each world.
    return std::make_shared<const Image>(std::move(*image));
}

Result<std::shared_ptr<const Image>> Materials::picture(const PictureKey& key) {
    if (const auto kept = cache_ != nullptr ? cache_->find(key) : nullptr) {
        records_.report(kept->findings);
        return kept->value;
    }
    auto made = records_.collect([&] { return decode(key, records_); });
    if (!made.value)
        return Failure(made.value.error());
    const auto image = std::make_shared<const Image>(std::move(*made.value));
    if (cache_ == nullptr)
        return image;
    using Kept = Found<std::shared_ptr<const Image>>;
    return cache_
        ->keep(key, std::make_shared<const Kept>(Kept{image, std::move(made.findings)}), image->rgba.size())
        ->value;
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
        image.contentKey = kGreyKey;
        grey_ = static_cast<std::uint32_t>(world_.textures.size());
        world_.textures.push_back(std::make_shared<const Image>(std::move(image)));
    }
    return grey_;
}

} // namespace limen::world
