#pragma once

#include "world/Clothing.h"
#include "world/Records.h"
#include "world/Textures.h"

#include <map>
#include <tuple>
#include <utility>

namespace limen::world {

class LoadCache;

/// A picture, the palette that is said for it (0: its own), and how it is read: DecodeRules::clipMap, additive.
using KeptPicture = std::tuple<dat::RecordId, dat::RecordId, bool, bool>;

/// Makes materials and textures on demand, each once, straight into the world's arrays. A picture that is
/// missing or cannot be decoded becomes a mid grey one and a finding.
class Materials {
public:
    /// `cache`: null, or where pictures may be that others have decoded.
    Materials(Records& records, World& world, LoadCache* cache = nullptr)
        : records_(records), world_(world), cache_(cache) {}

    /// The material of a Surface. `clamp`: its texture coordinates never leave 0..1.
    [[nodiscard]] std::uint32_t material(dat::RecordId surface, bool clamp) {
        return material(surface, clamp, {}, {});
    }
    /// The same with other textures, and its palette overlaid.
    [[nodiscard]] std::uint32_t material(dat::RecordId surface, bool clamp,
                                         std::span<const dat::TextureChange> textures,
                                         std::span<const PaletteOverlay> overlays);
    /// The texture of a SurfaceTexture read plainly, as terrain and its blend maps do.
    [[nodiscard]] std::uint32_t plainTexture(dat::RecordId surfaceTexture) {
        return texture({surfaceTexture, 0, false, false, 0});
    }

private:
    /// What a texture is made of.
    struct PictureKey {
        dat::RecordId picture = 0; ///< SurfaceTexture or RenderSurface
        dat::RecordId palette = 0; ///< 0: the picture's own
        bool clipMap = false, additive = false;
        std::uint32_t overlays = 0; ///< index into overlays_
        friend auto operator<=>(const PictureKey&, const PictureKey&) = default;
    };
    struct MaterialKey {
        dat::RecordId surface = 0, texture = 0;
        bool clamp = false;
        std::uint32_t overlays = 0;
        friend auto operator<=>(const MaterialKey&, const MaterialKey&) = default;
    };
    std::uint32_t texture(const PictureKey& key);
    std::uint32_t decoded(const PictureKey& key);
    [[nodiscard]] std::uint32_t overlayNumber(std::span<const PaletteOverlay> overlays);
    [[nodiscard]] const dat::Palette* palette(dat::RecordId id, std::uint32_t overlays);
    std::uint32_t fallback(dat::RecordId record, std::string what);
    [[nodiscard]] dat::RecordId firstPicture(const dat::SurfaceTexture& texture) const;

    /// The picture as it is, or is made now and kept. Errors: it is missing or damaged.
    [[nodiscard]] Result<std::shared_ptr<const Image>> picture(const KeptPicture& key);
    [[nodiscard]] bool hasPalette(dat::RecordId picture) const;
    /// Its palette overlaid.
    [[nodiscard]] Result<std::shared_ptr<const Image>> overlaid(const PictureKey& key);

    Records& records_;
    World& world_;
    LoadCache* cache_;
    std::map<MaterialKey, std::uint32_t> materials_;
    std::map<PictureKey, std::uint32_t> textures_;         ///< by SurfaceTexture
    std::map<PictureKey, std::uint32_t> pictures_;         ///< by RenderSurface
    std::vector<std::vector<PaletteOverlay>> overlays_{1}; ///< each once; the first is none
    std::map<std::pair<dat::RecordId, std::uint32_t>, dat::Palette> overlaid_;
    std::uint32_t grey_ = kNone;
};

} // namespace limen::world
