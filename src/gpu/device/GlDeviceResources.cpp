#include "gpu/device/GlDevice.h"

#include "core/Assert.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

// Creation and destruction of GlDevice's objects.
namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

// Puts an object into the first free entry of a table and yields its index.
template <class Object, class IsFree>
std::uint32_t place(std::vector<Object>& table, Object object, IsFree isFree) {
    const auto free = std::find_if(table.begin(), table.end(), isFree);
    if (free != table.end()) {
        *free = std::move(object);
        return static_cast<std::uint32_t>(free - table.begin());
    }
    table.push_back(std::move(object));
    return static_cast<std::uint32_t>(table.size() - 1);
}

template <class Object>
std::uint32_t placeNamed(std::vector<Object>& table, Object object) {
    return place(table, std::move(object), [](const Object& other) { return other.empty(); });
}

struct AttributeSlot {
    GLuint vertexArray;
    GLuint slot;
};

void describeFloats(AttributeSlot to, GLuint location, GLint count, GLenum type, GLboolean normalised,
                    std::size_t offset) {
    glEnableVertexArrayAttrib(to.vertexArray, location);
    glVertexArrayAttribFormat(to.vertexArray, location, count, type, normalised, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(to.vertexArray, location, to.slot);
}

void describeIntegers(AttributeSlot to, GLuint location, GLint count, std::size_t offset) {
    glEnableVertexArrayAttrib(to.vertexArray, location);
    glVertexArrayAttribIFormat(to.vertexArray, location, count, GL_UNSIGNED_INT, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(to.vertexArray, location, to.slot);
}

// The attachment that each fragment output of a pass writes; GL_NONE: none.
template <std::size_t Count>
constexpr std::array<GLenum, Count> writes(std::initializer_list<std::pair<std::uint32_t, GLenum>> outputs) {
    std::array<GLenum, Count> attachments{}; // GL_NONE
    for (const auto& [output, attachment] : outputs)
        attachments[output] = attachment;
    return attachments;
}
constexpr GLenum kFirstImage = GL_COLOR_ATTACHMENT0, kIdImage = GL_COLOR_ATTACHMENT1;
constexpr std::array<GLenum, 1> kWritesNothing{GL_NONE};
constexpr auto kWritesVisit = writes<layout::kOutputVisit + 1>({{layout::kOutputVisit, kFirstImage}});
constexpr auto kWritesColour = writes<layout::kOutputColour + 1>({{layout::kOutputColour, kFirstImage}});
constexpr auto kWritesColourAndId =
    writes<layout::kOutputId + 1>({{layout::kOutputColour, kFirstImage}, {layout::kOutputId, kIdImage}});
constexpr auto kWritesId = writes<layout::kOutputId + 1>({{layout::kOutputId, kIdImage}});
constexpr auto kWritesBlended = writes<layout::kOutputBlended + 1>({{layout::kOutputBlended, kFirstImage}});
static_assert(GL_NONE == 0);

Result<void> makeFramebuffer(Framebuffer& out, const char* label, std::span<const Attachment> attachments,
                             std::span<const GLenum> drawBuffers) {
    Result<Framebuffer> framebuffer = Framebuffer::create(label, attachments, drawBuffers);
    if (!framebuffer)
        return Failure(framebuffer.error());
    out = std::move(*framebuffer);
    return {};
}

} // namespace

// The vertex format of the one arena (layout::Vertex).
void GlDevice::describeVertices(GLuint vertexArray) {
    using layout::Vertex;
    const AttributeSlot to{vertexArray, kArenaSlot};
    describeFloats(to, layout::kAttributePosition, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position));
    describeFloats(to, layout::kAttributeNormal, 4, GL_INT_2_10_10_10_REV, GL_TRUE, offsetof(Vertex, normal));
    describeFloats(to, layout::kAttributeUv, 2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv));
    describeIntegers(to, layout::kAttributePolygonSurface, 1, offsetof(Vertex, polygonSurface));
    describeFloats(to, layout::kAttributeFacet, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, facet));
    describeFloats(to, layout::kAttributeRest, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, rest));
}

