#include "gpu/device/GlObjects.h"

#include "gpu/device/ShaderLibrary.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

constexpr std::size_t kSmallestBuffer = 16;

void label(GLenum kind, GLuint id, std::string_view name) {
    glObjectLabel(kind, id, static_cast<GLsizei>(name.size()), name.data());
}

std::string glText(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(text));
}

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log;
}

// Compiles one stage and attaches it; the shader object is deleted with the program. Yields the log on
// failure.
std::optional<std::string> attachStage(GLuint program, const ShaderStage& stage) {
    const GLuint shader = glCreateShader(stage.type);
    const GLchar* text = stage.text.data();
    const auto length = static_cast<GLint>(stage.text.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::optional<std::string> log;
    if (compiled == GL_FALSE)
        log = readableLog(stage.name, shaderLog(shader));
    glAttachShader(program, shader);
    glDeleteShader(shader);
    return log;
}

Result<Buffer> kept(Buffer buffer, std::string_view name) {
    if (Result<void> checked = checkMemory(fmt::format("'{}', {} bytes", name, buffer.size())); !checked)
        return Failure(checked.error());
    return buffer;
}

} // namespace

namespace detail {
void deleteBuffer(GLuint id) {
    glDeleteBuffers(1, &id);
}
void deleteTexture(GLuint id) {
    glDeleteTextures(1, &id);
}
void deleteProgram(GLuint id) {
    glDeleteProgram(id);
}
void deleteVertexArray(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
void deleteFramebuffer(GLuint id) {
    glDeleteFramebuffers(1, &id);
}
void deleteQuery(GLuint id) {
    glDeleteQueries(1, &id);
}
} // namespace detail

Result<Buffer> Buffer::createStatic(std::string_view name, std::span<const std::byte> bytes) {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    label(GL_BUFFER, id, name);
    const std::size_t size = std::max(bytes.size(), kSmallestBuffer);
    if (bytes.size() >= kSmallestBuffer) {
        glNamedBufferStorage(id, static_cast<GLsizeiptr>(size), bytes.data(), 0);
    } else {
        std::array<std::byte, kSmallestBuffer> padded{};
        std::copy(bytes.begin(), bytes.end(), padded.begin());
        glNamedBufferStorage(id, static_cast<GLsizeiptr>(size), padded.data(), 0);
    }
    return kept(Buffer(id, size, {}), name);
}

Result<Buffer> Buffer::createEmpty(std::string_view name, std::size_t size, GLbitfield flags) {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    label(GL_BUFFER, id, name);
    size = std::max(size, kSmallestBuffer);
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(size), nullptr, flags);
    return kept(Buffer(id, size, {}), name);
}

Result<Buffer> Buffer::createFillable(std::string_view name, std::size_t size) {
    return createEmpty(name, size, GL_DYNAMIC_STORAGE_BIT);
}

Result<Buffer> Buffer::createScratch(std::string_view name, std::size_t size) {
    return createEmpty(name, size, 0);
}

void Buffer::relabel(std::string_view name) const {
    label(GL_BUFFER, id(), name);
}

Result<Buffer> Buffer::createMapped(std::string_view name, std::size_t size) {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    label(GL_BUFFER, id, name);
    const GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(size), nullptr, flags);
    void* bytes = glMapNamedBufferRange(id, 0, static_cast<GLsizeiptr>(size), flags);
    Result<Buffer> buffer =
        kept(Buffer(id, size, {static_cast<std::byte*>(bytes), bytes == nullptr ? 0 : size}), name);
    if (buffer && bytes == nullptr)
        return fail(
            ErrorCode::Driver, driverString(),
            fmt::format("cannot map a buffer of {} bytes; choose a smaller --radius or --quality", size));
    return buffer;
}

Texture::~Texture() {
    releaseHandle();
}

Texture Texture::createImage(std::string_view name, GLenum format, std::uint32_t width,
                             std::uint32_t height) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &id);
    label(GL_TEXTURE, id, name);
    glTextureStorage2D(id, 1, format, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return Texture(id);
}

Texture Texture::createBufferView(std::string_view name, GLuint buffer, std::size_t offset,
                                  std::size_t size) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
    label(GL_TEXTURE, id, name);
    glTextureBufferRange(id, GL_RGBA32UI, buffer, static_cast<GLintptr>(offset),
                         static_cast<GLsizeiptr>(size));
    return Texture(id);
}

