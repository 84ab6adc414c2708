#pragma once

#include "gpu/device/Device.h"
#include "gpu/device/GlObjects.h"
#include "gpu/device/StageTimers.h"
#include "gpu/device/WindowPicture.h"

#include <memory>

namespace limen::gpu {

/// Message for a lost context, from the result of glGetGraphicsResetStatus.
[[nodiscard]] std::string lossMessage(unsigned status);

/// Device on the current OpenGL context. The context must outlive it and stay current on the calling thread.
/// Counts every GL call of a frame except timer queries.
class GlDevice final : public Device {
public:
    /// Sets the constant part of the pipeline state (DrawState). Errors: Driver, naming every missing
    /// feature.
    [[nodiscard]] static Result<std::unique_ptr<GlDevice>> create();
    ~GlDevice() override;

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
    void finishFrames() override;
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
    void beginStage(frame::StageKind stage) override { timers_.begin(stage); }
    void endStage(frame::StageKind stage) override { timers_.end(stage); }
    void beginPass(Pass pass) override;
    void setState(const DrawState& state) override;
    void drawVertices(std::uint32_t first, std::uint32_t count) override;
    void drawIndirect(std::size_t offset, std::uint32_t count) override;
    void resolve() override;
    [[nodiscard]] Result<void> endFrame() override;

    [[nodiscard]] std::uint32_t glCalls() const override { return lastFrameCalls_; }
    [[nodiscard]] std::uint32_t ringStalls() const override { return ringStalls_; }
    [[nodiscard]] StageTimes stageTimes() override { return timers_.poll(); }
    [[nodiscard]] DeviceObjects objects() const override;

    /// Restores all state that the device depends on. Between frames, after foreign code (the panel) used the
    /// context.
    void restoreState();
    /// Shows the target's colour in the window's framebuffer of `width` x `height` pixels (WindowPicture), and
    /// leaves that framebuffer bound for later drawing. Between frames; restores all state.
    void presentToWindow(TargetHandle target, std::uint32_t width, std::uint32_t height);

    /// Objects of the last frame on a target, for other code on the same context. They are the device's own: read them
    /// before its next frame, and change nothing of them.
    struct PictureNames {
        GLuint framebuffer = 0, colour = 0; ///< the finished picture, one sample a pixel
        GLuint ids = 0,
               depth = 0; ///< textures; ids is 0, and depth has several samples a pixel, if multisampled
    };
    [[nodiscard]] PictureNames namesOf(TargetHandle target) const;
    /// Copies the finished colour of a target into a framebuffer, its lower left corner at (x, y). Between frames;
    /// requires the state of restoreState. Errors: BadArgument for a framebuffer that does not exist or is not complete;
    /// Driver.
    [[nodiscard]] Result<void> copyTo(TargetHandle target, GLuint framebuffer, std::int32_t x,
                                      std::int32_t y);

private:
    struct Target {
        std::uint32_t width = 0, height = 0;
        Texture colour, id, depth, ownership, layers; // images drawn into
        std::array<Framebuffer, kPassCount> passes;
        Texture resolved; // single-sample colour of a multisampled target
        Framebuffer resolvedPass;
        [[nodiscard]] bool isMultisampled() const { return !resolved.empty(); }
        // The framebuffer with the finished picture.
        [[nodiscard]] const Texture& shownColour() const { return isMultisampled() ? resolved : colour; }
        [[nodiscard]] const Framebuffer& shown() const {
            return isMultisampled() ? resolvedPass : passes[static_cast<std::size_t>(Pass::SolidNoIds)];
        }
    };

    // Vertex buffers of the vertex arrays.
    static constexpr GLuint kArenaSlot = 0, kRecordSlot = 1;

    explicit GlDevice(Capabilities capabilities);
    static void describeVertices(GLuint vertexArray);
    static void describeRecords(GLuint vertexArray);

    // All GL calls of a frame are made here, to be counted.
    template <class Function, class... Arguments>
    auto call(Function function, Arguments... arguments) {
        ++frameCalls_;
        return function(arguments...);
    }
    /// Makes the calls for changes to `state`.
    void make(const StateTracker::Changes& changes, const DrawState& state);
    void waitForFence(std::size_t slot, bool counted);
    [[nodiscard]] Result<ProgramHandle> createComputeProgram(const ProgramSource& source);
    void makeImages(Target& target, const TargetOptions& options);
    [[nodiscard]] Result<void> makePasses(Target& target);

    Capabilities capabilities_;
    std::string driver_; ///< kept because a lost context cannot be queried
    std::vector<Buffer> buffers_;
    std::vector<Texture> textures_;
    std::vector<Program> programs_;
    std::vector<std::unique_ptr<Target>> targets_;
    VertexArray vertexArray_; ///< the arena, and draw records in the ring
    /// the current arena
    std::array<BufferHandle, 2> geometry_{BufferHandle::Invalid, BufferHandle::Invalid};
    StateTracker state_;
    StageTimers timers_;
    WindowPicture window_;

    Buffer ring_;
    std::array<Texture, kFramesInFlight> ringTexels_; // by slot
    std::size_t ringSlotSize_ = 0, ringSlot_ = 0;
    std::array<GLsync, kFramesInFlight> fences_{};

    const Target* frameTarget_ = nullptr; // between beginFrame and endFrame
    std::uint32_t frameCalls_ = 0, lastFrameCalls_ = 0, ringStalls_ = 0;
    bool isLost_ = false;
};

} // namespace limen::gpu
