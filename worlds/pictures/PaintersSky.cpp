#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

namespace limen::worlds {

namespace {

/// 0 at the zenith, 1 at the horizon, above 1 below the horizon.
double descent(double v) {
    return v / kHorizonV;
}

} // namespace

Canvas paintDaySky() {
    return Canvas::paint(64, 256, [](double u, double v) {
        const double t = descent(v);
        Vec3f colour =
            mixColour(Vec3f(0.17f, 0.36f, 0.69f), Vec3f(0.45f, 0.65f, 0.86f), smoothStep(0.0, 0.85, t));
        colour = mixColour(colour, Vec3f(0.80f, 0.86f, 0.90f), smoothStep(0.62, 1.0, t));
        colour = mixColour(colour, Vec3f(0.62f, 0.68f, 0.70f), smoothStep(1.0, 1.25, t));
        // Weak noise hides banding.
        return Vec4f(colour + Vec3f(static_cast<float>(0.006 * gradientNoise(u, v, 32, 128, 2001))), 1.0f);
    });
}

Canvas paintNightSky() {
    Canvas canvas = Canvas::paint(1024, 512, [](double u, double v) {
        const double t = descent(v);
        Vec3f colour =
            mixColour(Vec3f(0.012f, 0.018f, 0.05f), Vec3f(0.055f, 0.075f, 0.13f), smoothStep(0.1, 1.0, t));
        const double band = std::exp(-std::pow((v - 0.42 - 0.18 * std::sin(u * 6.2831853)) / 0.09, 2.0));
        colour += Vec3f(0.10f, 0.10f, 0.13f) *
                  static_cast<float>(band * std::max(0.0, 0.45 + fbm(u, v, 12, 6, 5, 2011)));
        return Vec4f(colour, 1.0f);
    });
    for (std::uint32_t i = 0; i < 900; ++i) {
        const double v = std::pow(random01(i, 2, 2013), 0.7) * kHorizonV;
        const Vec2 at{random01(i, 1, 2013) * 1024.0, v * 512.0};
        const double bright = 0.25 + 0.75 * std::pow(random01(i, 3, 2013), 6.0);
        const Vec3f tint =
            mixColour(Vec3f(1.0f, 0.87f, 0.72f), Vec3f(0.78f, 0.86f, 1.0f), random01(i, 4, 2013));
        drawStroke(canvas, {at, at + Vec2(0.01), 0.5 + 0.8 * bright, 0.5 + 0.8 * bright,
                            Vec4f(tint, static_cast<float>(bright))});
    }
    return canvas;
}

Canvas paintDuskSky() {
    return Canvas::paint(64, 256, [](double u, double v) {
        const double t = descent(v);
        Vec3f colour =
            mixColour(Vec3f(0.36f, 0.27f, 0.45f), Vec3f(0.93f, 0.46f, 0.24f), smoothStep(0.45, 0.92, t));
        colour = mixColour(colour, Vec3f(1.0f, 0.74f, 0.42f), smoothStep(0.88, 1.0, t));
        colour = mixColour(colour, Vec3f(0.38f, 0.30f, 0.31f), smoothStep(1.0, 1.2, t));
        const double alpha = smoothStep(0.25, 0.95, t) + 0.004 * gradientNoise(u, v, 32, 128, 2021);
        return Vec4f(colour, static_cast<float>(std::clamp(alpha, 0.0, 1.0)));
    });
}

Canvas paintSnowSky() {
    return Canvas::paint(256, 256, [](double u, double v) {
        const double t = descent(v);
        Vec3f colour =
            mixColour(Vec3f(0.42f, 0.45f, 0.49f), Vec3f(0.61f, 0.63f, 0.66f), smoothStep(0.1, 1.0, t));
        const double bulges = fbm(u, v, 6, 3, 5, 2061) * (1.0 - smoothStep(0.55, 0.95, t));
        return Vec4f(colour * static_cast<float>(1.0 + 0.16 * bulges), 1.0f);
    });
}

Canvas paintRain() {
    constexpr std::uint32_t kSize = 256, kStreaks = 70;
    Canvas canvas(kSize, kSize, Vec4f(0.86f, 0.90f, 0.96f, 0.0f));
    for (std::uint32_t i = 0; i < kStreaks; ++i) {
        const double x = 2.0 + random01(i, 1, 2071) * (kSize - 4.0);
        const double length = 26.0 + 46.0 * random01(i, 2, 2071);
        const double y = random01(i, 3, 2071) * kSize;
        const auto strength = static_cast<float>(0.2 + 0.4 * random01(i, 4, 2071));
        // Strokes continue at the other side: the picture repeats.
        drawStroke(canvas,
                   {Vec2(x, y), Vec2(x, y + length), 0.35, 0.7, Vec4f(0.86f, 0.90f, 0.96f, strength)});
    }
    return canvas;
}

Canvas paintSun() {
    return Canvas::paint(128, 128, [](double u, double v) {
        const double r = std::hypot(u - 0.5, v - 0.5) * 2.0;
        const double disc = 1.0 - smoothStep(0.16, 0.24, r);
        const double glow = 0.75 * std::pow(std::max(0.0, 1.0 - r), 2.4);
        return Vec4f(1.0f, 1.0f, 1.0f, static_cast<float>(std::clamp(disc + glow, 0.0, 1.0)));
    });
}

Canvas paintMoon() {
    return Canvas::paint(128, 128, [](double u, double v) {
        const double x = (u - 0.5) * 2.0;
        const double y = (v - 0.5) * 2.0;
        const double r = std::hypot(x, y);
        const double seas = smoothStep(0.0, 0.35, fbm(u, v, 3, 3, 5, 2031));
        const Vec3f colour = mixColour(Vec3f(0.93f, 0.92f, 0.86f), Vec3f(0.66f, 0.66f, 0.64f), seas * 0.8);
        return Vec4f(colour * static_cast<float>(1.0 - 0.25 * r * r),
                     static_cast<float>(1.0 - smoothStep(0.84, 0.9, r)));
    });
}

Canvas paintClouds() {
    return Canvas::paint(512, 512, [](double u, double v) {
        const double wu = u + 0.03 * fbm(u, v, 4, 4, 3, 2041);
        const double shape = fbm(wu, v, 3, 3, 6, 2043);
        const double thin = fbm(u, v, 5, 5, 4, 2045);
        const double cover = smoothStep(-0.06, 0.36, shape) * (0.75 + 0.25 * thin);
        // Light from one side: compare the cover with that a step towards the light.
        const double towards = fbm(wu + 0.02, v + 0.02, 3, 3, 5, 2043);
        const double light = std::clamp(0.86 + 0.9 * (shape - towards), 0.62, 1.0);
        return Vec4f(Vec3f(1.0f, 0.995f, 0.98f) * static_cast<float>(light),
                     static_cast<float>(std::clamp(cover, 0.0, 1.0) * 0.92));
    });
}

} // namespace limen::worlds
