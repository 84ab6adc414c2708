#pragma once

#include "frame/SceneUpload.h"
#include "gpu/DrawCulling.h"
#include "gpu/FrameRing.h"
#include "gpu/Programs.h"
#include "gpu/RendererOptions.h"

#include <memory>

namespace limen::gpu {

/// What stands still, on the device, with the programs that draw it. Gives everything back when it goes; the device must
/// outlive it.
class ResidentScene {
public:
    /// Errors: BadArgument for indices that lead nowhere; what textures, buffers and programs report.
    [[nodiscard]] static Result<std::unique_ptr<ResidentScene>>
    create(Device& device, const frame::SceneUpload& upload, const RendererOptions& options);
    ResidentScene(const ResidentScene&) = delete;
    ResidentScene& operator=(const ResidentScene&) = delete;
    ~ResidentScene();

    [[nodiscard]] Programs& programs() { return programs_; }
    [[nodiscard]] const TextureStore& textures() const { return textures_; }
    [[nodiscard]] DrawCulling& culling() { return culling_; }
    [[nodiscard]] BufferHandle vertices() const { return vertices_; }
    [[nodiscard]] BufferHandle indices() const { return storage_[frame::gpu::kBindIndices].buffer; }
    [[nodiscard]] std::uint32_t pieces() const { return pieces_; } ///< how many
    /// The static arrays by binding; the others are empty.
    [[nodiscard]] const StorageBindings& storage() const { return storage_; }
    /// What Device::bindTextures takes.
    [[nodiscard]] std::span<const TextureHandle> boundTextures() const { return bound_; }

private:
    ResidentScene(Device& device, TextureStore&& textures, Programs&& programs, DrawCulling&& culling)
        : device_(device), textures_(std::move(textures)), programs_(std::move(programs)),
          culling_(std::move(culling)) {}
    [[nodiscard]] Result<void> upload(const frame::SceneUpload& scene);
    [[nodiscard]] Result<BufferHandle> add(std::string_view label, std::span<const std::byte> bytes);
    [[nodiscard]] Result<void> addStorage(std::uint32_t binding, std::string_view label,
                                          std::span<const std::byte> bytes);
    [[nodiscard]] Result<void> addTexels(std::string_view label, std::span<const std::byte> bytes);

    Device& device_;
    TextureStore textures_;
    Programs programs_;
    DrawCulling culling_;
    std::vector<BufferHandle> owned_;
    std::vector<TextureHandle> texels_; ///< buffers read as textures, in the order of their units
    std::vector<TextureHandle> bound_;  ///< these, and the textures' pages
    StorageBindings storage_{};
    BufferHandle vertices_ = BufferHandle::Invalid;
    std::uint32_t pieces_ = 0;
};

} // namespace limen::gpu
