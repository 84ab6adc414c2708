#pragma once

#include "gpu/scene/Programs.h"
#include "gpu/scene/SceneStaging.h"
#include "gpu/scene/SpareBuffers.h"
#include "gpu/texture/TextureStore.h"

#include <memory>

namespace limen::gpu {

/// The static scene on the device, with the programs that draw it. The device and the spare buffers must
/// outlive it.
class ResidentScene {
public:
    /// An empty scene, filled by `advance`. `programs`: for the staged bindings, may be shared. `before`:
    /// null, or the scene that `staged` was staged beside. `spare`: source of its buffers.
    ResidentScene(Device& device, StagedScene staged, std::shared_ptr<Programs> programs,
                  const ResidentScene* before, SpareBuffers& spare);
    ResidentScene(const ResidentScene&) = delete;
    ResidentScene& operator=(const ResidentScene&) = delete;
    ~ResidentScene();

    /// Uploads until `bytes` are used up, and subtracts them; building a program uses up all. True when the
    /// scene is complete. Errors: the device's; BadArgument, if it was staged beside another scene.
    [[nodiscard]] Result<bool> advance(std::size_t& bytes);
    /// No frame reads the scene, in flight or later.
    void markUnused() { textures_.markUnused(); }
    /// Releases a part of it, after markUnused; buffers become spare. False when nothing is left.
    bool releaseSome();

    [[nodiscard]] std::span<const SizedBuffer> buffers() const { return owned_; }
    [[nodiscard]] const std::shared_ptr<Programs>& sharePrograms() const { return programs_; }
    [[nodiscard]] Programs& programs() { return *programs_; }
    [[nodiscard]] const TextureStore& textures() const { return textures_; }
    [[nodiscard]] BufferHandle vertices() const { return vertices_; }
    [[nodiscard]] BufferHandle indices() const { return storage_[frame::gpu::kBindIndices].buffer; }
    /// Indices that share vertices between triangles; of Drawing::Fast.
    [[nodiscard]] BufferHandle sharedIndices() const { return sharedIndices_; }
    [[nodiscard]] const frame::RecordTables& tables() const { return tables_; } ///< of Drawing::Fast
    [[nodiscard]] std::uint32_t pieces() const { return pieces_; }              ///< their number
    /// Static arrays by binding; the other ranges are empty.
    [[nodiscard]] const StorageBindings& storage() const { return storage_; }
    /// Textures for Device::bindTextures.
    [[nodiscard]] std::span<const TextureHandle> boundTextures() const { return bound_; }

private:
    /// An array of the scene, partly uploaded.
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
    /// True when the array is complete.
    [[nodiscard]] Result<bool> upload(Array& array, std::size_t& bytes);
    [[nodiscard]] Result<void> finish(const Array& array);

    Device& device_;
    SpareBuffers& spare_;
    TextureStore textures_;
    std::shared_ptr<Programs> programs_;
    std::shared_ptr<const frame::SceneUpload> scene_;          ///< until it is uploaded
    std::shared_ptr<const std::vector<std::uint32_t>> shared_; ///< indices, likewise
    std::vector<Array> arrays_;
    std::size_t done_ = 0; ///< number of complete arrays
    std::vector<SizedBuffer> owned_;
    std::vector<TextureHandle> texels_; ///< buffers read as textures
    std::vector<TextureHandle> bound_;  ///< these and the textures' pages, by unit from kUnitVertices on
    StorageBindings storage_{};
    BufferHandle vertices_ = BufferHandle::Invalid, sharedIndices_ = BufferHandle::Invalid;
    std::uint32_t pieces_ = 0;
    frame::RecordTables tables_;
    bool packsTerrain_ = false;
    std::vector<ShownParts> blendMaps_;          ///< for packed_
    std::vector<frame::gpu::PackedCell> packed_; ///< until it is uploaded
};

} // namespace limen::gpu
