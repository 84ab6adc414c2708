#pragma once

#include "geometry/Vec.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace limen::worlds {

/// A picture: red, green, blue, alpha in 0..1 as they will be stored (no gamma), top row first.
class Canvas {
public:
    Canvas(int width, int height, Vec4f fill = Vec4f(0.0f))
        : width_(width), height_(height), texels_(static_cast<std::size_t>(width * height), fill) {}

    /// Paints every texel with `colourAt(u, v)`, u and v in 0..1 at the texel's centre, v downwards.
    template <class Painter>
    [[nodiscard]] static Canvas paint(int width, int height, Painter colourAt) {
        Canvas canvas(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                canvas.at(x, y) = colourAt((x + 0.5) / width, (y + 0.5) / height);
        return canvas;
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] Vec4f& at(int x, int y) { return texels_[static_cast<std::size_t>(y * width_ + x)]; }
    [[nodiscard]] const Vec4f& at(int x, int y) const {
        return texels_[static_cast<std::size_t>(y * width_ + x)];
    }
    /// The texel at (x, y) of the picture repeated in both directions.
    [[nodiscard]] Vec4f& wrapped(int x, int y) {
        return at(((x % width_) + width_) % width_, ((y % height_) + height_) % height_);
    }

private:
    int width_, height_;
    std::vector<Vec4f> texels_;
};

/// The colours times their alpha. A picture that is added must be black where nothing shines.
[[nodiscard]] Canvas shining(Canvas canvas);

/// From a (t = 0 and below) to b (1 and above).
[[nodiscard]] Vec3f mixColour(const Vec3f& a, const Vec3f& b, double t);

/// A straight, tapered brush stroke, in texels. It wraps around the borders and makes texels opaque.
struct Stroke {
    Vec2 from{0.0}, to{0.0};
    double widthFrom = 1.0, widthTo = 0.5;
    Vec4f colour{1.0f};
};
void drawStroke(Canvas& canvas, const Stroke& stroke);

/// A filled ellipse like a leaf: light along its middle rib, pointed at both ends.
struct Leaf {
    Vec2 centre{0.0};
    double angle = 0.0, length = 8.0, width = 4.0;
    Vec4f colour{1.0f};
};
/// `wrap`: it wraps around the borders, else it is clipped.
void drawLeaf(Canvas& canvas, const Leaf& leaf, bool wrap);

/// Gives transparent texels the colour of opaque ones near by, so that filtering makes no dark fringes. Keeps
/// alpha.
void bleedColour(Canvas& canvas);

} // namespace limen::worlds
