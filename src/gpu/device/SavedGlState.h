#pragma once

#include "frame/GpuLayout.h"

#include <array>
#include <cstdint>

#include <epoxy/gl.h>

namespace limen::gpu {

/// The OpenGL state that a GlDevice and its drawing depend on or change, saved from the current context and put back by
/// the destructor. In between, state that the device does not set itself has its initial value. Errors that were pending
/// are discarded. Requires OpenGL 4.5, and no active query, transform feedback or conditional rendering.
/// Cost: some 700 GL calls without waiting for the GPU.
class SavedGlState {
public:
    SavedGlState();
    ~SavedGlState();
    SavedGlState(const SavedGlState&) = delete;
    SavedGlState& operator=(const SavedGlState&) = delete;

private:
    static constexpr std::size_t kMostViewports = 16, kMostDrawBuffers = 8, kMostUnits = 64;
    static constexpr std::size_t kSwitches = 28, kTextureTargets = 11, kPixelStores = 16, kBuffers = 5;

    struct DrawBuffer {
        GLboolean isBlended = GL_FALSE;
        std::array<GLboolean, 4> mask{};
        std::array<GLint, 4> factors{};   ///< source RGB, destination RGB, source alpha, destination alpha
        std::array<GLint, 2> equations{}; ///< RGB, alpha
    };
    struct ViewportState {
        std::array<GLfloat, 4> rectangle{};
        std::array<GLdouble, 2> depthRange{};
        GLboolean isScissored = GL_FALSE;
    };
    struct Range {
        GLint buffer = 0;
        GLint64 offset = 0, size = 0;
    };
    struct Unit {
        std::array<GLint, kTextureTargets> textures{};
        GLint sampler = 0;
    };

    void saveFixed();
    void saveIndexed();
    void saveBindings();
    void restoreFixed() const;
    void restoreIndexed() const;
    void restoreBindings() const;
    static void setInitial();

    std::array<GLboolean, kSwitches> switches_{};
    std::array<GLint, kPixelStores> pixelStores_{};
    GLint depthFunction_ = 0, cullFace_ = 0, frontFace_ = 0, provokingVertex_ = 0, clipOrigin_ = 0,
          clipDepth_ = 0;
    std::array<GLint, 2> polygonMode_{}; ///< a core context has one; some drivers write two
    GLboolean depthMask_ = GL_TRUE;
    std::array<GLfloat, 4> clearColour_{};
    GLfloat clearDepth_ = 1.0f;

    std::size_t viewportCount_ = 0, drawBufferCount_ = 0, unitCount_ = 0;
    std::array<ViewportState, kMostViewports> viewports_{};
    std::array<DrawBuffer, kMostDrawBuffers> drawBuffers_{};

    GLint program_ = 0, vertexArray_ = 0, drawFramebuffer_ = 0, readFramebuffer_ = 0, activeTexture_ = 0;
    std::array<GLint, kBuffers> buffers_{};
    Range uniform_;
    std::array<Range, frame::gpu::kStorageBindings> storage_{};
    std::array<Unit, kMostUnits> units_{};
};

} // namespace limen::gpu
