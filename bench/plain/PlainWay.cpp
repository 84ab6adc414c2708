#include "plain/PlainWay.h"

#include "plain/GlTarget.h"
#include "plain/PlainScene.h"
#include "plain/PlainShaders.h"

#include "gpu/device/HeadlessContext.h"

#include <array>
#include <bit>
#include <cstddef>
#include <epoxy/gl.h>
#include <string>

namespace limen::bench {

namespace {

/// Attribute and uniform locations, as in PlainShaders.h.
enum : GLuint { kPosition, kNormal, kUv, kPlacement };
enum : GLint { kClip, kTowardsSun, kSunColour, kAmbient, kColour, kLuminosity, kInverted, kAdded };
constexpr std::array<float, 4> kSkyColour{0.5f, 0.7f, 0.9f, 1.0f};

std::string messageOf(GLuint object, bool isProgram) {
    std::array<char, 1024> text{};
    if (isProgram)
        glGetProgramInfoLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    else
        glGetShaderInfoLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    return text.data();
}

Result<GLuint> buildShader(GLenum stage, const std::string& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint isBuilt = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isBuilt);
    if (isBuilt == GL_FALSE)
        return fail(ErrorCode::Driver, "plain shader", messageOf(shader, false));
    return shader;
}

Result<GLuint> buildProgram(const char* define) {
    const Result<GLuint> vertex = buildShader(GL_VERTEX_SHADER, kPlainVertexShader);
    const Result<GLuint> fragment =
        buildShader(GL_FRAGMENT_SHADER, std::string("#version 450 core\n") + define + kPlainFragmentShader);
    if (!vertex || !fragment)
        return Failure((vertex ? fragment : vertex).error());
    const GLuint program = glCreateProgram();
    for (const GLuint shader : {*vertex, *fragment}) {
        glAttachShader(program, shader);
        glDeleteShader(shader); // with the program
    }
    glLinkProgram(program);
    GLint isLinked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (isLinked == GL_FALSE)
        return fail(ErrorCode::Driver, "plain program", messageOf(program, true));
    return program;
}

/// Reversed depth without a far plane, as Limen's.
glm::mat4 clipFromScene(const frame::FrameView& frame, const Vec3& origin) {
    const Vec3 x = frame.view.right / frame.view.tanHalfX, y = frame.view.up / frame.view.tanHalfY;
    const Vec3& w = frame.view.forward;
    const Vec3 eye = frame.view.eye - origin;
    const glm::dmat4 clip{{x.x, y.x, 0.0, w.x},
                          {x.y, y.y, 0.0, w.y},
                          {x.z, y.z, 0.0, w.z},
                          {-glm::dot(x, eye), -glm::dot(y, eye), frame.nearPlane, -glm::dot(w, eye)}};
    return glm::mat4(clip);
}

class PlainWay final : public FrameWay {
public:
    PlainWay(gpu::HeadlessContext context, std::uint32_t width, std::uint32_t height)
        : FrameWay(kPlainWay), context_(std::move(context)), target_(width, height) {}
    ~PlainWay() override {
        static_cast<void>(enter());
        releaseTextures();
        glDeleteTextures(1, &white_);
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        glDeleteVertexArrays(1, &vertexArray_);
        for (const GLuint program : programs_)
            glDeleteProgram(program);
    }

    [[nodiscard]] Result<void> prepare();
    [[nodiscard]] Result<void> enter() override { return context_.makeCurrent(); }
    [[nodiscard]] Result<void> show(const FramePlace& place) override;
    [[nodiscard]] Result<void> draw() override;
    [[nodiscard]] FramePicture read() override {
        return {target_.width(), target_.height(), target_.readColour(), target_.readDepth()};
    }

private:
    enum Buffer : std::size_t { kVertices, kIndices, kPlacements, kBufferCount };
    enum Variant : std::size_t { kOpaque, kCutOut, kBlended, kVariantCount };

