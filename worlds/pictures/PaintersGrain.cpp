#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

#include <algorithm>

namespace limen::worlds {

namespace {

constexpr int kGrainSize = 256;

} // namespace

Canvas paintWallGrain() {
    constexpr double kMiddle = 0.2; // alpha, and the mean of the colour: the grain neither lights nor darkens
    return Canvas::paint(kGrainSize, kGrainSize, [](double u, double v) {
        const double rough = 0.75 * fbm(u, v, 24, 24, 3, 2501);
        const Cellular pit = cellular(u, v, 32, 32, 0.9, 2503);
        const double pits = 0.22 * (1.0 - smoothStep(0.08, 0.24, pit.nearest)) * random01(pit.id, 1);
        const double light = std::clamp(kMiddle + 0.16 * rough - pits, 0.0, 1.0);
        return Vec4f(Vec3f(static_cast<float>(light)), static_cast<float>(kMiddle));
    });
}

Canvas paintGroundGrain() {
    return Canvas::paint(kGrainSize, kGrainSize, [](double u, double v) {
        const double tone = fbm(u, v, 40, 40, 3, 2505);
        const Vec3f colour = tone > 0.0 ? Vec3f(0.62f, 0.58f, 0.44f) : Vec3f(0.10f, 0.09f, 0.06f);
        return Vec4f(colour, static_cast<float>(std::clamp(0.55 * std::abs(tone), 0.0, 0.35)));
    });
}

} // namespace limen::worlds