// The format of draw records (layout::DrawRecord), one for each draw.
void GlDevice::describeRecords(GLuint vertexArray) {
    using layout::DrawRecord;
    const AttributeSlot to{vertexArray, kRecordSlot};
    const auto floats = [&](GLuint location, std::size_t offset) {
        describeFloats(to, location, 4, GL_FLOAT, GL_FALSE, offset);
    };
    floats(layout::kAttributeRow0, offsetof(DrawRecord, row0));
    floats(layout::kAttributeRow1, offsetof(DrawRecord, row1));
    floats(layout::kAttributeRow2, offsetof(DrawRecord, row2));
    floats(layout::kAttributeOffsetRest, offsetof(DrawRecord, rest));
    floats(layout::kAttributeAmbient, offsetof(DrawRecord, ambient));
    floats(layout::kAttributeSun, offsetof(DrawRecord, sun));
    describeIntegers(to, layout::kAttributeLook, 4, offsetof(DrawRecord, look));
    describeIntegers(to, layout::kAttributeMembers, 4, offsetof(DrawRecord, members));
    constexpr GLuint kEachInstance = 1;
    glVertexArrayBindingDivisor(vertexArray, kRecordSlot, kEachInstance);
}

GlDevice::GlDevice(Capabilities capabilities)
    : capabilities_(std::move(capabilities)), driver_(driverString()),
      vertexArray_(VertexArray::create("mesh vertices, draw records")) {
    describeVertices(vertexArray_.id());
    describeRecords(vertexArray_.id());
    restoreState();
}

GlDevice::~GlDevice() {
    for (GLsync fence : fences_)
        if (fence != nullptr)
            glDeleteSync(fence);
}

Result<std::unique_ptr<GlDevice>> GlDevice::create() {
    Result<Capabilities> capabilities = queryCapabilities();
    if (!capabilities)
        return Failure(capabilities.error());
    return std::unique_ptr<GlDevice>(new GlDevice(std::move(*capabilities)));
}

Result<BufferHandle> GlDevice::createBuffer(std::string_view label, std::span<const std::byte> bytes) {
    return Buffer::createStatic(label, bytes).map([&](Buffer buffer) {
        return static_cast<BufferHandle>(placeNamed(buffers_, std::move(buffer)));
    });
}

Result<BufferHandle> GlDevice::reserveBuffer(std::string_view label, std::size_t bytes) {
    return Buffer::createFillable(label, bytes).map([&](Buffer buffer) {
        return static_cast<BufferHandle>(placeNamed(buffers_, std::move(buffer)));
    });
}

void GlDevice::writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) {
    const Buffer& to = buffers_[static_cast<std::size_t>(buffer)];
    LIMEN_ASSERT(offset + bytes.size() <= to.size(), "within the buffer");
    glNamedBufferSubData(to.id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                         bytes.data());
}

void GlDevice::refillBuffer(std::string_view label, BufferHandle buffer) {
    buffers_[static_cast<std::size_t>(buffer)].relabel(label);
}

Result<BufferHandle> GlDevice::createScratch(std::string_view label, std::size_t bytes) {
    return Buffer::createScratch(label, bytes).map([&](Buffer buffer) {
        return static_cast<BufferHandle>(placeNamed(buffers_, std::move(buffer)));
    });
}

void GlDevice::destroyBuffer(BufferHandle buffer) {
    buffers_[static_cast<std::size_t>(buffer)] = Buffer{};
    geometry_.fill(BufferHandle::Invalid); // its number may be reused
}

