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

// Interface of a graphics device, at the level of bind, clear and draw. Implementations: GlDevice, and
// NullDevice, which records. Handles are the device's own numbers; using a destroyed one is a programming
// error.
namespace limen::gpu {

enum class BufferHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };
enum class TextureHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };
enum class ProgramHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };
enum class TargetHandle : std::uint32_t { Invalid = 0xFFFFFFFFu };

/// Of buffers read as textures.
inline constexpr std::size_t kBytesPerTexel = 16;

/// The images of a render target: RGBA8, R32UI, D32F (reversed: 0 is infinitely far), R32UI, and optionally
/// RG32F.
enum class TargetImage : std::uint8_t { Colour, Id, Depth, Ownership, Layers };
[[nodiscard]] constexpr std::size_t bytesPerPixel(TargetImage image) {
    return image == TargetImage::Layers ? 8 : 4;
}

/// The whole picture in pixels of a target, from the target's lower left corner. A target that is a tile of a
/// larger picture has a viewport that is larger than itself, with x <= 0 and y <= 0.
struct Viewport {
    std::int32_t x = 0, y = 0;
    std::uint32_t width = 0, height = 0;
    friend bool operator==(const Viewport&, const Viewport&) = default;
    /// Twice the size around the same middle. A side with an odd number of pixels, or more than half of `most`, stays.
    [[nodiscard]] constexpr Viewport doubled(std::uint32_t most) const {
        Viewport wide = *this;
        if (width % 2 == 0 && width <= most / 2) {
            wide.x -= static_cast<std::int32_t>(width / 2);
            wide.width *= 2;
        }
        if (height % 2 == 0 && height <= most / 2) {
            wide.y -= static_cast<std::int32_t>(height / 2);
            wide.height *= 2;
        }
        return wide;
    }
};

/// Options of a render target beside colour, ids, depth and ownership.
struct TargetOptions {
    bool layers = false; ///< with an image for counting transparent layers
    bool wide = false;   ///< the fast way of drawing uses Viewport::doubled
    /// Samples per pixel: frame::gpu::kSamples, or 0 for one. A multisampled target has no ids and no layers,
    /// its colour is read resolved, and its depth and ownership cannot be read.
    std::uint32_t samples = 0;
    friend bool operator==(const TargetOptions&, const TargetOptions&) = default;
};

/// Set when a target is made, so that its first frame makes the same calls as later ones.
[[nodiscard]] constexpr Viewport firstViewport(std::uint32_t width, std::uint32_t height,
                                               const TargetOptions& options,
                                               const Capabilities& capabilities) {
    const Viewport picture{0, 0, width, height};
    return options.wide ? picture.doubled(capabilities.maxViewport) : picture;
}

/// Images that a draw writes: a framebuffer of the target.
enum class Pass : std::uint8_t {
    Ownership,  ///< ownership only; no depth
    Solid,      ///< colour, id, depth
    SolidNoIds, ///< colour, depth
    SolidIds,   ///< id, depth
    Blended,    ///< colour, blended (one, one minus source alpha), and depth
    Layers,     ///< layers, blended in the same way, and depth
    Depth       ///< depth alone
};
inline constexpr std::size_t kPassCount = 7;

/// The depth test: >= (reversed depth; at equal depth the later draw wins), or none.
enum class DepthTest : std::uint8_t { Nearer, Always };

/// Clip distances that a draw may use.
inline constexpr std::uint32_t kClipDistances = 8;

/// The variable part of the pipeline state. Constant: lower-left origin, depth 0..1, counter-clockwise fronts, blending for the output of the
/// Blended and Layers passes.
struct DrawState {
    ProgramHandle program = ProgramHandle::Invalid;
    bool cullBackFaces = false;
    bool writeDepth = true;
    DepthTest depthTest = DepthTest::Nearer;
    bool clips = false; ///< the program writes all clip distances
};

/// A range of a buffer, or (buffer Invalid) of this frame's ring memory. Not empty.
struct StorageRange {
    BufferHandle buffer = BufferHandle::Invalid;
    std::size_t offset = 0, size = 0;
};
/// All storage ranges of a frame; the index is the binding (kBind... of SharedLayout.h).
using StorageBindings = std::array<StorageRange, frame::gpu::kStorageBindings>;
/// Bytes. Size of the range that stands for an empty array.
inline constexpr std::size_t kSmallestRange = 256;

/// An array texture: `levels` mip levels, RGBA8.
struct TextureShape {
    std::uint32_t width = 1, height = 1, layers = 1, levels = 1;
    bool clamp = false;
    float anisotropy = 1.0f;
    bool nearestLevel = false; ///< one mip level a sample, not a mean of two
    friend bool operator==(const TextureShape&, const TextureShape&) = default;
};

/// Rows of one mip level of one layer, from `first` down.
struct TextureRows {
    std::uint32_t layer = 0, level = 0;
    std::uint32_t width = 1; ///< of the level
    std::uint32_t first = 0, count = 1;
};

