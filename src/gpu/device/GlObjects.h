#pragma once

#include "core/Error.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

// One move-only owner per kind of GL object, on the current context. Empty is a legal state (id 0) and free
// to destroy. All creation is direct state access (GL 4.5); nothing here binds anything.
namespace limen::gpu {

/// Owner of one GL name. `Delete` is a function void(GLuint).
template <auto Delete>
class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint id) : id_(id) {}
    GlName(GlName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    GlName(const GlName&) = delete;
    GlName& operator=(const GlName&) = delete;
    ~GlName() {
        if (id_ != 0)
            Delete(id_);
    }

    /// The raw name; 0 when empty.
    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] bool empty() const { return id_ == 0; }

private:
    GLuint id_ = 0;
};

namespace detail {
void deleteBuffer(GLuint id);
void deleteTexture(GLuint id);
void deleteProgram(GLuint id);
void deleteVertexArray(GLuint id);
void deleteFramebuffer(GLuint id);
void deleteQuery(GLuint id);
} // namespace detail

/// A buffer with immutable storage (glNamedBufferStorage).
class Buffer : public GlName<detail::deleteBuffer> {
public:
    Buffer() = default;
    /// Holds a copy of `bytes`; at least 16 bytes long, zero-filled, so that it can always be bound. Errors, here and below:
    /// Driver, if it has no memory.
    [[nodiscard]] static Result<Buffer> createStatic(std::string_view label,
                                                     std::span<const std::byte> bytes);
    /// `size` bytes, at least 16, to be filled later (glNamedBufferSubData).
    [[nodiscard]] static Result<Buffer> createFillable(std::string_view label, std::size_t size);
    /// `size` bytes that only the GPU writes and reads.
    [[nodiscard]] static Result<Buffer> createScratch(std::string_view label, std::size_t size);
    /// `size` bytes, mapped for writing until destroyed, coherent. Errors: Driver, if it cannot be mapped.
    [[nodiscard]] static Result<Buffer> createMapped(std::string_view label, std::size_t size);

    void relabel(std::string_view label) const;
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<std::byte> mapped() const { return mapped_; }

private:
    [[nodiscard]] static Result<Buffer> createEmpty(std::string_view label, std::size_t size,
                                                    GLbitfield flags);
    Buffer(GLuint id, std::size_t size, std::span<std::byte> mapped)
        : GlName(id), size_(size), mapped_(mapped) {}
    std::size_t size_ = 0;
    std::span<std::byte> mapped_;
};

/// A 2-D texture, or an array of them, with immutable storage.
class Texture : public GlName<detail::deleteTexture> {
public:
    Texture() = default;
    Texture(Texture&& other) noexcept : GlName(std::move(other)), handle_(std::exchange(other.handle_, 0)) {}
    Texture& operator=(Texture&& other) noexcept {
        GlName::operator=(std::move(other));
        std::swap(handle_, other.handle_);
        return *this;
    }
    /// Makes its handle non-resident first, where one was taken.
    ~Texture();

    /// One mip level, one layer, nearest filter: a render target's image.
    [[nodiscard]] static Texture createImage(std::string_view label, GLenum format, std::uint32_t width,
                                             std::uint32_t height);
    /// The same with several samples a pixel, at the same places in every pixel.
    [[nodiscard]] static Texture createSampledImage(std::string_view label, GLenum format,
                                                    std::uint32_t width, std::uint32_t height,
                                                    std::uint32_t samples);
    /// RGBA8 array with `levels` mips, trilinear. Errors: Driver, if it has no memory.
    [[nodiscard]] static Result<Texture> createArray(std::string_view label, std::uint32_t width,
                                                     std::uint32_t height, std::uint32_t layers,
                                                     std::uint32_t levels, bool clamp, float anisotropy);

    /// Bytes of a buffer as texels of four words. The buffer must outlive it; `offset` is a multiple of what the driver asks.
    [[nodiscard]] static Texture createBufferView(std::string_view label, GLuint buffer, std::size_t offset,
                                                  std::size_t size);

    /// The bindless handle, made resident on the first call. Needs ARB_bindless_texture; parameters and
    /// storage are fixed from then on. 0 if the driver refuses.
    [[nodiscard]] std::uint64_t residentHandle();
    [[nodiscard]] bool isResident() const { return handle_ != 0; }
    /// Makes it non-resident, if there is one.
    void releaseHandle();

private:
    explicit Texture(GLuint id) : GlName(id) {}
    std::uint64_t handle_ = 0;
};

/// One stage's source for Program::link; `name` is the shader's file.
struct ShaderStage {
    GLenum type = 0;
    std::string_view name;
    std::string_view text;
};

/// A linked program.
class Program : public GlName<detail::deleteProgram> {
public:
    Program() = default;
    /// Errors: Driver, with the log (file and line) and the driver's name.
    [[nodiscard]] static Result<Program> link(std::string_view label,
                                              std::initializer_list<ShaderStage> stages);

private:
    explicit Program(GLuint id) : GlName(id) {}
};

/// A vertex array object; its format is set by the one who owns it.
class VertexArray : public GlName<detail::deleteVertexArray> {
public:
    VertexArray() = default;
    [[nodiscard]] static VertexArray create(std::string_view label);

private:
    explicit VertexArray(GLuint id) : GlName(id) {}
};

/// An attachment of Framebuffer::create.
struct Attachment {
    GLenum point = 0;
    GLuint texture = 0;
};

/// A framebuffer object.
class Framebuffer : public GlName<detail::deleteFramebuffer> {
public:
    Framebuffer() = default;
    /// `drawBuffers[i]`: what fragment output i writes (GL_NONE: nothing). Errors: Driver, when not complete.
    [[nodiscard]] static Result<Framebuffer> create(std::string_view label,
                                                    std::span<const Attachment> attachments,
                                                    std::span<const GLenum> drawBuffers);

private:
    explicit Framebuffer(GLuint id) : GlName(id) {}
};

/// A timestamp query.
class Query : public GlName<detail::deleteQuery> {
public:
    Query() = default;
    [[nodiscard]] static Query createTimestamp(std::string_view label);
    /// Asks for the time at which everything before has been done.
    void stamp() const;
    /// Nanoseconds, if the result is there; never waits.
    [[nodiscard]] std::optional<std::uint64_t> poll() const;

private:
    explicit Query(GLuint id) : GlName(id) {}
};

/// Takes all errors that wait to be asked for. Errors: Driver, naming it and `what`, if one of them is that it has no memory; the others
/// are the programmer's, and DebugOutput's to tell.
[[nodiscard]] Result<void> checkMemory(std::string_view what);

/// The driver, in one line: vendor, renderer, version.
[[nodiscard]] std::string driverString();

} // namespace limen::gpu
