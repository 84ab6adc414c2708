#include "worlds/pictures/Noise.h"

#include <algorithm>
#include <array>

namespace limen::worlds {

namespace {

double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

std::uint32_t wrap(int i, int period) {
    const int m = i % period;
    return static_cast<std::uint32_t>(m < 0 ? m + period : m);
}

double gradientAt(int ix, int iy, double dx, double dy, int cellsU, int cellsV, std::uint32_t seed) {
    constexpr double kDiagonal = 0.70710678118654752;
    constexpr std::array<Vec2, 8> kDirections{Vec2{1, 0},
                                              Vec2{-1, 0},
                                              Vec2{0, 1},
                                              Vec2{0, -1},
                                              Vec2{kDiagonal, kDiagonal},
                                              Vec2{-kDiagonal, kDiagonal},
                                              Vec2{kDiagonal, -kDiagonal},
                                              Vec2{-kDiagonal, -kDiagonal}};
    const Vec2 g = kDirections[hash(wrap(ix, cellsU), wrap(iy, cellsV), seed) & 7u];
    return g.x * dx + g.y * dy;
}

} // namespace

std::uint32_t hash(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t h = a * 0x9E3779B1u ^ (b + 0x7F4A7C15u) * 0x85EBCA77u ^ (c + 0x165667B1u) * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}

double random01(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return static_cast<double>(hash(a, b, c)) * (1.0 / 4294967296.0);
}

double gradientNoise(double u, double v, int cellsU, int cellsV, std::uint32_t seed) {
    const double x = u * cellsU;
    const double y = v * cellsV;
    const int ix = static_cast<int>(std::floor(x));
    const int iy = static_cast<int>(std::floor(y));
    const double fx = x - ix;
    const double fy = y - iy;
    const double a = gradientAt(ix, iy, fx, fy, cellsU, cellsV, seed);
    const double b = gradientAt(ix + 1, iy, fx - 1.0, fy, cellsU, cellsV, seed);
    const double c = gradientAt(ix, iy + 1, fx, fy - 1.0, cellsU, cellsV, seed);
    const double d = gradientAt(ix + 1, iy + 1, fx - 1.0, fy - 1.0, cellsU, cellsV, seed);
    const double bottom = a + (b - a) * fade(fx);
    const double top = c + (d - c) * fade(fx);
    return 1.5 * (bottom + (top - bottom) * fade(fy));
}

double fbm(double u, double v, int cellsU, int cellsV, int octaves, std::uint32_t seed) {
    double sum = 0.0;
    double weight = 0.5;
    for (int o = 0; o < octaves; ++o) {
        sum += weight *
               gradientNoise(u, v, cellsU << o, cellsV << o, seed + static_cast<std::uint32_t>(o) * 101u);
        weight *= 0.5;
    }
    return sum;
}

double ridged(double u, double v, int cellsU, int cellsV, int octaves, std::uint32_t seed) {
    double sum = 0.0;
    double weight = 0.5;
    for (int o = 0; o < octaves; ++o) {
        const std::uint32_t s = seed + static_cast<std::uint32_t>(o) * 131u;
        sum +=
            weight * (1.0 - std::min(1.0, std::abs(gradientNoise(u, v, cellsU << o, cellsV << o, s)) * 2.0));
        weight *= 0.5;
    }
    return sum;
}

Cellular cellular(double u, double v, int cellsU, int cellsV, double jitter, std::uint32_t seed) {
    const double x = u * cellsU;
    const double y = v * cellsV;
    const int ix = static_cast<int>(std::floor(x));
    const int iy = static_cast<int>(std::floor(y));
    Cellular out{1e9, 1e9, 0};
    for (int j = iy - 1; j <= iy + 1; ++j) {
        for (int i = ix - 1; i <= ix + 1; ++i) {
            const std::uint32_t id = hash(wrap(i, cellsU), wrap(j, cellsV), seed);
            const double px = i + 0.5 + jitter * (random01(id, 1) - 0.5);
            const double py = j + 0.5 + jitter * (random01(id, 2) - 0.5);
            const double distance = std::hypot(px - x, py - y);
            if (distance < out.nearest) {
                out.second = out.nearest;
                out.nearest = distance;
                out.id = id;
            } else {
                out.second = std::min(out.second, distance);
            }
        }
    }
    return out;
}

double smoothStep(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace limen::worlds
