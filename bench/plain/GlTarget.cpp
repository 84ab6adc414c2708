#include "plain/GlTarget.h"

#include "core/Assert.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace limen::bench {

namespace {

template <class T>
std::vector<T> topRowFirst(const std::vector<T>& rows, std::size_t rowLength) {
    std::vector<T> out;
    out.reserve(rows.size());
    for (std::size_t end = rows.size(); end > 0; end -= rowLength)
        out.insert(out.end(), rows.begin() + static_cast<std::ptrdiff_t>(end - rowLength),
                   rows.begin() + static_cast<std::ptrdiff_t>(end));
    return out;
}

} // namespace

GlTarget::GlTarget(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {
    const auto w = static_cast<GLsizei>(width), h = static_cast<GLsizei>(height);
    glCreateFramebuffers(1, &framebuffer_);
    glCreateRenderbuffers(1, &colour_);
    glCreateRenderbuffers(1, &depth_);
    glNamedRenderbufferStorage(colour_, GL_RGBA8, w, h);
    glNamedRenderbufferStorage(depth_, GL_DEPTH_COMPONENT32F, w, h);
    glNamedFramebufferRenderbuffer(framebuffer_, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    glNamedFramebufferRenderbuffer(framebuffer_, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    LIMEN_ASSERT(glCheckNamedFramebufferStatus(framebuffer_, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                 "every driver draws into these formats");
}

GlTarget::~GlTarget() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colour_);
    glDeleteRenderbuffers(1, &depth_);
}

void GlTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

std::vector<std::uint8_t> GlTarget::readColour() const {
    std::vector<std::uint8_t> rgba(std::size_t{width_} * height_ * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
    for (std::size_t i = 3; i < rgba.size(); i += 4)
        rgba[i] = 255;
    return topRowFirst(rgba, std::size_t{width_} * 4);
}

std::vector<float> GlTarget::readDepth() const {
    std::vector<float> depth(std::size_t{width_} * height_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_DEPTH_COMPONENT,
                 GL_FLOAT, depth.data());
    return topRowFirst(depth, width_);
}

} // namespace limen::bench
