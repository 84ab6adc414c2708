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

// One move-only owner per kind of GL object, on the current context. Empty (id 0) is a valid state. Objects
// are created by direct state access (GL 4.5), without binding.
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
    /// Copy of `bytes`, zero-padded to at least 16 bytes, so that it can always be bound. Errors, here and
    /// below: Driver, if out of memory.
    [[nodiscard]] static Result<Buffer> createStatic(std::string_view label,
                                                     std::span<const std::byte> bytes);
    /// `size` bytes, at least 16, filled later (glNamedBufferSubData).
    [[nodiscard]] static Result<Buffer> createFillable(std::string_view label, std::size_t size);
    /// `size` bytes that only the GPU reads and writes.
    [[nodiscard]] static Result<Buffer> createScratch(std::string_view label, std::size_t size);
    /// `size` bytes, mapped coherently for writing until destroyed. Errors: Driver, if it cannot be mapped.
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
        std::swap(handle_, other.handle_);
        GlName::operator=(std::move(other));
        return *this;
    }
    /// Ends the residency of its handle first.
    ~Texture();

    /// Image of a render target: one mip level, one layer, nearest filter.
    [[nodiscard]] static Texture createImage(std::string_view label, GLenum format, std::uint32_t width,
                                             std::uint32_t height);
    /// Multisampled image, with equal sample positions in every pixel.
    [[nodiscard]] static Texture createSampledImage(std::string_view label, GLenum format,
                                                    std::uint32_t width, std::uint32_t height,
                                                    std::uint32_t samples);
    /// RGBA8 array with `levels` mip levels, trilinear. Errors: Driver, if out of memory.
    [[nodiscard]] static Result<Texture> createArray(std::string_view label, std::uint32_t width,
                                                     std::uint32_t height, std::uint32_t layers,
                                                     std::uint32_t levels, bool clamp, float anisotropy,
                                                     bool nearestLevel);

    /// View of a buffer as texels of four words. The buffer must outlive it; `offset` must have the driver's
    /// alignment.
    [[nodiscard]] static Texture createBufferView(std::string_view label, GLuint buffer, std::size_t offset,
                                                  std::size_t size);

    /// Bindless handle, made resident by the first call. Requires ARB_bindless_texture. Parameters and
    /// storage are immutable from then on. 0 if the driver refuses.
    [[nodiscard]] std::uint64_t residentHandle();
    [[nodiscard]] bool isResident() const { return handle_ != 0; }
    /// Ends the residency of the handle, if any.
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

/// A vertex array object; its owner sets the format.
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
    /// `drawBuffers[i]`: attachment that fragment output i writes (GL_NONE: none). Errors: Driver, if
    /// incomplete.
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
    /// Records the GPU time at which all earlier commands are complete.
    void stamp() const;
    /// Nanoseconds, if available; does not wait.
    [[nodiscard]] std::optional<std::uint64_t> poll() const;

private:
    explicit Query(GLuint id) : GlName(id) {}
};

/// Clears all pending GL errors. Errors: Driver, naming it and the object `what`, if one is GL_OUT_OF_MEMORY.
/// Other errors are programming errors, which DebugOutput reports.
[[nodiscard]] Result<void> checkMemory(std::string_view what);

/// Vendor, renderer and version in one line.
[[nodiscard]] std::string driverString();

} // namespace limen::gpu