    void makeVertexArray();
    void releaseTextures();
    [[nodiscard]] GLuint textureFor(const PlainSurface& surface);
    void beginFrame();
    void setSurface(const PlainSurface& surface);
    void drawSolid();
    void drawBlended();
    static void drawPart(const PlainDraw& part, std::uint32_t first, std::uint32_t count);

    gpu::HeadlessContext context_;
    GlTarget target_;
    GLuint vertexArray_ = 0, white_ = 0;
    std::array<GLuint, kBufferCount> buffers_{};
    std::array<GLuint, kVariantCount> programs_{};
    const FramePlace* place_ = nullptr;
    const engine::LoadedPart* texturesOf_ = nullptr;            ///< the part that the textures are of
    std::map<std::pair<std::uint32_t, bool>, GLuint> textures_; ///< by index, and whether it is clamped
    PlainScene scene_;
    PlainSelection selection_;
};

Result<void> PlainWay::prepare() {
    constexpr std::array<const char*, kVariantCount> kDefines{"", "#define CUT_OUT\n", "#define BLENDED\n"};
    for (std::size_t i = 0; i < kVariantCount; ++i) {
        const Result<GLuint> program = buildProgram(kDefines[i]);
        if (!program)
            return Failure(program.error());
        programs_[i] = *program;
    }
    glCreateTextures(GL_TEXTURE_2D, 1, &white_);
    constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};
    glTextureStorage2D(white_, 1, GL_RGBA8, 1, 1);
    glTextureSubImage2D(white_, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kWhite.data());
    glCreateBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    makeVertexArray();
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glClearDepth(0.0);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    return {};
}

void PlainWay::makeVertexArray() {
    glCreateVertexArrays(1, &vertexArray_);
    glVertexArrayVertexBuffer(vertexArray_, 0, buffers_[kVertices], 0, sizeof(PlainVertex));
    glVertexArrayVertexBuffer(vertexArray_, 1, buffers_[kPlacements], 0, sizeof(glm::mat4));
    glVertexArrayBindingDivisor(vertexArray_, 1, 1);
    glVertexArrayElementBuffer(vertexArray_, buffers_[kIndices]);
    const auto attribute = [&](GLuint location, GLint size, std::size_t offset, GLuint binding) {
        glEnableVertexArrayAttrib(vertexArray_, location);
        glVertexArrayAttribFormat(vertexArray_, location, size, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(vertexArray_, location, binding);
    };
    attribute(kPosition, 3, offsetof(PlainVertex, position), 0);
    attribute(kNormal, 3, offsetof(PlainVertex, normal), 0);
    attribute(kUv, 2, offsetof(PlainVertex, uv), 0);
    for (GLuint column = 0; column < 4; ++column)
        attribute(kPlacement + column, 4, column * sizeof(glm::vec4), 1);
}

void PlainWay::releaseTextures() {
    for (const auto& [key, texture] : textures_)
        glDeleteTextures(1, &texture);
    textures_.clear();
}

GLuint PlainWay::textureFor(const PlainSurface& surface) {
    if (surface.texture == world::kNone)
        return white_;
    const auto [entry, isNew] = textures_.try_emplace({surface.texture, surface.isClamped}, 0);
    if (!isNew)
        return entry->second;
    const world::Image& image = *place_->part->world.textures[surface.texture];
    const auto width = static_cast<GLsizei>(image.width), height = static_cast<GLsizei>(image.height);
    const auto levels = static_cast<GLsizei>(std::bit_width(std::max(image.width, image.height)));
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, levels, GL_RGBA8, width, height);
    glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glGenerateTextureMipmap(texture);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    const GLint wrap = surface.isClamped ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, wrap);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, wrap);
    entry->second = texture;
    return texture;
}

