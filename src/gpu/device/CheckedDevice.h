#pragma once

#include "gpu/device/ForwardingDevice.h"

#include <deque>
#include <memory>
#include <string>
#include <unordered_map>

namespace limen::gpu {

/// Another device whose use is watched: drivers report no handle that is sampled without being resident, and none that is
/// released too early; they draw nonsense, or lose the context. For development builds and tests. It copies every buffer of a
/// device with bindless textures, and forwards all commands, wrong ones too.
///
/// Rules: resources are made and destroyed between frames; what is bound, drawn with and run exists; of a program with bindless
/// textures all handles in the texture references are resident; none is released while a frame that may sample it is under
/// way; and a texture's handle is released before the texture is destroyed.
class CheckedDevice final : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    /// What was done wrong, in words, in the order it happened; the first hundred.
    [[nodiscard]] std::span<const std::string> faults() const { return faults_; }

    [[nodiscard]] Result<BufferHandle> createBuffer(std::string_view label,
                                                    std::span<const std::byte> bytes) override;
    [[nodiscard]] Result<BufferHandle> reserveBuffer(std::string_view label, std::size_t bytes) override;
    void writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) override;
    void refillBuffer(std::string_view label, BufferHandle buffer) override;
    [[nodiscard]] Result<BufferHandle> createScratch(std::string_view label, std::size_t bytes) override;
    void destroyBuffer(BufferHandle buffer) override;
    [[nodiscard]] Result<TextureHandle> createTexels(std::string_view label, BufferHandle buffer) override;
    [[nodiscard]] Result<TextureHandle> createTexture(std::string_view label,
                                                      const TextureShape& shape) override;
    [[nodiscard]] std::uint64_t residentHandle(TextureHandle texture) override;
    void releaseHandle(TextureHandle texture) override;
    void destroyTexture(TextureHandle texture) override;
    [[nodiscard]] Result<ProgramHandle> createProgram(const ProgramSource& source) override;
    void destroyProgram(ProgramHandle program) override;
    void readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) override;
    void finishFrames() override;
    void setGeometry(BufferHandle vertices, BufferHandle indices) override;

    [[nodiscard]] std::span<std::byte> beginFrame(TargetHandle target) override;
    void bindStorage(std::span<const StorageRange> ranges) override;
    void bindTextures(std::span<const TextureHandle> textures) override;
    void compute(ProgramHandle program, const WorkGroups& groups) override;
    void setState(const DrawState& state) override;
    void drawVertices(std::uint32_t first, std::uint32_t count) override;
    void drawIndirect(std::size_t offset, std::uint32_t count) override;
    [[nodiscard]] Result<void> endFrame() override;

private:
    using Bytes = std::shared_ptr<const std::vector<std::byte>>;
    struct Texture {
        std::string label;
        std::uint64_t resident = 0; ///< its handle; 0: none
    };

    void fault(std::string what);
    void expectBetweenFrames(std::string_view command);
    void expectBuffer(BufferHandle buffer, std::string_view use);
    void expectTexture(TextureHandle texture, std::string_view use);
    void expectProgram(ProgramHandle program);
    void checkSampled();
    [[nodiscard]] static bool holds(const Bytes& references, std::uint64_t handle);

    std::vector<std::string> faults_;
    std::unordered_map<BufferHandle, Bytes> buffers_;
    std::unordered_map<TextureHandle, Texture> textures_;
    std::unordered_map<std::uint64_t, TextureHandle> residents_; ///< by handle
    std::unordered_map<ProgramHandle, bool> programs_;           ///< whether it samples by handle
    ProgramHandle program_ = ProgramHandle::Invalid;             ///< of the draws that follow
    Bytes references_;                                           ///< the texture references that are bound
    Bytes sound_; ///< those found resident, since residency changed last
    bool inFrame_ = false;
    std::vector<Bytes> sampled_;              ///< by the frame that is being made
    std::deque<std::vector<Bytes>> underWay_; ///< by frames that the GPU may not be done with
};

} // namespace limen::gpu
