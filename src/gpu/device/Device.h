#pragma once

#include "core/Error.h"
#include "frame/FramePlan.h"
#include "gpu/device/Capabilities.h"
#include "gpu/device/ShaderLibrary.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

// What the renderer asks of a graphics device, at the level of "bind, clear, draw". Two implementations:
// GlDevice and NullDevice, which records. Handles are the device's own numbers; using one that was destroyed
// is a mistake of the programmer.
namespace limen::gpu {

enum class BufferHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };
enum class TextureHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };
enum class ProgramHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };
enum class TargetHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };

/// Of buffers that are read as textures.
inline constexpr std::size_t kBytesPerTexel = 16;

/// The images of a render target: RGBA8, R32UI, D32F (reversed: 0 is infinitely far), R32UI, and where it has them
/// RG32F.
enum class TargetImage : std::uint8_t { Colour, Id, Depth, Ownership, Layers };
[[nodiscard]] constexpr std::size_t bytesPerPixel(TargetImage image) {
    return image == TargetImage::Layers ? 8 : 4;
}

/// What a render target has beside colour, ids, depth and ownership.
struct TargetOptions {
    bool layers = false; ///< the image that translucent layers are counted in
    /// frame::gpu::kSamples a pixel, or 0 for one. Then there are no ids and no layers, colour is read resolved, and
    /// depth and ownership cannot be read.
    std::uint32_t samples = 0;
    friend bool operator==(const TargetOptions&, const TargetOptions&) = default;
};

/// Which images a draw writes. Each is a framebuffer of the target.
enum class Pass : std::uint8_t {
    Ownership,  ///< ownership only; no depth
    Solid,      ///< colour, id, depth
    SolidNoIds, ///< colour, depth
    SolidIds,   ///< id, depth
    Blended,    ///< colour, blended (one, one minus source alpha), and depth
    Layers      ///< layers, blended likewise, and depth
};
inline constexpr std::size_t kPassCount = 6;

/// The whole pipeline as far as it varies. Fixed for good: depth test >= (reversed depth, so equal means
/// "later wins"), lower-left origin, depth 0..1, counter-clockwise fronts, blending for the output of the
/// Blended and Layers passes.
struct DrawState {
    ProgramHandle program = ProgramHandle::Invalid;
    bool cullBackFaces = false;
    bool writeDepth = true;
};

/// A range of a buffer, or (buffer Invalid) of this frame's ring memory. Never empty.
struct StorageRange {
    BufferHandle buffer = BufferHandle::Invalid;
    std::size_t offset = 0, size = 0;
};
/// All storage ranges of a frame; the index is the binding (kBind... of SharedLayout.h).
using StorageBindings = std::array<StorageRange, frame::gpu::kStorageBindings>;
/// Bytes. Size of the range that stands for an empty array.
inline constexpr std::size_t kSmallestRange = 256;

/// An array texture: `levels` mips, RGBA8.
struct TextureShape {
    std::uint32_t width = 1, height = 1, layers = 1, levels = 1;
    bool clamp = false;
    float anisotropy = 1.0f;
    friend bool operator==(const TextureShape&, const TextureShape&) = default;
};

/// Rows of one level of one layer of a texture, from `first` down.
struct TextureRows {
    std::uint32_t layer = 0, level = 0;
    std::uint32_t width = 1; ///< of the level
    std::uint32_t first = 0, count = 1;
};

/// What an image is cleared to: colour or layers, visit number or id, depth.
using ClearValue = std::variant<glm::vec4, std::uint32_t, float>;

/// Milliseconds of GPU time per stage, of the latest frame whose results have arrived.
using StageTimes = std::array<std::optional<double>, frame::kStageCount>;

/// What a device holds. Buffers and textures are those that were asked for, not the ring's or the targets' own.
struct DeviceObjects {
    std::uint32_t buffers = 0, textures = 0, programs = 0, targets = 0;
    std::uint32_t residentHandles = 0; ///< bindless textures
    std::size_t bufferBytes = 0, ringBytes = 0;
    friend bool operator==(const DeviceObjects&, const DeviceObjects&) = default;
};

/// Work groups along any axis that every driver allows.
inline constexpr std::uint32_t kMostGroups = 65535;

/// How many work groups a compute program runs in.
struct WorkGroups {
    std::uint32_t columns = 1, rows = 1;
    /// At least `count` groups in rows of equal length, each within kMostGroups.
    [[nodiscard]] static WorkGroups atLeast(std::uint32_t count);
};

/// Frames that are under way at most.
inline constexpr std::size_t kFramesInFlight = 3;

