#pragma once

#include "world/records/Clothing.h"
#include "world/records/Records.h"
#include "world/texture/PictureCache.h"
#include "world/texture/Textures.h"

#include <map>
#include <utility>

namespace limen::world {

/// Adds materials and textures to a World on demand, each once. A picture that is missing or cannot be
/// decoded is replaced by a mid-grey one, with a finding.
class Materials {
public:
    /// `cache`: pictures of the same archive, decoded by earlier loads; null for none.
    Materials(Records& records, World& world, PictureCache* cache = nullptr)
        : records_(records), world_(world), cache_(cache) {}

    /// The material of a Surface. `clamp`: its picture does not repeat.
    [[nodiscard]] std::uint32_t material(dat::RecordId surface, bool clamp) {
        return material(surface, clamp, {}, {});
    }
    /// The material of a Surface with textures replaced and palettes overlaid.
    [[nodiscard]] std::uint32_t material(dat::RecordId surface, bool clamp,
                                         std::span<const dat::TextureChange> textures,
                                         std::span<const PaletteOverlay> overlays);
    /// The texture of a SurfaceTexture by default rules, for terrain and its blend maps.
    [[nodiscard]] std::uint32_t plainTexture(dat::RecordId surfaceTexture) {
        return texture({surfaceTexture, 0, false, false, 0, false});
    }

private:
    /// The inputs that determine a texture.
    struct TextureKey {
        dat::RecordId picture = 0; ///< SurfaceTexture or RenderSurface
        dat::RecordId palette = 0; ///< 0: the picture's own
        bool clipMap = false, additive = false;
        std::uint32_t overlays = 0; ///< index into overlays_
        bool clamp = false;         ///< clamped and repeated uses are two textures with one image
        friend auto operator<=>(const TextureKey&, const TextureKey&) = default;
    };
    struct MaterialKey {
        dat::RecordId surface = 0, texture = 0;
        bool clamp = false;
        std::uint32_t overlays = 0;
        friend auto operator<=>(const MaterialKey&, const MaterialKey&) = default;
    };
    std::uint32_t texture(const TextureKey& key);
    std::uint32_t decoded(const TextureKey& key);
    [[nodiscard]] std::uint32_t overlayNumber(std::span<const PaletteOverlay> overlays);
    [[nodiscard]] const dat::Palette* palette(dat::RecordId id, std::uint32_t overlays);
    std::uint32_t fallback(dat::RecordId record, std::string what);
    [[nodiscard]] dat::RecordId firstPicture(const dat::SurfaceTexture& texture) const;

    /// The picture from the cache, else decoded now. Errors: it is missing or damaged.
    [[nodiscard]] Result<std::shared_ptr<const Image>> picture(const PictureKey& key);
    /// False for a picture that cannot be read: the decoder reports the reason.
    [[nodiscard]] bool hasPalette(dat::RecordId picture) const;
    /// The picture with overlays on its palette. Not cached. Errors: it is missing or damaged.
    [[nodiscard]] Result<std::shared_ptr<const Image>> overlaid(const TextureKey& key);

    Records& records_;
    World& world_;
    PictureCache* cache_;
    std::map<MaterialKey, std::uint32_t> materials_;
    std::map<TextureKey, std::uint32_t> textures_;         ///< by SurfaceTexture
    std::map<TextureKey, std::uint32_t> pictures_;         ///< by RenderSurface
    std::vector<std::vector<PaletteOverlay>> overlays_{1}; ///< each list once; the first is empty
    std::map<std::pair<dat::RecordId, std::uint32_t>, dat::Palette> overlaid_;
    std::uint32_t grey_ = kNone;
};

} // namespace limen::world