Result<TextureHandle> GlDevice::createTexture(std::string_view label, const TextureShape& shape) {
    if (std::max(shape.width, shape.height) > capabilities_.maxTextureSize ||
        shape.layers > capabilities_.maxArrayLayers) {
        return fail(
            ErrorCode::Unsupported, std::string(label),
            fmt::format("has {} layers of {} x {} texels, more than {} allows; choose a smaller --radius",
                        shape.layers, shape.width, shape.height, capabilities_.renderer));
    }
    const float anisotropy = std::min(shape.anisotropy, capabilities_.maxAnisotropy);
    return Texture::createArray(label, shape.width, shape.height, shape.layers, shape.levels, shape.clamp,
                                anisotropy, shape.nearestLevel)
        .map([&](Texture texture) {
            return static_cast<TextureHandle>(placeNamed(textures_, std::move(texture)));
        });
}

Result<TextureHandle> GlDevice::createTexels(std::string_view label, BufferHandle buffer) {
    const Buffer& from = buffers_[static_cast<std::size_t>(buffer)];
    if (from.size() / kBytesPerTexel > capabilities_.maxBufferTexels) {
        return fail(
            ErrorCode::Unsupported, std::string(label),
            fmt::format("has {} bytes, but a buffer has at most {} texels on {}; choose a smaller --radius",
                        from.size(), capabilities_.maxBufferTexels, capabilities_.renderer));
    }
    return static_cast<TextureHandle>(
        placeNamed(textures_, Texture::createBufferView(label, from.id(), 0, from.size())));
}

void GlDevice::writeTexture(TextureHandle texture, const TextureRows& rows,
                            std::span<const std::uint8_t> rgba) {
    LIMEN_ASSERT(rgba.size() == std::size_t{rows.width} * rows.count * 4, "four bytes per texel");
    glTextureSubImage3D(textures_[static_cast<std::size_t>(texture)].id(), static_cast<GLint>(rows.level), 0,
                        static_cast<GLint>(rows.first), static_cast<GLint>(rows.layer),
                        static_cast<GLsizei>(rows.width), static_cast<GLsizei>(rows.count), 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, rgba.data());
}

std::uint64_t GlDevice::residentHandle(TextureHandle texture) {
    LIMEN_ASSERT(capabilities_.bindless, "handles need ARB_bindless_texture");
    return textures_[static_cast<std::size_t>(texture)].residentHandle();
}

void GlDevice::releaseHandle(TextureHandle texture) {
    textures_[static_cast<std::size_t>(texture)].releaseHandle();
}

void GlDevice::destroyTexture(TextureHandle texture) {
    textures_[static_cast<std::size_t>(texture)] = Texture{};
}

Result<ProgramHandle> GlDevice::createProgram(const ProgramSource& source) {
    if (!source.computeShader.empty())
        return createComputeProgram(source);
    const Result<std::string> vertex = shaderText(source.vertexShader, source);
    const Result<std::string> fragment = shaderText(source.fragmentShader, source);
    if (!vertex || !fragment)
        return Failure(vertex ? fragment.error() : vertex.error());
    Result<Program> program =
        Program::link(source.label, {{GL_VERTEX_SHADER, source.vertexShader, *vertex},
                                     {GL_FRAGMENT_SHADER, source.fragmentShader, *fragment}});
    if (!program)
        return Failure(program.error());
    return static_cast<ProgramHandle>(placeNamed(programs_, std::move(*program)));
}

Result<ProgramHandle> GlDevice::createComputeProgram(const ProgramSource& source) {
    const Result<std::string> text = shaderText(source.computeShader, source);
    if (!text)
        return Failure(text.error());
    Result<Program> program = Program::link(source.label, {{GL_COMPUTE_SHADER, source.computeShader, *text}});
    if (!program)
        return Failure(program.error());
    for (const UniformValue& uniform : source.uniforms)
        glProgramUniform1ui(program->id(), static_cast<GLint>(uniform.location), uniform.value);
    return static_cast<ProgramHandle>(placeNamed(programs_, std::move(*program)));
}

void GlDevice::destroyProgram(ProgramHandle program) {
    programs_[static_cast<std::size_t>(program)] = Program{};
    state_.forgetProgram();
}

