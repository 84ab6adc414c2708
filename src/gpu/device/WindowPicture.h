#pragma once

#include "gpu/device/GlObjects.h"

namespace limen::gpu {

/// A drawn picture on its way to the window. Of the window's size it is copied, else enlarged by
/// shaders/upscale.frag, which keeps edges.
class WindowPicture {
public:
    /// The finished colour of a target: the framebuffer that draws into it, and its texture.
    struct Source {
        GLuint framebuffer = 0, texture = 0;
        std::uint32_t width = 0, height = 0;
    };
    /// Draws into the window's framebuffer, `width` x `height` pixels, and leaves it bound. Changes the program
    /// and the texture of kUnitPicture. The first enlargement builds the program; if the driver cannot, the
    /// driver's own filter enlarges.
    void show(const Source& source, std::uint32_t width, std::uint32_t height);

private:
    void copy(const Source& source, std::uint32_t width, std::uint32_t height) const;
    [[nodiscard]] bool canEnlarge();

    Program program_;
    VertexArray noVertices_;
    bool hasFailed_ = false;
};

} // namespace limen::gpu