/// Clear value of an image: colour or layers, visit number or id, depth.
using ClearValue = std::variant<glm::vec4, std::uint32_t, float>;

/// Milliseconds of GPU time per stage, of the latest frame with timer results.
using StageTimes = std::array<std::optional<double>, frame::kStageCount>;

/// Objects that callers created on a device, without the ring's and the targets' own.
struct DeviceObjects {
    std::uint32_t buffers = 0, textures = 0, programs = 0, targets = 0;
    std::uint32_t residentHandles = 0; ///< bindless textures
    std::size_t bufferBytes = 0, ringBytes = 0;
    friend bool operator==(const DeviceObjects&, const DeviceObjects&) = default;
};

/// Work groups per axis that every driver supports.
inline constexpr std::uint32_t kMostGroups = 65535;

/// Grid of work groups of a compute dispatch.
struct WorkGroups {
    std::uint32_t columns = 1, rows = 1, layers = 1;
    /// A grid of at least `count` groups a layer, in rows of equal length within kMostGroups.
    [[nodiscard]] static WorkGroups atLeast(std::uint32_t count, std::uint32_t layers = 1);
};

/// Frames in flight at most.
inline constexpr std::size_t kFramesInFlight = 3;

/// Draw commands are issued between beginFrame and endFrame, resources change outside.
class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] virtual const Capabilities& capabilities() const = 0;

    // Resources. Between frames only.

    /// Immutable copy of `bytes`; may be empty. Errors, in all creating functions: Driver, if out of
    /// memory, naming it.
    [[nodiscard]] virtual Result<BufferHandle> createBuffer(std::string_view label,
                                                            std::span<const std::byte> bytes) = 0;
    /// A buffer of `bytes`, filled by writeBuffer from beginning to end before any read.
    [[nodiscard]] virtual Result<BufferHandle> reserveBuffer(std::string_view label, std::size_t bytes) = 0;
    virtual void writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) = 0;
    /// Discards the content of a reserved buffer, to be filled again. Requires that no frame in flight reads
    /// it and no texels view it.
    virtual void refillBuffer(std::string_view label, BufferHandle buffer) = 0;
    /// Memory that only the GPU reads and writes.
    [[nodiscard]] virtual Result<BufferHandle> createScratch(std::string_view label, std::size_t bytes) = 0;
    virtual void destroyBuffer(BufferHandle buffer) = 0;
    /// View of a buffer as texels of four words. Destroyed like a texture, before the buffer. Errors:
    /// Unsupported, if longer than the capabilities allow.
    [[nodiscard]] virtual Result<TextureHandle> createTexels(std::string_view label, BufferHandle buffer) = 0;
    /// Errors: Unsupported, if larger than the capabilities allow.
    [[nodiscard]] virtual Result<TextureHandle> createTexture(std::string_view label,
                                                              const TextureShape& shape) = 0;
    /// Tightly packed R,G,B,A, top row first (v runs downwards in all data).
    virtual void writeTexture(TextureHandle texture, const TextureRows& rows,
                              std::span<const std::uint8_t> rgba) = 0;
    /// Bindless handle of the texture, resident until released. Requires capabilities().bindless.
    [[nodiscard]] virtual std::uint64_t residentHandle(TextureHandle texture) = 0;
    /// Ends a handle's residency, before its texture is destroyed. Requires that no frame in flight samples
    /// it (finishFrames).
    virtual void releaseHandle(TextureHandle texture) = 0;
    virtual void destroyTexture(TextureHandle texture) = 0;
    [[nodiscard]] virtual Result<ProgramHandle> createProgram(const ProgramSource& source) = 0;
    virtual void destroyProgram(ProgramHandle program) = 0;
    [[nodiscard]] virtual Result<TargetHandle> createTarget(std::uint32_t width, std::uint32_t height,
                                                            const TargetOptions& options) = 0;
    /// Sample positions of a multisampled target, in pixels from the pixel's lower left corner.
    [[nodiscard]] virtual std::vector<glm::vec2> samplePositions(TargetHandle target) = 0;
    virtual void destroyTarget(TargetHandle target) = 0;
    /// Reads an image of the target, bottom row first, bytesPerPixel each (R,G,B,A; uint32; float; two
    /// floats). Waits for the GPU.
    virtual void readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) = 0;
    /// Waits until the GPU has completed all frames.
    virtual void finishFrames() = 0;
    /// Sets the vertex and index arena of indexed draws. No cost if unchanged.
    virtual void setGeometry(BufferHandle vertices, BufferHandle indices) = 0;
    /// Whether a frame's draws cull back faces unless they say otherwise: a frame begins and ends in that state. No cost if unchanged.
    virtual void setCulling(bool backFaces) = 0;
    /// Reserves ring memory of `bytes` per frame. Waits for frames in flight if it must grow.
    [[nodiscard]] virtual Result<void> reserveRing(std::size_t bytes) = 0;

    // A frame.

    /// Starts a frame on `target` and yields its ring memory, at least as reserved. Waits if the GPU is three
    /// frames behind.
    [[nodiscard]] virtual std::span<std::byte> beginFrame(TargetHandle target, const Viewport& viewport) = 0;
    /// Binds range kBindFrame as the uniform block, and every other range i to storage binding i. At
    /// least the first.
    virtual void bindStorage(std::span<const StorageRange> ranges) = 0;
    /// Binds the target's ownership and depth images and the ring memory to their units, and `textures` from
    /// kUnitVertices on. `withDrawn`: the target's colour and id images take the place of the textures at
    /// kUnitColour and kUnitId. Requires a target that is not multisampled.
    virtual void bindTextures(std::span<const TextureHandle> textures, bool withDrawn) = 0;
    /// The base instance of a draw command whose vertices read the frame::gpu::DrawRecord at `offset` of this
    /// frame's ring memory, a multiple of the record's size. Those of the next records follow.
    [[nodiscard]] virtual std::uint32_t baseInstanceAt(std::size_t offset) const = 0;
    /// Later draws of the frame may read the target's bound images: the pixel that they write, once, or others that they do not write.
    /// Later compute programs may read all pixels.
    virtual void readDrawn() = 0;
    /// Runs a compute program in a grid of work groups. It may read images of the current pass as they were at the last
    /// readDrawn (OpenGL 4.6, 9.3.1), and all others. Later draws see its output as commands and indices, later programs as storage.
    virtual void compute(ProgramHandle program, const WorkGroups& groups) = 0;
    virtual void clear(TargetImage image, const ClearValue& value) = 0;
    /// Clears the colour of the current pass, and its depth to 0, in one call. Requires Pass::SolidNoIds.
    virtual void clearPicture(const glm::vec4& colour) = 0;
    /// Has the driver begin with the draws so far, while later ones are prepared.
    virtual void flush() = 0;
    virtual void beginStage(frame::StageKind stage) = 0;
    virtual void endStage(frame::StageKind stage) = 0;
    virtual void beginPass(Pass pass) = 0;
    virtual void setState(const DrawState& state) = 0;
    /// Triangles without vertex input.
    virtual void drawVertices(std::uint32_t first, std::uint32_t count) = 0;
    /// `count` records of frame::gpu::DrawCommand at `offset` of the ring memory.
    virtual void drawIndirect(std::size_t offset, std::uint32_t count) = 0;
    /// Averages the samples of a multisampled target's colour for display and reading.
    virtual void resolve() = 0;
    /// Errors: Driver, naming it, when the context is lost. No later frame can be drawn.
    [[nodiscard]] virtual Result<void> endFrame() = 0;

    // Statistics.

    /// GL calls of the last frame, from beginFrame to endFrame, without timer queries.
    [[nodiscard]] virtual std::uint32_t glCalls() const = 0;
    /// Frames that waited for the GPU, plus growths of the ring.
    [[nodiscard]] virtual std::uint32_t ringStalls() const = 0;
    /// Does not wait.
    [[nodiscard]] virtual StageTimes stageTimes() = 0;
    /// Cost: linear in the number of objects.
    [[nodiscard]] virtual DeviceObjects objects() const = 0;
};

