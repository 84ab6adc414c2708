#include "gpu/device/SavedGlState.h"

#include <algorithm>
#include <cstddef>

namespace limen::gpu {
namespace {

// Of these, GL_MULTISAMPLE is on at first. GlDevice::restoreState sets the first four and the clip distances.
constexpr std::array kSwitchNames{GL_CULL_FACE,
                                  GL_DEPTH_TEST,
                                  GL_DITHER,
                                  GL_STENCIL_TEST,
                                  GL_CLIP_DISTANCE0,
                                  GL_CLIP_DISTANCE1,
                                  GL_CLIP_DISTANCE2,
                                  GL_CLIP_DISTANCE3,
                                  GL_CLIP_DISTANCE4,
                                  GL_CLIP_DISTANCE5,
                                  GL_CLIP_DISTANCE6,
                                  GL_CLIP_DISTANCE7,
                                  GL_COLOR_LOGIC_OP,
                                  GL_DEPTH_CLAMP,
                                  GL_FRAMEBUFFER_SRGB,
                                  GL_LINE_SMOOTH,
                                  GL_POLYGON_OFFSET_FILL,
                                  GL_POLYGON_SMOOTH,
                                  GL_PRIMITIVE_RESTART,
                                  GL_PRIMITIVE_RESTART_FIXED_INDEX,
                                  GL_PROGRAM_POINT_SIZE,
                                  GL_RASTERIZER_DISCARD,
                                  GL_SAMPLE_ALPHA_TO_COVERAGE,
                                  GL_SAMPLE_ALPHA_TO_ONE,
                                  GL_SAMPLE_COVERAGE,
                                  GL_SAMPLE_MASK,
                                  GL_SAMPLE_SHADING,
                                  GL_MULTISAMPLE};

constexpr GLuint kFirstSavedUnit = 0; // all units are saved

constexpr std::array kPixelStoreNames{
    GL_PACK_SWAP_BYTES,    GL_PACK_LSB_FIRST,      GL_PACK_ROW_LENGTH,    GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_PIXELS,   GL_PACK_IMAGE_HEIGHT,   GL_PACK_SKIP_IMAGES,   GL_PACK_ALIGNMENT,
    GL_UNPACK_SWAP_BYTES,  GL_UNPACK_LSB_FIRST,    GL_UNPACK_ROW_LENGTH,  GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_ALIGNMENT};

/// A target, and the query of its binding.
struct Binding {
    GLenum target, query;
};
constexpr std::array<Binding, 5> kBufferBindings{
    {{GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
     {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
     {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING},
     {GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING},
     {GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING}}};
constexpr std::array<Binding, 11> kTextureBindings{
    {{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
     {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
     {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
     {GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY},
     {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
     {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
     {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
     {GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY},
     {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
     {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
     {GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY}}};

GLint number(GLenum query) {
    GLint value = 0;
    glGetIntegerv(query, &value);
    return value;
}
GLint number(GLenum query, GLuint index) {
    GLint value = 0;
    glGetIntegeri_v(query, index, &value);
    return value;
}
GLint64 large(GLenum query, GLuint index) {
    GLint64 value = 0;
    glGetInteger64i_v(query, index, &value);
    return value;
}
std::size_t countOf(GLenum query, std::size_t most) {
    return std::min(static_cast<std::size_t>(std::max(number(query), 0)), most);
}

void setSwitch(GLenum name, bool on) {
    (on ? glEnable : glDisable)(name);
}
void setSwitch(GLenum name, GLuint index, bool on) {
    (on ? glEnablei : glDisablei)(name, index);
}

/// Binds a part of a buffer, or all of it, as it was.
void bindRange(GLenum target, GLuint index, GLint buffer, GLint64 offset, GLint64 size) {
    if (buffer == 0 || size == 0)
        glBindBufferBase(target, index, static_cast<GLuint>(buffer));
    else
        glBindBufferRange(target, index, static_cast<GLuint>(buffer), static_cast<GLintptr>(offset),
                          static_cast<GLsizeiptr>(size));
}

void discardErrors() {
    constexpr int kMostErrors = 16; // a lost context may report errors without end
    for (int i = 0; i < kMostErrors && glGetError() != GL_NO_ERROR; ++i) {
    }
}

} // namespace

SavedGlState::SavedGlState() {
    static_assert(kSwitchNames.size() == kSwitches && kTextureBindings.size() == kTextureTargets &&
                  kPixelStoreNames.size() == kPixelStores && kBufferBindings.size() == kBuffers);
    discardErrors();
    saveFixed();
    saveIndexed();
    saveBindings();
    setInitial();
}

SavedGlState::~SavedGlState() {
    restoreFixed();
    restoreIndexed();
    restoreBindings();
}

void SavedGlState::saveFixed() {
    for (std::size_t i = 0; i < kSwitches; ++i)
        switches_[i] = glIsEnabled(kSwitchNames[i]);
    for (std::size_t i = 0; i < kPixelStores; ++i)
        pixelStores_[i] = number(kPixelStoreNames[i]);
    depthFunction_ = number(GL_DEPTH_FUNC);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    cullFace_ = number(GL_CULL_FACE_MODE);
    frontFace_ = number(GL_FRONT_FACE);
    provokingVertex_ = number(GL_PROVOKING_VERTEX);
    clipOrigin_ = number(GL_CLIP_ORIGIN);
    clipDepth_ = number(GL_CLIP_DEPTH_MODE);
    glGetIntegerv(GL_POLYGON_MODE, polygonMode_.data());
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clearColour_.data());
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &clearDepth_);
}

void SavedGlState::saveIndexed() {
    viewportCount_ = countOf(GL_MAX_VIEWPORTS, kMostViewports);
    for (std::size_t i = 0; i < viewportCount_; ++i) {
        const auto index = static_cast<GLuint>(i);
        ViewportState& viewport = viewports_[i];
        glGetFloati_v(GL_VIEWPORT, index, viewport.rectangle.data());
        glGetDoublei_v(GL_DEPTH_RANGE, index, viewport.depthRange.data());
        viewport.isScissored = glIsEnabledi(GL_SCISSOR_TEST, index);
    }
    drawBufferCount_ = countOf(GL_MAX_DRAW_BUFFERS, kMostDrawBuffers);
    for (std::size_t i = 0; i < drawBufferCount_; ++i) {
        const auto index = static_cast<GLuint>(i);
        DrawBuffer& buffer = drawBuffers_[i];
        buffer.isBlended = glIsEnabledi(GL_BLEND, index);
        glGetBooleani_v(GL_COLOR_WRITEMASK, index, buffer.mask.data());
        buffer.factors = {number(GL_BLEND_SRC_RGB, index), number(GL_BLEND_DST_RGB, index),
                          number(GL_BLEND_SRC_ALPHA, index), number(GL_BLEND_DST_ALPHA, index)};
        buffer.equations = {number(GL_BLEND_EQUATION_RGB, index), number(GL_BLEND_EQUATION_ALPHA, index)};
    }
}

void SavedGlState::saveBindings() {
    program_ = number(GL_CURRENT_PROGRAM);
    vertexArray_ = number(GL_VERTEX_ARRAY_BINDING);
    drawFramebuffer_ = number(GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer_ = number(GL_READ_FRAMEBUFFER_BINDING);
    for (std::size_t i = 0; i < kBuffers; ++i)
        buffers_[i] = number(kBufferBindings[i].query);
    constexpr GLuint kFrame = frame::gpu::kBindFrame;
    uniform_ = {number(GL_UNIFORM_BUFFER_BINDING, kFrame), large(GL_UNIFORM_BUFFER_START, kFrame),
                large(GL_UNIFORM_BUFFER_SIZE, kFrame)};
    for (GLuint i = 0; i < storage_.size(); ++i)
        storage_[i] = {number(GL_SHADER_STORAGE_BUFFER_BINDING, i), large(GL_SHADER_STORAGE_BUFFER_START, i),
                       large(GL_SHADER_STORAGE_BUFFER_SIZE, i)};
    activeTexture_ = number(GL_ACTIVE_TEXTURE);
    unitCount_ = countOf(GL_MAX_TEXTURE_IMAGE_UNITS, kMostUnits);
    for (std::size_t unit = 0; unit < unitCount_; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (std::size_t i = 0; i < kTextureTargets; ++i)
            units_[unit].textures[i] = number(kTextureBindings[i].query);
        units_[unit].sampler = number(GL_SAMPLER_BINDING);
    }
}

void SavedGlState::setInitial() {
    for (const GLenum name : kSwitchNames)
        setSwitch(name, name == GL_MULTISAMPLE);
    for (const GLenum name : kPixelStoreNames)
        glPixelStorei(name, name == GL_PACK_ALIGNMENT || name == GL_UNPACK_ALIGNMENT ? 4 : 0);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    glDepthRange(0.0, 1.0);
    for (const Binding& binding : kBufferBindings)
        glBindBuffer(binding.target, 0);
    glUseProgram(0);
}

void SavedGlState::restoreFixed() const {
    for (std::size_t i = 0; i < kSwitches; ++i)
        setSwitch(kSwitchNames[i], switches_[i] == GL_TRUE);
    for (std::size_t i = 0; i < kPixelStores; ++i)
        glPixelStorei(kPixelStoreNames[i], pixelStores_[i]);
    glDepthFunc(static_cast<GLenum>(depthFunction_));
    glDepthMask(depthMask_);
    glCullFace(static_cast<GLenum>(cullFace_));
    glFrontFace(static_cast<GLenum>(frontFace_));
    glProvokingVertex(static_cast<GLenum>(provokingVertex_));
    glClipControl(static_cast<GLenum>(clipOrigin_), static_cast<GLenum>(clipDepth_));
    glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygonMode_[0]));
    glClearColor(clearColour_[0], clearColour_[1], clearColour_[2], clearColour_[3]);
    glClearDepthf(clearDepth_);
}

void SavedGlState::restoreIndexed() const {
    for (std::size_t i = 0; i < viewportCount_; ++i) {
        const auto index = static_cast<GLuint>(i);
        const ViewportState& viewport = viewports_[i];
        glViewportIndexedfv(index, viewport.rectangle.data());
        glDepthRangeIndexed(index, viewport.depthRange[0], viewport.depthRange[1]);
        setSwitch(GL_SCISSOR_TEST, index, viewport.isScissored == GL_TRUE);
    }
    for (std::size_t i = 0; i < drawBufferCount_; ++i) {
        const auto index = static_cast<GLuint>(i);
        const DrawBuffer& buffer = drawBuffers_[i];
        setSwitch(GL_BLEND, index, buffer.isBlended == GL_TRUE);
        glColorMaski(index, buffer.mask[0], buffer.mask[1], buffer.mask[2], buffer.mask[3]);
        glBlendFuncSeparatei(index, static_cast<GLenum>(buffer.factors[0]),
                             static_cast<GLenum>(buffer.factors[1]), static_cast<GLenum>(buffer.factors[2]),
                             static_cast<GLenum>(buffer.factors[3]));
        glBlendEquationSeparatei(index, static_cast<GLenum>(buffer.equations[0]),
                                 static_cast<GLenum>(buffer.equations[1]));
    }
}

void SavedGlState::restoreBindings() const {
    glUseProgram(static_cast<GLuint>(program_));
    glBindVertexArray(static_cast<GLuint>(vertexArray_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
    bindRange(GL_UNIFORM_BUFFER, frame::gpu::kBindFrame, uniform_.buffer, uniform_.offset, uniform_.size);
    for (GLuint i = 0; i < storage_.size(); ++i)
        bindRange(GL_SHADER_STORAGE_BUFFER, i, storage_[i].buffer, storage_[i].offset, storage_[i].size);
    for (std::size_t i = 0; i < kBuffers; ++i) // after the ranges, which change the general binding, too
        glBindBuffer(kBufferBindings[i].target, static_cast<GLuint>(buffers_[i]));
    glBindTextures(kFirstSavedUnit, static_cast<GLsizei>(unitCount_), nullptr); // of all targets
    for (std::size_t unit = 0; unit < unitCount_; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (std::size_t i = 0; i < kTextureTargets; ++i)
            if (units_[unit].textures[i] != 0)
                glBindTexture(kTextureBindings[i].target, static_cast<GLuint>(units_[unit].textures[i]));
        glBindSampler(static_cast<GLuint>(unit), static_cast<GLuint>(units_[unit].sampler));
    }
    glActiveTexture(static_cast<GLenum>(activeTexture_));
}

} // namespace limen::gpu
