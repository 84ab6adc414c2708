#pragma once

#include "frame/SceneUpload.h"
#include "gpu/device/Device.h"
#include "gpu/texture/MipChain.h"
#include "gpu/texture/PageLayout.h"

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
    std::uint32_t pageLimit = 0; ///< limit of array pages (>= 2); 0: as many as the driver's texture units
};

/// Content of a texture on a device.
struct TextureContent {
    TextureShape shape;
    std::vector<std::uint64_t> keys; ///< frame::TextureUpload::contentKey, by layer
    /// Whether equal content means the same texture: all keys are known.
    [[nodiscard]] bool isKnown() const;
    friend bool operator==(const TextureContent&, const TextureContent&) = default;
};

/// A texture ready to be written.
struct StagedTexture {
    std::string label;
    TextureContent content;
    bool isShared = false;                     ///< the previous scene has it
    std::vector<std::vector<MipLevel>> layers; ///< by layer, all mip levels; empty if shared
};

/// All textures of a scene, mipmapped and laid out in pages by any thread.
struct StagedTextures {
    bool bindless = false, byIndex = false;
    std::vector<StagedTexture> textures;    ///< array pages, or single textures if bindless
    std::vector<TextureLocation> locations; ///< by picture: index into `textures`, and layer
    std::vector<TextureClass> stored;       ///< by picture: stored size and wrapping
    std::uint32_t resampled = 0;            ///< pictures stored enlarged
};

/// Stages pictures for a device that holds `before` (may be empty). Existing content is shared. Pages keep
/// their numbers if all fit, so that the same programs draw both scenes. Errors: Unsupported, for bindless
/// without the extension, or for more pictures than the driver's units and layers hold.
[[nodiscard]] Result<StagedTextures> stageTextures(std::span<const frame::TextureUpload> pictures,
                                                   const TextureStoreOptions& options,
                                                   const Capabilities& capabilities,
                                                   std::span<const TextureContent> before);

/// Texture binding of a program that samples these pictures (indices; kNoTexture is skipped).
[[nodiscard]] TextureBinding bindingFor(const StagedTextures& staged,
                                        std::span<const std::uint32_t> pictures);

} // namespace limen::gpu
