#pragma once

#include "frame/SceneUpload.h"
#include "gpu/Device.h"

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
    float anisotropy = 4.0f;     ///< at most; 1 on software drivers, where it costs too much
    std::uint32_t pageLimit = 0; ///< array pages at most (>= 2); 0: what the driver's texture units allow
};

/// All textures of a scene on a device, mipmapped, trilinear. Destroyed with the store.
class TextureStore {
public:
    /// Errors: Unsupported, for bindless without the extension, a picture beyond the driver's limits, or more
    /// textures than its units and layers hold.
    [[nodiscard]] static Result<TextureStore> create(Device& device,
                                                     std::span<const frame::TextureUpload> textures,
                                                     const TextureStoreOptions& options);
    TextureStore(TextureStore&& other) noexcept;
    TextureStore& operator=(TextureStore&& other) noexcept;
    ~TextureStore();

    /// For the shaders, one per texture in order.
    [[nodiscard]] std::span<const frame::gpu::TextureRef> refs() const { return refs_; }
    /// What to bind to units from kUnitFirstPage on; empty in bindless mode.
    [[nodiscard]] std::span<const TextureHandle> pages() const;
    /// What a program that samples these textures (indices; kNoTexture is skipped) is built with.
    [[nodiscard]] TextureBinding bindingFor(std::span<const std::uint32_t> textures) const;
    [[nodiscard]] bool bindless() const { return bindless_; }
    /// Textures stored larger than they are, because the pages did not suffice for every size.
    [[nodiscard]] std::uint32_t resampled() const { return resampled_; }

private:
    TextureStore(Device& device, bool bindless) : device_(&device), bindless_(bindless) {}
    [[nodiscard]] Result<void> fillPages(std::span<const frame::TextureUpload> textures,
                                         const TextureStoreOptions& options, float anisotropy);
    [[nodiscard]] Result<void> fillHandles(std::span<const frame::TextureUpload> textures, float anisotropy);

    Device* device_ = nullptr;
    bool bindless_ = false;
    std::vector<TextureHandle> textures_;
    std::vector<frame::gpu::TextureRef> refs_;
    std::uint32_t resampled_ = 0;
};

} // namespace limen::gpu