Texture Texture::createSampledImage(std::string_view name, GLenum format, std::uint32_t width,
                                    std::uint32_t height, std::uint32_t samples) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &id);
    label(GL_TEXTURE, id, name);
    glTextureStorage2DMultisample(id, static_cast<GLsizei>(samples), format, static_cast<GLsizei>(width),
                                  static_cast<GLsizei>(height), GL_TRUE);
    return Texture(id);
}

Result<Texture> Texture::createArray(std::string_view name, std::uint32_t width, std::uint32_t height,
                                     std::uint32_t layers, std::uint32_t levels, bool clamp, float anisotropy,
                                     bool nearestLevel) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    label(GL_TEXTURE, id, name);
    glTextureStorage3D(id, static_cast<GLsizei>(levels), GL_RGBA8, static_cast<GLsizei>(width),
                       static_cast<GLsizei>(height), static_cast<GLsizei>(layers));
    const GLint wrap = clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, wrap);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, wrap);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER,
                        nearestLevel ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    if (anisotropy > 1.0f)
        glTextureParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
    Texture texture(id);
    const std::string what = fmt::format("'{}', {} layers of {} x {} texels", name, layers, width, height);
    if (Result<void> checked = checkMemory(what); !checked)
        return Failure(checked.error());
    return texture;
}

std::uint64_t Texture::residentHandle() {
    if (handle_ == 0) {
        handle_ = glGetTextureHandleARB(id());
        if (handle_ != 0)
            glMakeTextureHandleResidentARB(handle_);
    }
    return handle_;
}

void Texture::releaseHandle() {
    if (handle_ != 0) {
        glMakeTextureHandleNonResidentARB(handle_);
        handle_ = 0;
    }
}

Result<Program> Program::link(std::string_view name, std::initializer_list<ShaderStage> stages) {
    Program program(glCreateProgram());
    label(GL_PROGRAM, program.id(), name);
    std::string logs;
    for (const ShaderStage& stage : stages)
        logs += attachStage(program.id(), stage).value_or("");
    if (logs.empty()) {
        glLinkProgram(program.id());
        GLint linked = 0;
        glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
        if (linked != GL_FALSE)
            return program;
        logs = programLog(program.id());
    }
    return fail(ErrorCode::Driver, fmt::format("program {}", name),
                fmt::format("cannot be built on {}; update the driver. Its log:\n{}", driverString(), logs));
}

VertexArray VertexArray::create(std::string_view name) {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    label(GL_VERTEX_ARRAY, id, name);
    return VertexArray(id);
}

Result<Framebuffer> Framebuffer::create(std::string_view name, std::span<const Attachment> attachments,
                                        std::span<const GLenum> drawBuffers) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    Framebuffer framebuffer(id);
    label(GL_FRAMEBUFFER, id, name);
    for (const Attachment& attachment : attachments)
        glNamedFramebufferTexture(id, attachment.point, attachment.texture, 0);
    glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(drawBuffers.size()), drawBuffers.data());
    const GLenum status = glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        return fail(ErrorCode::Driver, driverString(),
                    fmt::format("cannot create the {} framebuffer (status 0x{:04X}); update the driver", name,
                                status));
    }
    return framebuffer;
}

Query Query::createTimestamp(std::string_view name) {
    GLuint id = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &id);
    label(GL_QUERY, id, name);
    return Query(id);
}

void Query::stamp() const {
    glQueryCounter(id(), GL_TIMESTAMP);
}

std::optional<std::uint64_t> Query::poll() const {
    GLint available = 0;
    glGetQueryObjectiv(id(), GL_QUERY_RESULT_AVAILABLE, &available);
    if (available == GL_FALSE)
        return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(id(), GL_QUERY_RESULT, &nanoseconds);
    return nanoseconds;
}

Result<void> checkMemory(std::string_view what) {
    // one of each kind can be pending; a lost context may report errors without end
    constexpr int kMostErrors = 16;
    bool isShort = false;
    GLenum error = glGetError();
    for (int i = 0; error != GL_NO_ERROR && i < kMostErrors; ++i) {
        isShort = isShort || error == GL_OUT_OF_MEMORY;
        error = glGetError();
    }
    if (isShort)
        return fail(
            ErrorCode::Driver, driverString(),
            fmt::format("has no memory for {}; choose a smaller --size, --radius or --quality", what));
    return {};
}

std::string driverString() {
    return fmt::format("{} / {} / OpenGL {}", glText(GL_VENDOR), glText(GL_RENDERER), glText(GL_VERSION));
}

} // namespace limen::gpu
