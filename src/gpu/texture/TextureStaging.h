#pragma once

#include "frame/SceneUpload.h"
#include "gpu/device/Device.h"
#include "gpu/texture/MipChain.h"
#include "gpu/texture/PageLayout.h"

#include <string>
#include <vector>

namespace limen::gpu {

/// How textures reach the shaders.
enum class TextureMode : std::uint8_t {
    Auto,       ///< bindless where the driver has it
    ArrayPages, ///< one array texture per size and wrapping
    Bindless    ///< ARB_bindless_texture handles
};

struct TextureStoreOptions {
    TextureMode mode = TextureMode::Auto;
    float anisotropy = 4.0f; ///< at most; 1 on software drivers, where it costs too much
    /// On software drivers shaders choose the page by an index that differs from triangle to triangle. GLSL has that undefined unless all that
    /// is shaded together agrees, and they shade one triangle at a time. With constant indices they would sample every page for every fragment.
    bool pagesByIndex = true;
    std::uint32_t pageLimit = 0; ///< array pages at most (>= 2); 0: what the driver's texture units allow
};

/// What a texture of a device holds.
struct TextureContent {
    TextureShape shape;
    std::vector<std::uint64_t> keys; ///< frame::TextureUpload::contentKey, by layer
    /// Whether a texture of the same content is the same texture.
    [[nodiscard]] bool isKnown() const;
    friend bool operator==(const TextureContent&, const TextureContent&) = default;
};

/// A texture that is ready to be written.
struct StagedTexture {
    std::string label;
    TextureContent content;
    bool isShared = false;                     ///< the scene before has it: it is shared
    std::vector<std::vector<MipLevel>> layers; ///< with all levels; none if it is there
};

/// All textures of a scene, made ready for a device by any thread: mipmapped, and laid out in pages.
struct StagedTextures {
    bool bindless = false, byIndex = false;
    std::vector<StagedTexture> textures;    ///< pages, or of bindless ones each by itself
    std::vector<TextureLocation> locations; ///< by picture: index into `textures`, and layer
    std::vector<TextureClass> stored;       ///< by picture: how it is stored
    std::uint32_t resampled = 0;            ///< pictures stored larger than they are
};

/// Stages pictures beside a scene that has `before` (empty: none): what it has already is shared, and pages keep their numbers as
/// long as all fit, so that the same programs draw both. Errors: Unsupported, for bindless without the extension, or more pictures
/// than the driver's units and layers hold.
[[nodiscard]] Result<StagedTextures> stageTextures(std::span<const frame::TextureUpload> pictures,
                                                   const TextureStoreOptions& options,
                                                   const Capabilities& capabilities,
                                                   std::span<const TextureContent> before);

/// What a program that samples these pictures (indices; kNoTexture is skipped) is built with.
[[nodiscard]] TextureBinding bindingFor(const StagedTextures& staged,
                                        std::span<const std::uint32_t> pictures);

} // namespace limen::gpu