Result<void> PlainWay::show(const FramePlace& place) {
    place_ = &place;
    if (texturesOf_ != place.part.get())
        releaseTextures();
    texturesOf_ = place.part.get();
    scene_ = plainSceneOf(place);
    const auto upload = [&](Buffer buffer, const auto& array) {
        glNamedBufferData(buffers_[buffer], static_cast<GLsizeiptr>(array.size() * sizeof array[0]),
                          array.data(), GL_STATIC_DRAW);
    };
    upload(kVertices, scene_.vertices);
    upload(kIndices, scene_.indices);
    for (const std::vector<PlainDraw>* draws : {&scene_.solid, &scene_.blended})
        for (const PlainDraw& draw : *draws)
            static_cast<void>(textureFor(draw.surface));
    return {};
}

Result<void> PlainWay::draw() {
    selectPlain(place_->part->world, scene_, place_->view.view, selection_);
    beginFrame();
    drawSolid();
    drawBlended();
    glFinish();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR)
        return fail(ErrorCode::Driver, "plain renderer", "OpenGL error " + std::to_string(error));
    return {};
}

void PlainWay::beginFrame() {
    const std::vector<glm::mat4>& placements = selection_.placements;
    glNamedBufferData(buffers_[kPlacements], static_cast<GLsizeiptr>(placements.size() * sizeof(glm::mat4)),
                      placements.data(), GL_STREAM_DRAW);
    const glm::mat4 clip = clipFromScene(place_->view, scene_.origin);
    const PlainLight light = plainLightOf(place_->part->world, place_->view);
    for (const GLuint program : programs_) {
        glProgramUniformMatrix4fv(program, kClip, 1, GL_FALSE, &clip[0].x);
        glProgramUniform3fv(program, kTowardsSun, 1, &light.towards.x);
        glProgramUniform3fv(program, kSunColour, 1, &light.sun.x);
        glProgramUniform3fv(program, kAmbient, 1, &light.ambient.x);
    }
    target_.bind();
    glBindVertexArray(vertexArray_);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClearColor(kSkyColour[0], kSkyColour[1], kSkyColour[2], kSkyColour[3]);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PlainWay::setSurface(const PlainSurface& surface) {
    glBindTextureUnit(0, textureFor(surface));
    glUniform4fv(kColour, 1, &surface.colour.x);
    glUniform1f(kLuminosity, surface.luminosity);
}

void PlainWay::drawPart(const PlainDraw& part, std::uint32_t first, std::uint32_t count) {
    glDrawElementsInstancedBaseInstance(
        GL_TRIANGLES, static_cast<GLsizei>(part.indexCount), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(std::size_t{part.firstIndex} * sizeof(std::uint32_t)),
        static_cast<GLsizei>(count), first);
}

void PlainWay::drawSolid() {
    world::SurfaceClass drawn = world::SurfaceClass::Opaque;
    glUseProgram(programs_[kOpaque]);
    for (const PlainDraw& part : scene_.solid) {
        const PlainRun& run = selection_.ofModel[part.model];
        if (run.count == 0)
            continue;
        if (part.surface.surfaceClass != drawn)
            glUseProgram(programs_[kCutOut]);
        drawn = part.surface.surfaceClass;
        setSurface(part.surface);
        drawPart(part, run.first, run.count);
    }
}

void PlainWay::drawBlended() {
    glUseProgram(programs_[kBlended]);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    for (const PlainSelection::Blended& blended : selection_.blended) {
        const PlainDraw& part = scene_.blended[blended.draw];
        setSurface(part.surface);
        glUniform1f(kInverted, part.surface.isInvAlpha ? 1.0f : 0.0f);
        glUniform1f(kAdded, part.surface.isAdditive ? 1.0f : 0.0f);
        drawPart(part, blended.instance, 1);
    }
}

} // namespace

Result<std::unique_ptr<FrameWay>> makePlainWay(std::uint32_t width, std::uint32_t height) {
    Result<gpu::HeadlessContext> context = gpu::HeadlessContext::create();
    if (!context)
        return Failure(context.error());
    auto way = std::make_unique<PlainWay>(std::move(*context), width, height);
    if (Result<void> prepared = way->prepare(); !prepared)
        return Failure(prepared.error());
    return way;
}

} // namespace limen::bench
