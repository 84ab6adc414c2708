#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

namespace limen::worlds {

namespace {

constexpr int kWoodSize = 256;

/// The grain of one board, 0 dark .. 1 light: long fibres, slow bands, a few knots.
double grain(double u, double v, std::uint32_t seed) {
    const double warp = 0.06 * gradientNoise(u, v, 3, 5, seed + 9);
    const double bands =
        std::sin(6.2831853 * (v * 9.0 + 3.0 * warp + 1.2 * gradientNoise(u, v, 2, 4, seed + 3)));
    const double fibres = fbm(u, v + warp, 3, 64, 2, seed + 5);
    return 0.5 + 0.16 * bands + 0.45 * fibres;
}

} // namespace

Canvas paintBoards(const BoardStyle& s) {
    return Canvas::paint(kWoodSize, kWoodSize, [&s](double u, double v) {
        const double row = v * s.boards;
        const auto board = static_cast<std::uint32_t>(row);
        const double across = row - std::floor(row);
        const double shifted = u + random01(board, s.seed, 2);
        const double joint = shifted - std::floor(shifted);
        // Two boards in a row: each row has one end joint, at a different place.
        const std::uint32_t piece =
            s.endJoints && joint < 0.5 ? hash(board, s.seed, 7) : hash(board, s.seed, 8);
        const double tone = grain(u, v, s.seed) + 0.34 * (random01(piece, 1) - 0.5);
        Vec3f colour = mixColour(s.dark, s.light, tone);
        const double grey =
            s.weathering * (0.6 + 0.4 * random01(piece, 3)) * (0.8 + fbm(u, v, 4, 8, 3, s.seed + 31));
        colour = mixColour(colour, Vec3f((colour.x + colour.y + colour.z) / 3.0f) * Vec3f(1.02f, 1.0f, 0.94f),
                           grey);
        const double edge = std::min(across, 1.0 - across) / s.boards * kWoodSize;
        double shade = 0.35 + 0.65 * smoothStep(0.2, 2.2, edge);
        if (s.endJoints) {
            const double end = std::min(std::abs(joint - 0.5), std::min(joint, 1.0 - joint)) * kWoodSize;
            shade *= 0.4 + 0.6 * smoothStep(0.2, 1.8, end);
            const double nail =
                std::hypot(end - 7.0, (std::min(across, 1.0 - across) / s.boards * kWoodSize) - 6.0);
            shade *= 0.45 + 0.55 * smoothStep(0.8, 1.9, nail);
        }
        return Vec4f(colour * static_cast<float>(shade), 1.0f);
    });
}

Canvas paintBeam() {
    return Canvas::paint(kWoodSize, kWoodSize, [](double u, double v) {
        const double fibre = fbm(u, v, 2, 40, 3, 401);
        const double cracks = smoothStep(
            0.80, 0.97, ridged(u, v + 0.01 * gradientNoise(u, v, 6, 6, 405), 2, 14, 2, 403) + 0.12);
        const double adze = 0.10 * gradientNoise(u, v, 12, 4, 407);
        const double tone = 0.45 + 0.5 * fibre + adze;
        Vec3f colour = mixColour(Vec3f(0.13f, 0.085f, 0.055f), Vec3f(0.34f, 0.235f, 0.15f), tone);
        colour *= static_cast<float>(1.0 - 0.55 * cracks);
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintBark() {
    return Canvas::paint(kWoodSize, kWoodSize, [](double u, double v) {
        const double warp = 0.04 * fbm(u, v, 4, 3, 3, 511);
        const double plates = ridged(u + warp, v, 10, 3, 3, 513);
        const double fine = fbm(u, v, 24, 8, 3, 515);
        const double moss = smoothStep(0.1, 0.5, fbm(u, v, 2, 2, 4, 517));
        Vec3f colour = mixColour(Vec3f(0.40f, 0.33f, 0.26f), Vec3f(0.13f, 0.10f, 0.075f),
                                 plates * 1.1 - 0.15 + 0.35 * fine);
        colour = mixColour(colour, Vec3f(0.27f, 0.31f, 0.15f), 0.45 * moss * (1.0 - plates));
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintBarrelStaves() {
    // Staves are parallel to v; u goes around. Two iron hoops near each end.
    return Canvas::paint(kWoodSize, kWoodSize, [](double u, double v) {
        const double row = u * 12.0;
        const auto stave = static_cast<std::uint32_t>(row);
        const double across = row - std::floor(row);
        const double tone = 0.5 + 0.45 * fbm(u, v, 60, 3, 2, 611) + 0.3 * (random01(stave, 5) - 0.5);
        Vec3f colour = mixColour(Vec3f(0.27f, 0.17f, 0.09f), Vec3f(0.52f, 0.36f, 0.20f), tone);
        colour *= static_cast<float>(0.5 + 0.5 * smoothStep(0.0, 0.12, std::min(across, 1.0 - across)));
        const double hoop = std::min(std::abs(std::abs(v - 0.5) - 0.20), std::abs(std::abs(v - 0.5) - 0.41));
        if (hoop < 0.026) {
            const double rust = fbm(u, v, 16, 16, 4, 613);
            colour = mixColour(Vec3f(0.20f, 0.20f, 0.21f), Vec3f(0.34f, 0.19f, 0.10f), 0.35 + rust);
            colour *= static_cast<float>(1.15 - 14.0 * hoop);
        } else if (hoop < 0.034) {
            colour *= 0.55f;
        }
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintLogEnds() {
    // A stack of logs seen from the end: rings, bark, dark gaps.
    return Canvas::paint(kWoodSize, kWoodSize, [](double u, double v) {
        const Cellular c = cellular(u, v, 6, 6, 0.16, 711);
        const double radius = 0.45 + 0.06 * random01(c.id, 4);
        const double wobble = c.nearest + 0.03 * fbm(u, v, 12, 12, 2, 713);
        if (wobble > radius)
            return Vec4f(0.05f, 0.04f, 0.03f, 1.0f);
        if (wobble > radius - 0.06)
            return Vec4f(0.22f, 0.17f, 0.12f, 1.0f);
        const double rings = std::sin(wobble * 85.0 + 3.0 * random01(c.id, 6));
        const double tone =
            0.6 + 0.16 * rings + 0.25 * (random01(c.id, 9) - 0.5) + 0.2 * fbm(u, v, 16, 16, 3, 715);
        return Vec4f(mixColour(Vec3f(0.38f, 0.25f, 0.14f), Vec3f(0.74f, 0.58f, 0.38f), tone), 1.0f);
    });
}

} // namespace limen::worlds
