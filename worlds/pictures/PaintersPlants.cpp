#include "geometry/Angles.h"
#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

namespace limen::worlds {

namespace {

/// Blades of grass from the lower edge, bent outwards.
void drawBlades(Canvas& canvas, int count, std::uint32_t seed) {
    const double w = canvas.width();
    const double h = canvas.height();
    for (int k = 0; k < count; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        const double root = w * (0.5 + 0.30 * (random01(i, 1, seed) - 0.5) * 2.0);
        const double lean = (root / w - 0.5) * 1.1 + 0.5 * (random01(i, 2, seed) - 0.5);
        const double length = h * (0.40 + 0.55 * random01(i, 3, seed));
        const Vec3f colour =
            mixColour(Vec3f(0.20f, 0.30f, 0.08f), Vec3f(0.52f, 0.58f, 0.22f), random01(i, 4, seed));
        Vec2 from{root, h + 1.0};
        for (int s = 0; s < 6; ++s) {
            const double t = (s + 1) / 6.0;
            const Vec2 to{std::clamp(root + lean * w * 0.42 * t * t, 2.0, w - 2.0),
                          h - length * (t - 0.18 * t * t * std::abs(lean))};
            const double width = 4.6 * (1.0 - s / 6.5);
            const float shade = static_cast<float>(0.55 + 0.45 * t);
            drawStroke(canvas, {from, to, width, width - 0.5, Vec4f(colour * shade, 1.0f)});
            from = to;
        }
    }
}

/// Strokes wrap around the borders. This erases the parts that wrapped from the lower to the upper edge or
/// back.
void clearRows(Canvas& canvas, int from, int to) {
    for (int y = from; y < to; ++y)
        for (int x = 0; x < canvas.width(); ++x)
            canvas.at(x, y) = Vec4f(0.0f);
}

} // namespace

Canvas paintLeaves(Vec3f light, Vec3f dark, int count, std::uint32_t seed) {
    constexpr int kSize = 256;
    Canvas canvas(kSize, kSize);
    for (int k = 0; k < count; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        // Leaves are clustered around a few dozen twigs inside a ragged disc.
        const std::uint32_t twig = hash(i % 46u, seed);
        const double a = kTurn * random01(twig, 1);
        const double r = 96.0 * std::sqrt(random01(twig, 2));
        const double b = kTurn * random01(i, 3, seed);
        const double s = 27.0 * std::sqrt(random01(i, 4, seed));
        const Vec2 centre{128.0 + r * std::cos(a) + s * std::cos(b),
                          128.0 + r * std::sin(a) + s * std::sin(b)};
        const double depth = static_cast<double>(k) / count;
        const double sunny = 0.25 * (1.0 - centre.y / kSize);
        const Vec3f colour =
            mixColour(dark, light, 0.65 * depth + sunny + 0.35 * (random01(i, 5, seed) - 0.5));
        drawLeaf(canvas,
                 {centre, kTurn * random01(i, 6, seed), 15.0 + 7.0 * random01(i, 7, seed), 8.0,
                  Vec4f(colour, 1.0f)},
                 false);
    }
    bleedColour(canvas);
    return canvas;
}

Canvas paintPineBranch() {
    constexpr int kSize = 256;
    Canvas canvas(kSize, kSize);
    const auto needles = [&canvas](Vec2 from, Vec2 to, int count, double reach, std::uint32_t seed) {
        drawStroke(canvas, {from, to, 4.0, 1.5, Vec4f(0.20f, 0.14f, 0.09f, 1.0f)});
        const Vec2 along = glm::normalize(to - from);
        const Vec2 side{-along.y, along.x};
        for (int k = 0; k < count; ++k) {
            const auto i = static_cast<std::uint32_t>(k);
            const double t = random01(i, 1, seed);
            const Vec2 root = from + (to - from) * t;
            const double sign = (k & 1) != 0 ? 1.0 : -1.0;
            const Vec2 tip = root + (along * 0.8 + side * sign * (0.5 + 0.7 * random01(i, 2, seed))) * reach *
                                        (1.1 - 0.6 * t);
            const Vec3f colour =
                mixColour(Vec3f(0.06f, 0.13f, 0.07f), Vec3f(0.24f, 0.36f, 0.17f), random01(i, 3, seed));
            drawStroke(canvas,
                       {root, glm::clamp(tip, Vec2(3.0), Vec2(kSize - 4.0)), 2.6, 1.2, Vec4f(colour, 1.0f)});
        }
    };
    for (std::uint32_t twig = 0; twig < 9; ++twig) {
        const double t = 0.06 + 0.1 * twig;
        const double sign = twig % 2 == 0 ? 1.0 : -1.0;
        const Vec2 root{6.0 + 240.0 * t, 128.0};
        const Vec2 tip = root + Vec2(0.75, sign) * (104.0 * (1.0 - 0.72 * t));
        needles(root, glm::clamp(tip, Vec2(6.0), Vec2(kSize - 7.0)), 230, 30.0, 1001u + twig);
    }
    needles({6.0, 128.0}, {246.0, 128.0}, 420, 34.0, 1021u);
    bleedColour(canvas);
    return canvas;
}

Canvas paintGrassTuft() {
    Canvas canvas(128, 128);
    drawBlades(canvas, 46, 1101u);
    clearRows(canvas, 0, 4);
    bleedColour(canvas);
    return canvas;
}

Canvas paintFlowers() {
    Canvas canvas(128, 128);
    drawBlades(canvas, 20, 1201u);
    for (std::uint32_t i = 0; i < 9; ++i) {
        const Vec2 head{18.0 + 92.0 * random01(i, 1, 1203), 20.0 + 50.0 * random01(i, 2, 1203)};
        drawStroke(canvas,
                   {{64.0 + (head.x - 64.0) * 0.4, 127.0}, head, 2.0, 1.4, Vec4f(0.25f, 0.36f, 0.12f, 1.0f)});
        const Vec3f petal = i % 3 == 0   ? Vec3f(0.86f, 0.74f, 0.22f)
                            : i % 3 == 1 ? Vec3f(0.85f, 0.83f, 0.80f)
                                         : Vec3f(0.50f, 0.32f, 0.66f);
        for (int k = 0; k < 6; ++k) {
            const double a = kTurn * k / 6.0;
            drawLeaf(canvas, {head + Vec2(std::cos(a), std::sin(a)) * 4.0, a, 9.0, 5.0, Vec4f(petal, 1.0f)},
                     false);
        }
        drawLeaf(canvas, {head, 0.0, 5.0, 5.0, Vec4f(0.72f, 0.52f, 0.12f, 1.0f)}, false);
    }
    clearRows(canvas, 0, 9);
    bleedColour(canvas);
    return canvas;
}

} // namespace limen::worlds
