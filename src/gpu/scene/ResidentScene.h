#pragma once

#include "gpu/scene/Programs.h"
#include "gpu/scene/SceneStaging.h"
#include "gpu/scene/SpareBuffers.h"
#include "gpu/texture/TextureStore.h"

#include <memory>

namespace limen::gpu {

/// What stands still, on the device, with the programs that draw it. Gives everything back when it goes; the device and what is spare
/// must outlive it.
class ResidentScene {
public:
    /// One to be filled by `advance`. `programs`: for the staged bindings; others may share them. `before`: null, or the scene that it
    /// was staged beside. `spare`: where its buffers are taken from.
    ResidentScene(Device& device, StagedScene staged, std::shared_ptr<Programs> programs,
                  const ResidentScene* before, SpareBuffers& spare);
    ResidentScene(const ResidentScene&) = delete;
    ResidentScene& operator=(const ResidentScene&) = delete;
    ~ResidentScene();

    /// Uploads the next part, until `bytes` are used up, of which it takes away what it moves; a program that has to be built counts
    /// for all that is left. Yields true when everything is there. Errors: the device's; BadArgument, if it was staged beside another scene.
    [[nodiscard]] Result<bool> advance(std::size_t& bytes);
    /// No frame reads the scene any more, those under way included.
    void markUnused() { textures_.markUnused(); }
    /// Gives a little of it back, after markUnused; its buffers to what is spare. False when nothing is left.
    bool releaseSome();

    /// Its buffers.
    [[nodiscard]] std::span<const SizedBuffer> buffers() const { return owned_; }
    [[nodiscard]] const std::shared_ptr<Programs>& sharePrograms() const { return programs_; }
    [[nodiscard]] Programs& programs() { return *programs_; }
    [[nodiscard]] const TextureStore& textures() const { return textures_; }
    [[nodiscard]] BufferHandle vertices() const { return vertices_; }
    [[nodiscard]] BufferHandle indices() const { return storage_[frame::gpu::kBindIndices].buffer; }
    [[nodiscard]] std::uint32_t pieces() const { return pieces_; } ///< how many
    /// The static arrays by binding; the others are empty.
    [[nodiscard]] const StorageBindings& storage() const { return storage_; }
    /// What Device::bindTextures takes.
    [[nodiscard]] std::span<const TextureHandle> boundTextures() const { return bound_; }

private:
    /// An array of the scene on its way to the device.
    struct Array {
        const char* label = "";
        std::span<const std::byte> bytes;
        std::uint32_t binding = kNowhere; ///< storage binding
        std::uint32_t unit = kNowhere;    ///< texture unit of the buffer's texels
        std::size_t written = 0;
        BufferHandle buffer = BufferHandle::Invalid;
    };
    static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
    void listArrays();
    /// True when it is there.
    [[nodiscard]] Result<bool> upload(Array& array, std::size_t& bytes);
    [[nodiscard]] Result<void> finish(const Array& array);

    Device& device_;
    SpareBuffers& spare_;
    TextureStore textures_;
    std::shared_ptr<Programs> programs_;
    std::shared_ptr<const frame::SceneUpload> scene_; ///< until it is uploaded
    std::vector<Array> arrays_;
    std::size_t done_ = 0; ///< of these
    std::vector<SizedBuffer> owned_;
    std::vector<TextureHandle> texels_; ///< buffers read as textures
    std::vector<TextureHandle> bound_;  ///< these and the textures' pages, by unit from kUnitVertices on
    StorageBindings storage_{};
    BufferHandle vertices_ = BufferHandle::Invalid;
    std::uint32_t pieces_ = 0;
};

} // namespace limen::gpu
