#pragma once

#include "gpu/texture/TextureStaging.h"

#include <memory>

namespace limen::gpu {

/// A texture on a device, shared by stores and destroyed with the last. The device must outlive it.
class ResidentTexture {
public:
    ResidentTexture(Device& device, TextureHandle texture, TextureContent content)
        : device_(device), texture_(texture), content_(std::move(content)) {}
    ResidentTexture(const ResidentTexture&) = delete;
    ResidentTexture& operator=(const ResidentTexture&) = delete;
    ~ResidentTexture();

    [[nodiscard]] TextureHandle texture() const { return texture_; }
    [[nodiscard]] const TextureContent& content() const { return content_; }
    /// Bindless handle; 0: none.
    [[nodiscard]] std::uint64_t handle() const { return handle_; }
    /// Makes the handle resident, after the texture is written. False if the driver refuses.
    [[nodiscard]] bool takeHandle();

private:
    Device& device_;
    TextureHandle texture_;
    TextureContent content_;
    std::uint64_t handle_ = 0;
};

/// All textures of a scene on a device, mipmapped, trilinear. The destructor destroys those that no other
/// store shares.
class TextureStore {
public:
    /// Errors: Unsupported, for bindless without the extension, a picture beyond the driver's limits, or more
    /// textures than units and layers hold.
    [[nodiscard]] static Result<TextureStore> create(Device& device,
                                                     std::span<const frame::TextureUpload> textures,
                                                     const TextureStoreOptions& options);
    /// An empty store, filled by `advance`. `before`: null, or the store that `staged` was staged beside.
    TextureStore(Device& device, StagedTextures staged, const TextureStore* before);
    TextureStore(TextureStore&& other) noexcept;
    TextureStore& operator=(TextureStore&& other) noexcept;
    ~TextureStore();

    /// Writes rows until `bytes` are used up, and subtracts them. True when all textures are complete.
    /// Errors: the device's; BadArgument, if the previous store no longer has a shared texture.
    [[nodiscard]] Result<bool> advance(std::size_t& bytes);
    /// No frame samples these textures, in flight or later: they may be destroyed at once.
    void markUnused() { isUnused_ = true; }
    /// Destroys some textures, after markUnused. False when none is left.
    bool releaseSome();

    /// For the shaders, one per picture in order.
    [[nodiscard]] std::span<const frame::gpu::TextureRef> refs() const { return refs_; }
    /// Places in pages, for packTerrain; of pictures that are in the atlas alone 0.
    [[nodiscard]] std::span<const frame::gpu::TextureRef> pageRefs() const {
        return pageRefs_.empty() ? refs() : pageRefs_;
    }
    /// Textures for the units from kUnitFirstPage on; empty if bindless.
    [[nodiscard]] std::span<const TextureHandle> pages() const { return pages_; }
    /// Texture binding of a program that samples these pictures (indices; kNoTexture is skipped).
    [[nodiscard]] TextureBinding bindingFor(std::span<const std::uint32_t> textures) const {
        return gpu::bindingFor(staged_, textures);
    }
    [[nodiscard]] bool bindless() const { return staged_.bindless; }
    /// Pictures stored enlarged, because there are fewer pages than sizes.
    [[nodiscard]] std::uint32_t resampled() const { return staged_.resampled; }
    /// Content of each texture.
    [[nodiscard]] std::vector<TextureContent> contents() const;

private:
    [[nodiscard]] Result<void> begin(const StagedTexture& staged);
    /// True when the texture is complete.
    [[nodiscard]] bool write(const StagedTexture& staged, std::size_t& bytes);
    void writeRefs();

    Device* device_ = nullptr;
    StagedTextures staged_; ///< without the parts already written
    std::vector<std::shared_ptr<ResidentTexture>>
        shared_; ///< the previous store's textures, by staged texture; null: not shared
    std::vector<std::shared_ptr<ResidentTexture>> textures_;
    std::vector<TextureHandle> pages_;
    std::vector<frame::gpu::TextureRef> refs_, pageRefs_; ///< the second if there is an atlas
    std::size_t layer_ = 0, level_ = 0;                   ///< next part to write of the current texture
    std::uint32_t row_ = 0;
    bool isBegun_ = false, isUnused_ = false;
};

} // namespace limen::gpu
