#pragma once

#include "gpu/device/GlObjects.h"

namespace limen::gpu {

/// Shows a drawn picture. A picture of the window's size is copied; a smaller one is enlarged by
/// shaders/upscale.frag, which keeps edges.
class WindowPicture {
public:
    /// The finished colour of a target: the framebuffer that draws into it, and its texture.
    struct Source {
        GLuint framebuffer = 0, texture = 0;
        std::uint32_t width = 0, height = 0;
    };
    /// The framebuffer that is shown (0: the window's), and its size.
    struct Window {
        GLuint framebuffer = 0;
        std::uint32_t width = 0, height = 0;
    };
    /// Draws into the window, and leaves its framebuffer bound. Changes other GL state, too. The first
    /// enlargement builds the program; if the driver cannot, the driver's own filter enlarges.
    void show(const Source& source, const Window& window);

private:
    static void copy(const Source& source, const Window& window);
    [[nodiscard]] bool canEnlarge();

    Program program_;
    VertexArray noVertices_;
    bool hasFailed_ = false;
};

} // namespace limen::gpu
