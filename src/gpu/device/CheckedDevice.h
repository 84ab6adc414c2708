#pragma once

#include "gpu/device/ForwardingDevice.h"

#include <deque>
#include <memory>
#include <string>
#include <unordered_map>

namespace limen::gpu {

/// Checks the use of another device. Drivers do not report a handle that is sampled without being resident or
/// is released too early; they draw garbage or lose the context. For development builds and tests. It copies
/// every buffer of a bindless device, and forwards all commands, including wrong ones.
///
/// Rules: resources are created and destroyed between frames. Objects in use exist. In a program with
/// bindless textures all handles in the texture references are resident. No handle is released while a frame
/// in flight may sample it. A handle is released before its texture is destroyed.
class CheckedDevice final : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    /// Messages of the first hundred violations, in order.
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

    [[nodiscard]] std::span<std::byte> beginFrame(TargetHandle target, const Viewport& viewport) override;
    void bindStorage(std::span<const StorageRange> ranges) override;
    void bindTextures(std::span<const TextureHandle> textures, bool withDrawn) override;
    void compute(ProgramHandle program, const WorkGroups& groups) override;
    void setState(const DrawState& state) override;
    void drawVertices(std::uint32_t first, std::uint32_t count) override;
    void drawIndirect(std::size_t offset, std::uint32_t count) override;
    [[nodiscard]] Result<void> endFrame() override;

private:
    using Bytes = std::shared_ptr<const std::vector<std::byte>>;
    struct Texture {
        std::string label;
        std::uint64_t resident = 0;                  ///< its handle; 0: none
        BufferHandle viewed = BufferHandle::Invalid; ///< as texels
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
    std::unordered_map<ProgramHandle, bool> programs_;           ///< whether the program samples by handle
    ProgramHandle program_ = ProgramHandle::Invalid;             ///< of the next draws
    Bytes references_;                                           ///< bound texture references
    Bytes sound_; ///< last references found resident, until residency changes
    bool inFrame_ = false;
    std::vector<Bytes> sampled_;              ///< by the current frame
    std::deque<std::vector<Bytes>> underWay_; ///< by frames in flight
};

} // namespace limen::gpu
