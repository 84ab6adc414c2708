#pragma once

#include "gpu/device/Device.h"

#include <vector>

namespace limen::gpu {

/// A device without a driver. Records commands, keeps the frame's ring memory readable, and counts the GL
/// calls that GlDevice would make. For tests, and for timing the code above the driver.
class NullDevice final : public Device {
public:
    enum class CommandKind : std::uint8_t {
        BindStorage,  ///< a: number of ranges
        BindTextures, ///< a: number of textures
        ReadDrawn,
        Compute, ///< a: program handle, b: number of groups
        Clear,   ///< a: TargetImage
        ClearPicture,
        Flush,
        BeginStage,   ///< a: StageKind
        EndStage,     ///< a: StageKind
        BeginPass,    ///< a: Pass
        SetState,     ///< a: program handle
        DrawVertices, ///< a: first, b: count
        DrawIndirect, ///< a: byte offset in the ring, b: count
        Resolve
    };
    /// One command of the last frame. `a`, `b`: its parameters, in order.
    struct Command {
        CommandKind kind = CommandKind::BindStorage;
        std::size_t a = 0, b = 0;
        bool operator==(const Command&) const = default;
    };

    explicit NullDevice(Capabilities capabilities = defaultCapabilities());
    [[nodiscard]] static Capabilities defaultCapabilities();

    /// Commands since the last beginFrame.
    [[nodiscard]] std::span<const Command> commands() const { return commands_; }
    /// Storage ranges of the last bindStorage.
    [[nodiscard]] std::span<const StorageRange> storage() const { return storage_; }
    [[nodiscard]] std::span<const std::byte> ring() const { return ring_; }
    [[nodiscard]] std::span<const std::byte> buffer(BufferHandle handle) const {
        return buffers_[static_cast<std::size_t>(handle)];
    }
    [[nodiscard]] const ProgramSource& program(ProgramHandle handle) const {
        return programs_[static_cast<std::size_t>(handle)];
    }
    /// Every texture created so far, including destroyed ones.
    [[nodiscard]] std::span<const TextureShape> textures() const { return textures_; }
    [[nodiscard]] std::size_t liveObjects() const {
        return objects_.buffers + objects_.textures + objects_.programs + objects_.targets;
    }

    [[nodiscard]] const Capabilities& capabilities() const override { return capabilities_; }
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
    void writeTexture(TextureHandle texture, const TextureRows& rows,
                      std::span<const std::uint8_t> rgba) override;
    [[nodiscard]] std::uint64_t residentHandle(TextureHandle texture) override;
    void releaseHandle(TextureHandle texture) override;
    void destroyTexture(TextureHandle texture) override;
    [[nodiscard]] Result<ProgramHandle> createProgram(const ProgramSource& source) override;
    void destroyProgram(ProgramHandle program) override;
    [[nodiscard]] Result<TargetHandle> createTarget(std::uint32_t width, std::uint32_t height,
                                                    const TargetOptions& options) override;
    [[nodiscard]] std::vector<glm::vec2> samplePositions(TargetHandle target) override;
    void destroyTarget(TargetHandle target) override;
    void readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) override;
    void finishFrames() override {} // no GPU to wait for
    void setGeometry(BufferHandle vertices, BufferHandle indices) override;
    void setCulling(bool backFaces) override;
    [[nodiscard]] Result<void> reserveRing(std::size_t bytes) override;

    [[nodiscard]] std::span<std::byte> beginFrame(TargetHandle target, const Viewport& viewport) override;
    void bindStorage(std::span<const StorageRange> ranges) override;
    void bindTextures(std::span<const TextureHandle> textures, bool withDrawn) override;
    void readDrawn() override;
    [[nodiscard]] std::uint32_t baseInstanceAt(std::size_t offset) const override;
    void compute(ProgramHandle program, const WorkGroups& groups) override;
    void clear(TargetImage image, const ClearValue& value) override;
    void clearPicture(const glm::vec4& colour) override;
    void flush() override;
    void beginStage(frame::StageKind stage) override;
    void endStage(frame::StageKind stage) override;
    void beginPass(Pass pass) override;
    void setState(const DrawState& state) override;
    void drawVertices(std::uint32_t first, std::uint32_t count) override;
    void drawIndirect(std::size_t offset, std::uint32_t count) override;
    void resolve() override;
    [[nodiscard]] Result<void> endFrame() override;

    [[nodiscard]] std::uint32_t glCalls() const override { return lastFrameCalls_; }
    [[nodiscard]] std::uint32_t ringStalls() const override { return 0; }
    [[nodiscard]] StageTimes stageTimes() override { return {}; }
    [[nodiscard]] DeviceObjects objects() const override { return objects_; }

private:
    // Records a command for which GlDevice makes `glCalls` GL calls.
    void record(CommandKind kind, std::size_t a, std::size_t b, std::uint32_t glCalls);

    Capabilities capabilities_;
    std::vector<std::vector<std::byte>> buffers_;
    std::vector<std::size_t> bufferSizes_; ///< as requested
    std::vector<TextureShape> textures_;
    std::vector<ProgramSource> programs_;
    std::size_t targets_ = 0; // number created so far
    DeviceObjects objects_;
    std::vector<std::byte> ring_;
    std::vector<Command> commands_;
    std::vector<StorageRange> storage_;
    StateTracker state_;
    std::uint32_t frameCalls_ = 0, lastFrameCalls_ = 0;
};

} // namespace limen::gpu