Result<void> GlDevice::makePasses(Target& target) {
    const auto make = [&](Pass pass, const char* label, std::span<const Attachment> attachments,
                          std::span<const GLenum> drawBuffers) {
        return makeFramebuffer(target.passes[static_cast<std::size_t>(pass)], label, attachments,
                               drawBuffers);
    };
    const Attachment owner{kFirstImage, target.ownership.id()};
    const std::array<Attachment, 3> all{Attachment{kFirstImage, target.colour.id()},
                                        Attachment{kIdImage, target.id.id()},
                                        Attachment{GL_DEPTH_ATTACHMENT, target.depth.id()}};
    const std::array<Attachment, 2> noIds{all[0], all[2]};
    const std::array<Attachment, 2> onlyIds{all[1], all[2]};
    const std::array<Attachment, 2> layers{Attachment{kFirstImage, target.layers.id()}, all[2]};
    const auto unless = [](bool isLeftOut, auto makeIt) { return isLeftOut ? Result<void>{} : makeIt(); };
    const bool noId = target.id.empty();
    return make(Pass::Ownership, "ownership", {&owner, 1}, kWritesVisit)
        .and_then([&] { return make(Pass::SolidNoIds, "solid without ids", noIds, kWritesColour); })
        .and_then([&] { return make(Pass::Blended, "blended", noIds, kWritesBlended); })
        .and_then(
            [&] { return unless(noId, [&] { return make(Pass::Solid, "solid", all, kWritesColourAndId); }); })
        .and_then(
            [&] { return unless(noId, [&] { return make(Pass::SolidIds, "ids", onlyIds, kWritesId); }); })
        .and_then([&] {
            return unless(target.layers.empty(),
                          [&] { return make(Pass::Layers, "layers", layers, kWritesBlended); });
        })
        .and_then([&] {
            return make(Pass::Depth, "depth", {&all[2], 1}, kWritesNothing);
        })
        .and_then([&] {
            const Attachment resolved{kFirstImage, target.resolved.id()};
            return unless(!target.isMultisampled(), [&] {
                return makeFramebuffer(target.resolvedPass, "resolved", {&resolved, 1}, kWritesColour);
            });
        });
}

void GlDevice::makeImages(Target& target, const TargetOptions& options) {
    const auto make = [&](const char* label, GLenum format) {
        return options.samples == 0
                   ? Texture::createImage(label, format, target.width, target.height)
                   : Texture::createSampledImage(label, format, target.width, target.height, options.samples);
    };
    target.colour = make("colour", GL_RGBA8);
    target.depth = make("depth", GL_DEPTH_COMPONENT32F);
    target.ownership = make("ownership", GL_R32UI);
    if (options.samples > 0) {
        target.resolved = Texture::createImage("resolved", GL_RGBA8, target.width, target.height);
        return;
    }
    target.id = make("id", GL_R32UI);
    if (options.layers)
        target.layers = make("layers", GL_RG32F);
}

Result<TargetHandle> GlDevice::createTarget(std::uint32_t width, std::uint32_t height,
                                            const TargetOptions& options) {
    if (width == 0 || height == 0 || std::max(width, height) > capabilities_.maxTextureSize) {
        return fail(ErrorCode::BadArgument, fmt::format("{}x{}", width, height),
                    fmt::format("a picture has 1 to {} pixels per side on this driver",
                                capabilities_.maxTextureSize));
    }
    if (Result<void> checked = checkSamples(options.samples, capabilities_); !checked)
        return Failure(checked.error());
    auto target = std::make_unique<Target>();
    target->width = width;
    target->height = height;
    makeImages(*target, options);
    const Viewport first = firstViewport(width, height, options, capabilities_);
    if (state_.setViewport(first)) // its first frame makes the same calls as later ones
        glViewport(first.x, first.y, static_cast<GLsizei>(first.width), static_cast<GLsizei>(first.height));
    if (Result<void> checked = checkMemory(fmt::format("a picture of {}x{}", width, height)); !checked)
        return Failure(checked.error());
    if (Result<void> made = makePasses(*target); !made)
        return Failure(made.error());
    const auto isFree = [](const std::unique_ptr<Target>& other) { return other == nullptr; };
    return static_cast<TargetHandle>(place(targets_, std::move(target), isFree));
}

