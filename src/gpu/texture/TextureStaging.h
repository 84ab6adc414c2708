#pragma once

#include "frame/SceneUpload.h"
#include "gpu/device/Device.h"
#include "gpu/texture/Atlas.h"
#include "gpu/texture/MipChain.h"
#include "gpu/texture/PageLayout.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace limen::gpu {

/// Binding of textures to shaders.
enum class TextureMode : std::uint8_t {
    Auto,       ///< bindless if the driver supports it
    ArrayPages, ///< one array texture per size and wrapping
    Bindless    ///< ARB_bindless_texture handles
};

struct TextureStoreOptions {
    TextureMode mode = TextureMode::Auto;
    float anisotropy = 4.0f; ///< limit of anisotropic filtering; 1 on software drivers, where it is too slow
    /// On software drivers, a sample is of the nearest mip level: half the time of a mean of two.
    bool nearestLevel = false;
    /// On software drivers, shaders select the page by an index that varies between triangles. GLSL leaves
    /// that undefined unless all invocations shaded together agree. These drivers shade one triangle at a
    /// time, and with constant indices they would sample every page for every fragment.
    bool pagesByIndex = true;
    /// On software drivers that draw fast, all textures but the ground's are in an atlas: a page by a constant
    /// index, without the driver's mip levels. If they do not fit, they are in pages by index.
    bool atlas = true;
    std::uint32_t pageLimit = 0; ///< limit of array pages (>= 2); 0: as many as the driver's texture units
};

/// Content of a texture on a device.
struct TextureContent {
    TextureShape shape;
    std::vector<std::uint64_t>
        keys{}; ///< frame::TextureUpload::contentKey, by layer; of an atlas by picture, each with its use
    bool isAtlas = false;
    /// Whether equal content means the same texture: all keys are known.
    [[nodiscard]] bool isKnown() const;
    friend bool operator==(const TextureContent&, const TextureContent&) = default;
};

/// Pictures by the way in which shaders sample them; indices, kNoTexture is skipped. One may be in several.
struct TextureUses {
    std::vector<std::uint32_t> ground; ///< by PackedCell
    std::vector<std::uint32_t> meshes; ///< filtered, by TextureRef
    /// Grains of exteriors and of shells, or kNoTexture: an atlas has enlarged ones, which are sampled unfiltered.
    std::array<std::uint32_t, 2> grains{frame::gpu::kNoTexture, frame::gpu::kNoTexture};
};

/// A texture ready to be written.
struct StagedTexture {
    std::string label;
    TextureContent content;
    bool isShared = false;                     ///< the previous scene has it
    std::vector<std::vector<MipLevel>> layers; ///< by layer, all mip levels; empty if shared
};

/// A picture in an atlas.
struct AtlasEntry {
    TextureClass stored; ///< grains are larger than their pictures
    AtlasSpot spot;
};

/// All textures of a scene, mipmapped and laid out in pages by any thread.
struct StagedTextures {
    bool bindless = false, byIndex = false;
    std::vector<StagedTexture> textures; ///< array pages, or single textures if bindless
    std::vector<TextureLocation>
        locations; ///< by picture: index into `textures`, and layer; of an atlas the first
    std::vector<std::optional<AtlasEntry>>
        inAtlas;                      ///< by picture, if it is in the atlas, which is then textures[0]
    std::vector<bool> paged;          ///< by picture: it is at its location; not if it is in the atlas alone
    std::vector<TextureClass> stored; ///< by picture: stored size and wrapping
    std::array<std::uint32_t, 2> grains{frame::gpu::kNoTexture,
                                        frame::gpu::kNoTexture}; ///< of TextureUses, in the atlas
    std::uint32_t resampled = 0;                                 ///< pictures stored enlarged
    [[nodiscard]] bool hasAtlas() const { return !textures.empty() && textures[0].content.isAtlas; }
};

/// Pictures in the order of their content, so that a layout does not depend on the order in which a world uses them.
[[nodiscard]] std::vector<std::uint32_t> orderByContent(std::span<const frame::TextureUpload> pictures);

/// Stages pictures for a device that holds `before` (may be empty). Existing content is shared. Pages keep
/// their numbers if all fit, so that the same programs draw both scenes. Errors: Unsupported, for bindless
/// without the extension, or for more pictures than the driver's units and layers hold. `uses`: null: no atlas.
[[nodiscard]] Result<StagedTextures> stageTextures(std::span<const frame::TextureUpload> pictures,
                                                   const TextureStoreOptions& options,
                                                   const Capabilities& capabilities,
                                                   std::span<const TextureContent> before,
                                                   const TextureUses* uses = nullptr);

/// Texture binding of a program that samples these pictures (indices; kNoTexture is skipped).
[[nodiscard]] TextureBinding bindingFor(const StagedTextures& staged,
                                        std::span<const std::uint32_t> pictures);

} // namespace limen::gpu
