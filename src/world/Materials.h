#pragma once

#include "world/Records.h"
#include "world/Textures.h"

#include <map>
#include <tuple>

namespace limen::world {

/// Makes materials and textures on demand, each once, straight into the world's arrays. A picture that is
/// missing or cannot be decoded becomes a mid grey one and a finding.
class Materials {
public:
    Materials(Records& records, World& world) : records_(records), world_(world) {}

    /// The material of a Surface. `clamp`: its texture coordinates never leave 0..1.
    [[nodiscard]] std::uint32_t material(dat::RecordId surface, bool clamp);
    /// The texture of a SurfaceTexture read plainly, as terrain and its blend maps do.
    [[nodiscard]] std::uint32_t plainTexture(dat::RecordId surfaceTexture) {
        return texture(surfaceTexture, 0, {});
    }

private:
    std::uint32_t texture(dat::RecordId surfaceTexture, dat::RecordId palette, const DecodeRules& rules);
    std::uint32_t decoded(dat::RecordId picture, dat::RecordId palette, const DecodeRules& rules);
    std::uint32_t fallback(dat::RecordId record, std::string what);
    [[nodiscard]] dat::RecordId firstPicture(const dat::SurfaceTexture& texture) const;

    Records& records_;
    World& world_;
    std::map<std::pair<dat::RecordId, bool>, std::uint32_t> materials_;
    using PictureKey = std::tuple<dat::RecordId, dat::RecordId, bool, bool>;
    std::map<PictureKey, std::uint32_t> textures_; ///< by SurfaceTexture
    std::map<PictureKey, std::uint32_t> pictures_; ///< by RenderSurface
    std::uint32_t grey_ = kNone;
};

} // namespace limen::world
