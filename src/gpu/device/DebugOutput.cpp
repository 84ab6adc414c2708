#include "gpu/device/DebugOutput.h"

#include "gpu/device/GlObjects.h"

namespace limen::gpu {
namespace {

void onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
               const void* user) {
    const std::string message =
        length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
    static_cast<DebugOutput*>(const_cast<void*>(user))->receive(type, severity, message);
}

} // namespace

DebugOutput::DebugOutput() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(&onMessage, this);
}

DebugOutput::~DebugOutput() {
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
}

void DebugOutput::receive(unsigned type, unsigned severity, std::string message) {
    if (type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH)
        faults_.push_back(std::move(message));
}

} // namespace limen::gpu