/// Compares pipeline states, so that only differences are set. Independent of GL.
class StateTracker {
public:
    /// State changes from the last state to `next`.
    struct Changes {
        bool program = false, cull = false, depthWrite = false, depthTest = false, clips = false;
        /// GL calls for them.
        [[nodiscard]] std::uint32_t count() const {
            return std::uint32_t{program} + std::uint32_t{cull} + std::uint32_t{depthWrite} +
                   std::uint32_t{depthTest} + (clips ? kClipDistances : 0);
        }
    };
    [[nodiscard]] Changes apply(const DrawState& next);
    /// The state in which frames begin and end; records it. True if it must be set.
    [[nodiscard]] bool setCulling(bool backFaces);
    /// True if depth writes must be enabled; records them as enabled.
    [[nodiscard]] bool enableDepthWrite();
    /// True if the colour of clearPicture must be set; records it as set.
    [[nodiscard]] bool setClearColour(const glm::vec4& colour);
    /// The changes to the state in which every frame begins and ends, with the current program; records them.
    [[nodiscard]] Changes reset();
    [[nodiscard]] const DrawState& current() const { return current_; }
    /// The current state with another program, for a compute program.
    [[nodiscard]] DrawState with(ProgramHandle program) const;
    /// The current program is unknown: foreign code set another, or it was destroyed.
    void forgetProgram() { current_.program = ProgramHandle::Invalid; }
    /// True if the viewport must be set; records it as set.
    [[nodiscard]] bool setViewport(const Viewport& viewport);
    [[nodiscard]] const Viewport& viewport() const { return viewport_; }

    /// That of frame::FrameView, so that first frames make the same calls as later ones.
    static constexpr glm::vec4 kFirstClearColour{0.5f, 0.0f, 0.5f, 1.0f};

private:
    DrawState current_;
    bool cullsBetween_ = false; ///< DrawState::cullBackFaces between frames
    Viewport viewport_;
    glm::vec4 clearColour_ = kFirstClearColour;
};

} // namespace limen::gpu
