#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

#include <array>

namespace limen::worlds {

namespace {

constexpr int kClothSize = 256;

/// A plain weave: brightness about 1.
float weave(double u, double v, int threads) {
    const double a = std::sin(u * threads * 6.2831853);
    const double b = std::sin(v * threads * 6.2831853);
    return static_cast<float>(0.94 + 0.09 * a * b + 0.05 * fbm(u, v, 64, 64, 2, 903));
}

} // namespace

Canvas paintRug() {
    return Canvas::paint(kClothSize, kClothSize, [](double u, double v) {
        const double x = std::abs(u - 0.5) * 2.0;
        const double y = std::abs(v - 0.5) * 2.0;
        const double border = std::max(x, y);
        const Vec3f red(0.46f, 0.10f, 0.085f);
        const Vec3f blue(0.09f, 0.13f, 0.25f);
        const Vec3f cream(0.70f, 0.60f, 0.42f);
        Vec3f colour = red;
        const double diamond = x + y;
        const double petals = std::abs(std::sin(diamond * 9.0)) * std::cos((x - y) * 9.0);
        if (border > 0.94) {
            colour = std::fmod(std::floor(u * 64.0) + std::floor(v * 64.0), 2.0) < 1.0 ? cream : blue;
        } else if (border > 0.74) {
            const double along = x > y ? v : u;
            const double zig = std::abs(along * 12.0 - std::floor(along * 12.0) - 0.5) * 2.0;
            colour = std::abs((border - 0.84) * 12.0) < 1.0 - zig ? cream : blue;
        } else if (border > 0.70) {
            colour = cream;
        } else if (diamond < 0.28) {
            colour = cream;
        } else if (diamond < 0.38) {
            colour = blue;
        } else if (petals > 0.45) {
            colour = mixColour(blue, cream, petals > 0.75 ? 0.75 : 0.1);
        }
        const double fade = 0.12 * fbm(u, v, 3, 3, 4, 911);
        return Vec4f(mixColour(colour, Vec3f(0.42f, 0.34f, 0.27f), 0.15 + fade) * weave(u, v, 64), 1.0f);
    });
}

Canvas paintBlanket() {
    return Canvas::paint(kClothSize, kClothSize, [](double u, double v) {
        const Vec3f green(0.16f, 0.25f, 0.20f);
        const Vec3f wool(0.58f, 0.50f, 0.36f);
        const Vec3f rust(0.42f, 0.19f, 0.10f);
        const auto stripe = [](double t) {
            const double s = t * 4.0 - std::floor(t * 4.0);
            return s < 0.42 ? 0 : s < 0.52 ? 1 : s < 0.62 ? 2 : s < 0.72 ? 1 : 0;
        };
        const std::array<Vec3f, 3> colours{green, wool, rust};
        const Vec3f mixed =
            (colours[static_cast<std::size_t>(stripe(u))] + colours[static_cast<std::size_t>(stripe(v))]) *
            0.5f;
        return Vec4f(mixed * weave(u, v, 48) * static_cast<float>(1.0 + 0.15 * fbm(u, v, 3, 3, 3, 921)),
                     1.0f);
    });
}

Canvas paintLinen(const Vec3f& colour, int threads) {
    return Canvas::paint(kClothSize, kClothSize, [&](double u, double v) {
        const double folds = fbm(u, v, 3, 2, 4, 931);
        return Vec4f(colour * weave(u, v, threads) * static_cast<float>(1.0 + 0.14 * folds), 1.0f);
    });
}

Canvas paintBooks() {
    // One row of spines; v points down the spine.
    return Canvas::paint(kClothSize, kClothSize, [](double u, double v) {
        const double slot = u * 16.0;
        const auto book = static_cast<std::uint32_t>(slot);
        const double across = slot - std::floor(slot);
        const double top = 0.04 + 0.22 * random01(book, 2, 941);
        if (v < top || across < 0.03)
            return Vec4f(0.05f, 0.035f, 0.025f, 1.0f);
        const std::array<Vec3f, 5> leather{Vec3f(0.38f, 0.15f, 0.10f), Vec3f(0.16f, 0.22f, 0.15f),
                                           Vec3f(0.32f, 0.23f, 0.12f), Vec3f(0.15f, 0.16f, 0.25f),
                                           Vec3f(0.47f, 0.37f, 0.22f)};
        Vec3f colour = leather[hash(book, 5, 941) % leather.size()];
        const double round = 1.0 - 1.6 * (across - 0.5) * (across - 0.5);
        const double t = (v - top) / (1.0 - top);
        const double band = std::min(std::abs(t - 0.2), std::min(std::abs(t - 0.5), std::abs(t - 0.8)));
        if (band < 0.018)
            colour = Vec3f(0.62f, 0.48f, 0.20f);
        return Vec4f(colour * static_cast<float>(round * (1.0 + 0.3 * fbm(u, v, 32, 16, 3, 943))), 1.0f);
    });
}

Canvas paintEmbers() {
    return Canvas::paint(kClothSize, kClothSize, [](double u, double v) {
        const Cellular c = cellular(u, v, 9, 9, 0.9, 951);
        const double crack = 1.0 - smoothStep(0.0, 0.22, c.second - c.nearest);
        const double heat = std::clamp(0.25 + 0.9 * crack + 0.9 * fbm(u, v, 3, 3, 4, 953), 0.0, 1.0);
        Vec3f colour = mixColour(Vec3f(0.09f, 0.06f, 0.05f), Vec3f(0.85f, 0.20f, 0.03f), heat * 1.3);
        colour = mixColour(colour, Vec3f(1.0f, 0.78f, 0.30f), (heat - 0.65) * 2.6);
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintFlame() {
    return Canvas::paint(64, 128, [](double u, double v) {
        const double height = 1.0 - v;
        const double sway = 0.06 * std::sin(height * 7.0) * height;
        const double half = 0.40 * std::sqrt(std::max(0.0, height + 0.02)) * (1.0 - height) * 1.9;
        const double across = std::abs(u - 0.5 - sway) / std::max(half, 1e-6);
        const double body = std::clamp(1.0 - across, 0.0, 1.0);
        const Vec3f colour =
            mixColour(Vec3f(0.95f, 0.34f, 0.05f), Vec3f(1.0f, 0.92f, 0.60f), body * 1.6 - 0.2);
        return Vec4f(colour, static_cast<float>(smoothStep(0.0, 0.6, body)));
    });
}

Canvas paintWater() {
    return Canvas::paint(128, 128, [](double u, double v) {
        const double ripple = fbm(u, v, 4, 8, 4, 961);
        return Vec4f(mixColour(Vec3f(0.03f, 0.05f, 0.055f), Vec3f(0.16f, 0.22f, 0.24f), 0.35 + 0.8 * ripple),
                     1.0f);
    });
}

} // namespace limen::worlds
