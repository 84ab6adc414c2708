#pragma once

#include <cstdint>
#include <vector>

namespace limen::bench {

/// A framebuffer with colour and depth in the current OpenGL context, without OpenGL's types: renderers with
/// headers of their own use it, too. The destructor needs that context.
class GlTarget {
public:
    GlTarget(std::uint32_t width, std::uint32_t height);
    GlTarget(const GlTarget&) = delete;
    GlTarget& operator=(const GlTarget&) = delete;
    ~GlTarget();

    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }
    [[nodiscard]] std::uint32_t framebuffer() const { return framebuffer_; }
    /// Binds it for drawing to all of it.
    void bind() const;
    /// R,G,B,A bytes, top row first, alpha 255.
    [[nodiscard]] std::vector<std::uint8_t> readColour() const;
    /// As OpenGL has it, top row first.
    [[nodiscard]] std::vector<float> readDepth() const;

private:
    std::uint32_t width_, height_;
    std::uint32_t framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

} // namespace limen::bench
