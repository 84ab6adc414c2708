#include "gpu/device/WindowPicture.h"

#include "frame/GpuLayout.h"
#include "gpu/device/ShaderLibrary.h"

namespace limen::gpu {
namespace {

constexpr GLenum kFirstColour = GL_COLOR_ATTACHMENT0;
constexpr GLsizei kCorners = 3;

GLint windowSize(std::uint32_t pixels) {
    return static_cast<GLint>(pixels);
}

Result<Program> upscaleProgram() {
    const ProgramSource source{
        .label = "upscale", .vertexShader = "upscale.vert", .fragmentShader = "upscale.frag"};
    const Result<std::string> vertex = shaderText(source.vertexShader, source);
    const Result<std::string> fragment = shaderText(source.fragmentShader, source);
    if (!vertex || !fragment)
        return Failure(vertex ? fragment.error() : vertex.error());
    return Program::link(source.label, {{GL_VERTEX_SHADER, source.vertexShader, *vertex},
                                        {GL_FRAGMENT_SHADER, source.fragmentShader, *fragment}});
}

} // namespace

bool WindowPicture::canEnlarge() {
    if (hasFailed_ || !program_.empty())
        return !hasFailed_;
    Result<Program> program = upscaleProgram();
    hasFailed_ = !program.has_value();
    if (hasFailed_)
        return false;
    program_ = std::move(*program);
    noVertices_ = VertexArray::create("upscale");
    return true;
}

void WindowPicture::copy(const Source& source, const Window& window) {
    const bool isScaled = window.width != source.width || window.height != source.height;
    glNamedFramebufferReadBuffer(source.framebuffer, kFirstColour);
    glBlitNamedFramebuffer(source.framebuffer, window.framebuffer, 0, 0, windowSize(source.width),
                           windowSize(source.height), 0, 0, windowSize(window.width),
                           windowSize(window.height), GL_COLOR_BUFFER_BIT, isScaled ? GL_LINEAR : GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, window.framebuffer);
}

void WindowPicture::show(const Source& source, const Window& window) {
    if ((window.width <= source.width && window.height <= source.height) || !canEnlarge()) {
        copy(source, window);
        return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, window.framebuffer);
    glViewport(0, 0, windowSize(window.width), windowSize(window.height));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glBindTextureUnit(frame::gpu::kUnitPicture, source.texture);
    glUseProgram(program_.id());
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, kCorners);
}

} // namespace limen::gpu
