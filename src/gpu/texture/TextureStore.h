#pragma once

#include "gpu/texture/TextureStaging.h"

#include <memory>

namespace limen::gpu {

/// A texture on a device, which stores may share. Given back with its last owner; the device must outlive it.
class ResidentTexture {
public:
    ResidentTexture(Device& device, TextureHandle texture, TextureContent content)
        : device_(device), texture_(texture), content_(std::move(content)) {}
    ResidentTexture(const ResidentTexture&) = delete;
    ResidentTexture& operator=(const ResidentTexture&) = delete;
    ~ResidentTexture();

    [[nodiscard]] TextureHandle texture() const { return texture_; }
    [[nodiscard]] const TextureContent& content() const { return content_; }
    /// Its bindless handle; 0: none was taken.
    [[nodiscard]] std::uint64_t handle() const { return handle_; }
    /// Makes it resident, when it is written. False if the driver refuses.
    [[nodiscard]] bool takeHandle();

private:
    Device& device_;
    TextureHandle texture_;
    TextureContent content_;
    std::uint64_t handle_ = 0;
};

/// All textures of a scene on a device, mipmapped, trilinear. Destroyed with the store, but those that another store shares.
class TextureStore {
public:
    /// Errors: Unsupported, for bindless without the extension, a picture beyond the driver's limits, or more
    /// textures than its units and layers hold.
    [[nodiscard]] static Result<TextureStore> create(Device& device,
                                                     std::span<const frame::TextureUpload> textures,
                                                     const TextureStoreOptions& options);
    /// One to be filled by `advance`. `before`: null, or the store that they were staged beside.
    TextureStore(Device& device, StagedTextures staged, const TextureStore* before);
    TextureStore(TextureStore&& other) noexcept;
    TextureStore& operator=(TextureStore&& other) noexcept;
    ~TextureStore();

    /// Writes the next rows, until `bytes` are used up, of which it takes away what it writes. Yields true when all is there. Errors:
    /// the device's; BadArgument, if the store before has not what it had when they were staged.
    [[nodiscard]] Result<bool> advance(std::size_t& bytes);
    /// No frame samples these textures, those under way included: they may go at once.
    void markUnused() { isUnused_ = true; }
    /// Gives some of them back, after markUnused. False when none is left.
    bool releaseSome();

    /// For the shaders, one per texture in order.
    [[nodiscard]] std::span<const frame::gpu::TextureRef> refs() const { return refs_; }
    /// What to bind to units from kUnitFirstPage on; empty in bindless mode.
    [[nodiscard]] std::span<const TextureHandle> pages() const { return pages_; }
    /// What a program that samples these textures (indices; kNoTexture is skipped) is built with.
    [[nodiscard]] TextureBinding bindingFor(std::span<const std::uint32_t> textures) const {
        return gpu::bindingFor(staged_, textures);
    }
    [[nodiscard]] bool bindless() const { return staged_.bindless; }
    /// Textures stored larger than they are, because the pages did not suffice for every size.
    [[nodiscard]] std::uint32_t resampled() const { return staged_.resampled; }
    /// What there is, texture by texture.
    [[nodiscard]] std::vector<TextureContent> contents() const;

private:
    [[nodiscard]] Result<void> begin(const StagedTexture& staged);
    /// True when the last of it is written.
    [[nodiscard]] bool write(const StagedTexture& staged, std::size_t& bytes);
    void writeRefs();

    Device* device_ = nullptr;
    StagedTextures staged_; ///< without what is written already
    std::vector<std::shared_ptr<ResidentTexture>>
        shared_; ///< of the store before, by what is staged; null: not shared
    std::vector<std::shared_ptr<ResidentTexture>> textures_;
    std::vector<TextureHandle> pages_;
    std::vector<frame::gpu::TextureRef> refs_;
    std::size_t layer_ = 0, level_ = 0; ///< what of the texture that is begun is written next
    std::uint32_t row_ = 0;
    bool isBegun_ = false, isUnused_ = false;
};

} // namespace limen::gpu
