#include "GlFixture.h"
#include "gpu/device/WindowPicture.h"

#include <algorithm>
#include <array>
#include <functional>

namespace limen::gpu::test {
namespace {

using Rgb = std::array<int, 3>;
constexpr Rgb kRed{200, 10, 20}, kBlue{20, 30, 220};

/// An RGBA8 picture on the device, bottom row first.
struct Canvas {
    std::uint32_t width, height;
    Texture colour;
    Framebuffer framebuffer;

    Canvas(std::uint32_t w, std::uint32_t h)
        : width(w), height(h), colour(Texture::createImage("canvas", GL_RGBA8, w, h)) {
        const Attachment attachment{GL_COLOR_ATTACHMENT0, colour.id()};
        const GLenum drawn = GL_COLOR_ATTACHMENT0;
        framebuffer = Framebuffer::create("canvas", std::span(&attachment, 1), std::span(&drawn, 1)).value();
    }
    void paint(const std::function<Rgb(std::uint32_t, std::uint32_t)>& colourAt) const {
        std::vector<std::uint8_t> rgba;
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x) {
                for (const int value : colourAt(x, y))
                    rgba.push_back(static_cast<std::uint8_t>(value));
                rgba.push_back(255);
            }
        glTextureSubImage2D(colour.id(), 0, 0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height),
                            GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    }
    [[nodiscard]] std::vector<std::uint8_t> read() const {
        std::vector<std::uint8_t> rgba(std::size_t{width} * height * 4);
        glGetTextureImage(colour.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(rgba.size()),
                          rgba.data());
        return rgba;
    }
    [[nodiscard]] Rgb at(std::uint32_t x, std::uint32_t y) const {
        const std::vector<std::uint8_t> rgba = read();
        const std::size_t i = (std::size_t{y} * width + x) * 4;
        return {rgba[i], rgba[i + 1], rgba[i + 2]};
    }
};

class WindowPictureGlTest : public GlTest {
protected:
    void TearDown() override {
        picture_ = {}; // before the context
        GlTest::TearDown();
    }
    void show(const Canvas& from, const Canvas& to) {
        picture_.show({from.framebuffer.id(), from.colour.id(), from.width, from.height},
                      {to.framebuffer.id(), to.width, to.height});
        GLint bound = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        EXPECT_EQ(static_cast<GLuint>(bound), to.framebuffer.id());
    }
    WindowPicture picture_;
};

/// The number of pixels that have neither colour, by more than rounding.
int mixedPixels(const Canvas& canvas) {
    const std::vector<std::uint8_t> rgba = canvas.read();
    int mixed = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const auto is = [&](const Rgb& colour) {
            return std::abs(rgba[i] - colour[0]) <= 1 && std::abs(rgba[i + 2] - colour[2]) <= 1;
        };
        mixed += is(kRed) || is(kBlue) ? 0 : 1;
    }
    return mixed;
}

TEST_F(WindowPictureGlTest, ofTheWindowsSizeIsCopiedToTheBit) {
    const Canvas from(33, 17), to(33, 17);
    from.paint([](std::uint32_t x, std::uint32_t y) {
        return Rgb{static_cast<int>(x * 7 % 256), static_cast<int>(y * 11 % 256), 90};
    });
    show(from, to);
    EXPECT_EQ(from.read(), to.read());
}

TEST_F(WindowPictureGlTest, oneColourStaysOneColour) {
    const Canvas from(20, 10), to(37, 19);
    from.paint([](std::uint32_t, std::uint32_t) { return kRed; });
    show(from, to);
    EXPECT_EQ(mixedPixels(to), 0);
}

TEST_F(WindowPictureGlTest, keepsCornersInTheirPlaces) {
    const Canvas from(8, 4), to(16, 8);
    const std::array<Rgb, 4> colours{Rgb{255, 0, 0}, Rgb{0, 255, 0}, Rgb{0, 0, 255}, Rgb{255, 255, 255}};
    from.paint(
        [&](std::uint32_t x, std::uint32_t y) { return colours[(y >= 2 ? 2 : 0) + (x >= 4 ? 1 : 0)]; });
    show(from, to);
    EXPECT_EQ(to.at(0, 0), colours[0]);
    EXPECT_EQ(to.at(15, 0), colours[1]);
    EXPECT_EQ(to.at(0, 7), colours[2]);
    EXPECT_EQ(to.at(15, 7), colours[3]);
}

TEST_F(WindowPictureGlTest, anUprightEdgeIsOneTexelWideAtMost) {
    const Canvas from(20, 10), to(40, 20);
    from.paint([](std::uint32_t x, std::uint32_t) { return x < 10 ? kRed : kBlue; });
    show(from, to);
    EXPECT_LE(mixedPixels(to), 2 * 20);
    EXPECT_EQ(to.at(18, 10), kRed);
    EXPECT_EQ(to.at(21, 10), kBlue);
}

TEST_F(WindowPictureGlTest, anEdgeAlongADiagonalIsNarrowerThanTheDriversFilterMakesIt) {
    for (const bool isRising : {false, true}) {
        const Canvas from(20, 20), to(40, 40), linear(40, 40);
        from.paint(
            [&](std::uint32_t x, std::uint32_t y) { return (isRising ? x > y : x + y > 19) ? kRed : kBlue; });
        show(from, to);
        glBlitNamedFramebuffer(from.framebuffer.id(), linear.framebuffer.id(), 0, 0, 20, 20, 0, 0, 40, 40,
                               GL_COLOR_BUFFER_BIT, GL_LINEAR);
        EXPECT_LT(mixedPixels(to), 7 * mixedPixels(linear) / 10);
    }
}

TEST_F(WindowPictureGlTest, aLargerPictureIsMadeSmaller) {
    const Canvas from(40, 20), to(20, 10);
    from.paint([](std::uint32_t, std::uint32_t) { return kBlue; });
    show(from, to);
    EXPECT_EQ(mixedPixels(to), 0);
}

} // namespace
} // namespace limen::gpu::test
