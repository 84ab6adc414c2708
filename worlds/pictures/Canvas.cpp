#include "worlds/pictures/Canvas.h"

namespace limen::worlds {

namespace {

void blendOver(Vec4f& under, const Vec4f& over, double coverage) {
    const float c = static_cast<float>(std::clamp(coverage, 0.0, 1.0)) * over.w;
    if (c <= 0.0f)
        return;
    const float alpha = under.w + c * (1.0f - under.w);
    // An empty texel takes the brush's colour; a painted one is mixed with it.
    const float mix = under.w <= 0.0f ? 1.0f : c;
    under = Vec4f(Vec3f(under) + (Vec3f(over) - Vec3f(under)) * mix, alpha);
}

} // namespace

Canvas shining(Canvas canvas) {
    for (int y = 0; y < canvas.height(); ++y)
        for (int x = 0; x < canvas.width(); ++x)
            canvas.at(x, y) = Vec4f(Vec3f(canvas.at(x, y)) * canvas.at(x, y).w, canvas.at(x, y).w);
    return canvas;
}

Vec3f mixColour(const Vec3f& a, const Vec3f& b, double t) {
    return a + (b - a) * static_cast<float>(std::clamp(t, 0.0, 1.0));
}

void drawStroke(Canvas& canvas, const Stroke& s) {
    const double reach = std::max(s.widthFrom, s.widthTo) + 1.0;
    const int x0 = static_cast<int>(std::floor(std::min(s.from.x, s.to.x) - reach));
    const int x1 = static_cast<int>(std::ceil(std::max(s.from.x, s.to.x) + reach));
    const int y0 = static_cast<int>(std::floor(std::min(s.from.y, s.to.y) - reach));
    const int y1 = static_cast<int>(std::ceil(std::max(s.from.y, s.to.y) + reach));
    const Vec2 along = s.to - s.from;
    const double lengthSquared = std::max(1e-9, glm::dot(along, along));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const Vec2 p{x + 0.5, y + 0.5};
            const double t = std::clamp(glm::dot(p - s.from, along) / lengthSquared, 0.0, 1.0);
            const double half = 0.5 * (s.widthFrom + (s.widthTo - s.widthFrom) * t);
            const double distance = glm::length(p - s.from - along * t);
            blendOver(canvas.wrapped(x, y), s.colour, half + 0.5 - distance);
        }
    }
}

void drawLeaf(Canvas& canvas, const Leaf& leaf, bool wrap) {
    const int reach = static_cast<int>(std::ceil(std::max(leaf.length, leaf.width))) + 1;
    const int cx = static_cast<int>(leaf.centre.x);
    const int cy = static_cast<int>(leaf.centre.y);
    const Vec2 axis{std::cos(leaf.angle), std::sin(leaf.angle)};
    for (int y = cy - reach; y <= cy + reach; ++y) {
        for (int x = cx - reach; x <= cx + reach; ++x) {
            if (!wrap && (x < 0 || y < 0 || x >= canvas.width() || y >= canvas.height()))
                continue;
            const Vec2 d = Vec2{x + 0.5, y + 0.5} - leaf.centre;
            const double along = glm::dot(d, axis) / (0.5 * leaf.length);
            const double across = (d.x * -axis.y + d.y * axis.x) / (0.5 * leaf.width);
            const double edge = (1.0 - along * along) - std::abs(across);
            if (edge <= 0.0)
                continue;
            const float rib =
                static_cast<float>(1.0 + 0.18 * std::exp(-across * across * 24.0) - 0.12 * (across > 0.0));
            const Vec4f colour{Vec3f(leaf.colour) * rib, leaf.colour.w};
            blendOver(canvas.wrapped(x, y), colour, edge * 0.5 * leaf.width + 0.3);
        }
    }
}

void bleedColour(Canvas& canvas) {
    for (int pass = 0; pass < 6; ++pass) {
        const Canvas before = canvas;
        for (int y = 0; y < canvas.height(); ++y) {
            for (int x = 0; x < canvas.width(); ++x) {
                if (Vec3f(before.at(x, y)) != Vec3f(0.0f))
                    continue;
                Vec3f sum(0.0f);
                float count = 0.0f;
                for (int k = 0; k < 9; ++k) {
                    const int nx = std::clamp(x + k % 3 - 1, 0, canvas.width() - 1);
                    const int ny = std::clamp(y + k / 3 - 1, 0, canvas.height() - 1);
                    if (Vec3f(before.at(nx, ny)) != Vec3f(0.0f)) {
                        sum += Vec3f(before.at(nx, ny));
                        count += 1.0f;
                    }
                }
                if (count > 0.0f)
                    canvas.at(x, y) = Vec4f(sum / count, before.at(x, y).w);
            }
        }
    }
}

} // namespace limen::worlds
