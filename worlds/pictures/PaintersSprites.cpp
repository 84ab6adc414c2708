#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

namespace limen::worlds {

namespace {

constexpr int kSpriteSize = 128;

/// 1 in the middle of the picture, 0 from the nearest points of the border outwards.
double disc(double u, double v) {
    return std::clamp(1.0 - 2.0 * std::hypot(u - 0.5, v - 0.5), 0.0, 1.0);
}

Vec4f withAlpha(const Vec3f& colour, double alpha) {
    return Vec4f(colour, static_cast<float>(std::clamp(alpha, 0.0, 1.0)));
}

} // namespace

Canvas paintGlass() {
    return Canvas::paint(kSpriteSize, kSpriteSize, [](double u, double v) {
        // Two families of lead strips, three diamonds across.
        const auto strip = [](double t) { return std::abs(3.0 * t - std::round(3.0 * t)); };
        const double lead = std::min(strip(u + v), strip(u - v));
        const double hidden = 1.0 - smoothStep(0.035, 0.055, lead);
        const auto pane = hash(static_cast<std::uint32_t>(std::floor(3.0 * (u + v)) + 8.0) % 3,
                               static_cast<std::uint32_t>(std::floor(3.0 * (u - v)) + 9.0) % 3, 3101);
        const auto tint = static_cast<float>(0.85 + 0.3 * random01(pane, 1));
        const Vec3f glass = Vec3f(0.58f, 0.66f, 0.60f) * tint;
        const double ripple = 0.5 + 0.5 * fbm(u, v, 4, 4, 3, 3103);
        const double clear = 0.12 + 0.10 * random01(pane, 2) + 0.08 * ripple;
        return withAlpha(glass + (Vec3f(0.13f, 0.13f, 0.14f) - glass) * static_cast<float>(hidden),
                         clear + (0.95 - clear) * hidden);
    });
}

Canvas paintShadow() {
    constexpr int kSize = 64; // it has no detail
    return Canvas::paint(kSize, kSize, [](double u, double v) {
        return withAlpha(Vec3f(0.02f, 0.02f, 0.03f), 0.62 * smoothStep(0.0, 0.85, disc(u, v)));
    });
}

Canvas paintSmoke() {
    return Canvas::paint(kSpriteSize, kSpriteSize, [](double u, double v) {
        const double cloud = 0.62 + 0.55 * fbm(u, v, 4, 4, 4, 3111);
        const auto shade = static_cast<float>(0.62 + 0.16 * fbm(u, v, 3, 3, 3, 3113));
        return withAlpha(Vec3f(shade, shade, shade * 0.98f), smoothStep(0.0, 0.9, disc(u, v)) * cloud);
    });
}

Canvas paintFire() {
    return Canvas::paint(kSpriteSize, kSpriteSize, [](double u, double v) {
        // A flame: round below, narrow above, with a noisy edge.
        const double height = 1.0 - v;
        const double half = 0.34 * std::pow(std::max(0.0, 1.0 - height), 0.7) + 0.02;
        const double sway = 0.07 * fbm(u, v, 2, 3, 2, 3121);
        const double across = std::abs(u - 0.5 - sway) / half;
        const double body = std::clamp(1.0 - across, 0.0, 1.0) * smoothStep(0.0, 0.22, height) *
                            smoothStep(0.0, 0.3, disc(u, v));
        const Vec3f colour = Vec3f(0.95f, 0.30f, 0.05f) +
                             Vec3f(0.05f, 0.55f, 0.40f) * static_cast<float>(smoothStep(0.2, 0.9, body));
        return withAlpha(colour, smoothStep(0.0, 0.7, body) * (0.8 + 0.3 * fbm(u, v, 5, 5, 3, 3123)));
    });
}

Canvas paintFirefly() {
    return Canvas::paint(kSpriteSize, kSpriteSize, [](double u, double v) {
        const double d = disc(u, v);
        const double core = smoothStep(0.78, 0.92, d);
        return withAlpha(Vec3f(0.72f, 0.95f, 0.35f) + Vec3f(0.25f, 0.05f, 0.5f) * static_cast<float>(core),
                         0.55 * d * d * d + core);
    });
}

Canvas paintSnowflake() {
    return Canvas::paint(32, 32, [](double u, double v) {
        const double d = disc(u, v);
        return withAlpha(Vec3f(0.97f, 0.98f, 1.0f), smoothStep(0.0, 0.55, d));
    });
}

Canvas paintSwirl() {
    return Canvas::paint(kSpriteSize, kSpriteSize, [](double u, double v) {
        const double d = disc(u, v);
        const double angle = std::atan2(v - 0.5, u - 0.5);
        const double arms = 0.5 + 0.5 * std::cos(3.0 * angle + 11.0 * d);
        const double glow = smoothStep(0.0, 0.5, d) * (0.25 + 0.75 * arms * arms);
        return withAlpha(Vec3f(0.42f, 0.36f, 0.95f) + Vec3f(0.4f, 0.5f, 0.05f) * static_cast<float>(d * d),
                         glow);
    });
}

} // namespace limen::worlds