std::vector<glm::vec2> GlDevice::samplePositions(TargetHandle target) {
    const Target& of = *targets_[static_cast<std::size_t>(target)];
    LIMEN_ASSERT(of.isMultisampled(), "the target is multisampled");
    GLint before = 0;
    // samples can be queried only of the bound framebuffer
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, of.passes[static_cast<std::size_t>(Pass::SolidNoIds)].id());
    std::vector<glm::vec2> positions(layout::kSamples);
    for (GLuint i = 0; i < layout::kSamples; ++i)
        glGetMultisamplefv(GL_SAMPLE_POSITION, i, &positions[i].x);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
    return positions;
}

void GlDevice::destroyTarget(TargetHandle target) {
    targets_[static_cast<std::size_t>(target)].reset();
}

void GlDevice::readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) {
    const Target& from = *targets_[static_cast<std::size_t>(target)];
    LIMEN_ASSERT(out.size() == std::size_t{from.width} * from.height * bytesPerPixel(image),
                 "the size of the image");
    LIMEN_ASSERT(!from.isMultisampled() || image == TargetImage::Colour,
                 "of a multisampled target only colour can be read");
    // llvmpipe (Mesa 22.3) does not wait for the writes of a frame that also sampled the image (readDrawn).
    glFinish();
    const auto read = [&](const Texture& texture, GLenum format, GLenum type) {
        glGetTextureImage(texture.id(), 0, format, type, static_cast<GLsizei>(out.size()), out.data());
    };
    switch (image) {
    case TargetImage::Colour:
        return read(from.isMultisampled() ? from.resolved : from.colour, GL_RGBA, GL_UNSIGNED_BYTE);
    case TargetImage::Id:
        return read(from.id, GL_RED_INTEGER, GL_UNSIGNED_INT);
    case TargetImage::Depth:
        return read(from.depth, GL_DEPTH_COMPONENT, GL_FLOAT);
    case TargetImage::Ownership:
        return read(from.ownership, GL_RED_INTEGER, GL_UNSIGNED_INT);
    case TargetImage::Layers:
        LIMEN_ASSERT(!from.layers.empty(), "the target has a layers image");
        return read(from.layers, GL_RG, GL_FLOAT);
    }
}

void GlDevice::setGeometry(BufferHandle vertices, BufferHandle indices) {
    if (geometry_ == std::array{vertices, indices})
        return;
    geometry_ = {vertices, indices};
    glVertexArrayVertexBuffer(vertexArray_.id(), kArenaSlot,
                              buffers_[static_cast<std::size_t>(vertices)].id(), 0, sizeof(layout::Vertex));
    glVertexArrayElementBuffer(vertexArray_.id(), buffers_[static_cast<std::size_t>(indices)].id());
    glBindVertexArray(vertexArray_.id());
}

DeviceObjects GlDevice::objects() const {
    const auto countOf = [](const auto& table, auto&& counts) {
        return static_cast<std::uint32_t>(std::count_if(table.begin(), table.end(), counts));
    };
    const auto exists = [](const auto& object) { return !object.empty(); };
    DeviceObjects objects;
    objects.buffers = countOf(buffers_, exists);
    objects.textures = countOf(textures_, exists);
    objects.programs = countOf(programs_, exists);
    objects.targets = countOf(targets_, [](const auto& target) { return target != nullptr; });
    objects.residentHandles = countOf(textures_, [](const Texture& texture) { return texture.isResident(); });
    for (const Buffer& buffer : buffers_)
        objects.bufferBytes += buffer.empty() ? 0 : buffer.size();
    objects.ringBytes = ring_.size();
    return objects;
}

} // namespace limen::gpu