/// Calls between beginFrame and endFrame, both included.
class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] virtual const Capabilities& capabilities() const = 0;

    // Resources. None of these during a frame.

    /// Immutable copy of `bytes`; may be empty. Errors, of all that is made: Driver, naming it, if it has no memory.
    [[nodiscard]] virtual Result<BufferHandle> createBuffer(std::string_view label,
                                                            std::span<const std::byte> bytes) = 0;
    /// A buffer of `bytes` that is filled by writeBuffer, from its beginning to its end, before anything reads it.
    [[nodiscard]] virtual Result<BufferHandle> reserveBuffer(std::string_view label, std::size_t bytes) = 0;
    virtual void writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) = 0;
    /// Forgets what a reserved buffer holds: it is filled again. Requires that no frame under way reads it, and that nothing is its texels.
    virtual void refillBuffer(std::string_view label, BufferHandle buffer) = 0;
    /// Memory that only the GPU writes and reads.
    [[nodiscard]] virtual Result<BufferHandle> createScratch(std::string_view label, std::size_t bytes) = 0;
    virtual void destroyBuffer(BufferHandle buffer) = 0;
    /// A buffer as texels of four words. Destroyed as a texture, before the buffer. Errors: Unsupported, if longer than the
    /// capabilities allow.
    [[nodiscard]] virtual Result<TextureHandle> createTexels(std::string_view label, BufferHandle buffer) = 0;
    /// Errors: Unsupported, if larger than the capabilities allow.
    [[nodiscard]] virtual Result<TextureHandle> createTexture(std::string_view label,
                                                              const TextureShape& shape) = 0;
    /// Tightly packed R,G,B,A, top row first (v runs downwards in all our data).
    virtual void writeTexture(TextureHandle texture, const TextureRows& rows,
                              std::span<const std::uint8_t> rgba) = 0;
    /// The texture's bindless handle, resident until it is released. Requires capabilities().bindless.
    [[nodiscard]] virtual std::uint64_t residentHandle(TextureHandle texture) = 0;
    /// Nobody samples it by its handle any more, frames under way included (finishFrames). Before it is destroyed.
    virtual void releaseHandle(TextureHandle texture) = 0;
    virtual void destroyTexture(TextureHandle texture) = 0;
    [[nodiscard]] virtual Result<ProgramHandle> createProgram(const ProgramSource& source) = 0;
    virtual void destroyProgram(ProgramHandle program) = 0;
    [[nodiscard]] virtual Result<TargetHandle> createTarget(std::uint32_t width, std::uint32_t height,
                                                            const TargetOptions& options) = 0;
    /// Where the samples of a multisampled target's pixels lie, in pixels from the pixel's lower left corner.
    [[nodiscard]] virtual std::vector<glm::vec2> samplePositions(TargetHandle target) = 0;
    virtual void destroyTarget(TargetHandle target) = 0;
    /// Reads an image that the target has, bottom row first, bytesPerPixel each (R,G,B,A; uint32; float; two floats).
    /// Waits for the GPU.
    virtual void readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) = 0;
    /// Waits until the GPU is done with all frames.
    virtual void finishFrames() = 0;
    /// The vertex and index arena that indexed draws use from now on. Free if it is the one set last.
    virtual void setGeometry(BufferHandle vertices, BufferHandle indices) = 0;
    /// Makes room for `bytes` of ring memory a frame; waits for frames in flight when it has to grow.
    [[nodiscard]] virtual Result<void> reserveRing(std::size_t bytes) = 0;

    // A frame.

    /// Starts a frame on `target`; yields this frame's ring memory, at least what was reserved. Waits if the
    /// GPU is three frames behind.
    [[nodiscard]] virtual std::span<std::byte> beginFrame(TargetHandle target) = 0;
    /// Binds storage ranges to bindings 0, 1, ...
    virtual void bindStorage(std::span<const StorageRange> ranges) = 0;
    /// Binds the target's ownership and depth images and the ring memory as texels to their units, and textures from kUnitVertices
    /// on.
    virtual void bindTextures(std::span<const TextureHandle> textures) = 0;
    /// Runs a compute program in columns x rows work groups, each at most kMostGroups. It reads what has been drawn; what it writes,
    /// draws that follow take as commands and indices, and programs run after it read.
    virtual void compute(ProgramHandle program, const WorkGroups& groups) = 0;
    virtual void clear(TargetImage image, const ClearValue& value) = 0;
    virtual void beginStage(frame::StageKind stage) = 0;
    virtual void endStage(frame::StageKind stage) = 0;
    virtual void beginPass(Pass pass) = 0;
    virtual void setState(const DrawState& state) = 0;
    /// Triangles without vertex input.
    virtual void drawVertices(std::uint32_t first, std::uint32_t count) = 0;
    /// `count` frame::gpu::DrawCommands at `offset` of the ring memory.
    virtual void drawIndirect(std::size_t offset, std::uint32_t count) = 0;
    /// Averages the samples of the target's colour into what is read and shown. Only for multisampled targets.
    virtual void resolve() = 0;
    /// Errors: Driver, naming it, once it has lost what it held: nothing will be drawn any more.
    [[nodiscard]] virtual Result<void> endFrame() = 0;

    // What happened.

    /// GL calls from beginFrame to endFrame of the last frame, timer queries not counted.
    [[nodiscard]] virtual std::uint32_t glCalls() const = 0;
    /// Frames that had to wait for the GPU, and times the ring grew.
    [[nodiscard]] virtual std::uint32_t ringStalls() const = 0;
    /// Never waits.
    [[nodiscard]] virtual StageTimes stageTimes() = 0;
    /// Cost: linear in what there is.
    [[nodiscard]] virtual DeviceObjects objects() const = 0;
};

/// Compares pipeline descriptions, so that only what differs is set. Knows nothing of GL.
class StateTracker {
public:
    /// What has to be set to get from the last state to `next`.
    struct Changes {
        bool program = false, cull = false, depthWrite = false;
        [[nodiscard]] std::uint32_t count() const {
            return std::uint32_t{program} + std::uint32_t{cull} + std::uint32_t{depthWrite};
        }
    };
    [[nodiscard]] Changes apply(const DrawState& next);
    /// True if depth writes have to be switched on; they are then taken to be on.
    [[nodiscard]] bool enableDepthWrite();
    /// True if culling has to be switched off; it is then taken to be off.
    [[nodiscard]] bool disableCulling();
    /// The current program is not what was set last (foreign code, or it was destroyed).
    void forgetProgram() { current_.program = ProgramHandle::Invalid; }

private:
    DrawState current_;
};

} // namespace limen::gpu
