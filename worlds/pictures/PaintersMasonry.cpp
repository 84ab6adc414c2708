#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

#include <array>

namespace limen::worlds {

namespace {

constexpr int kMasonrySize = 256;

/// A point in courses of blocks: its block, and its distance (in course heights) from the joint around it.
struct BlockHit {
    std::uint32_t id = 0;
    double edge = 0.0;
    double across = 0.0, along = 0.0; ///< 0..1 inside the block
};

/// `courses` rows with `perCourse` blocks each on average; every other row is shifted, lengths vary by
/// `unevenness`.
BlockHit courseBlock(double u, double v, int courses, int perCourse, double unevenness, std::uint32_t seed) {
    const double row = v * courses;
    const auto course = static_cast<std::uint32_t>(row);
    const double across = row - std::floor(row);
    const double shift = (course % 2u) * 0.5 + unevenness * random01(course, seed, 1);
    double along = u * perCourse + shift;
    const int block = static_cast<int>(std::floor(along));
    const auto joint = [&](int k) {
        const auto wrapped = static_cast<std::uint32_t>(((k % perCourse) + perCourse) % perCourse);
        return k + unevenness * (random01(wrapped, course, seed) - 0.5);
    };
    int k = block;
    if (along < joint(k))
        --k;
    else if (along >= joint(k + 1))
        ++k;
    const double left = joint(k);
    const double right = joint(k + 1);
    const double aspect = static_cast<double>(courses) / perCourse;
    BlockHit hit;
    hit.id = hash(static_cast<std::uint32_t>(((k % perCourse) + perCourse) % perCourse), course, seed + 77);
    hit.across = across;
    hit.along = (along - left) / (right - left);
    hit.edge = std::min(std::min(across, 1.0 - across), std::min(along - left, right - along) * aspect);
    return hit;
}

} // namespace

Canvas paintPlaster(Vec3f base, double stains, std::uint32_t seed) {
    return Canvas::paint(kMasonrySize, kMasonrySize, [=](double u, double v) {
        const double clouds = fbm(u, v, 2, 2, 5, seed);
        const double trowel =
            gradientNoise(u + 0.03 * gradientNoise(u, v, 5, 5, seed + 3), v, 9, 14, seed + 5);
        const double grit = fbm(u, v, 64, 64, 2, seed + 7);
        const double crack = smoothStep(0.905, 0.935, ridged(u, v, 3, 3, 3, seed + 11) + 0.08);
        Vec3f colour = base * static_cast<float>(1.0 + 0.07 * clouds + 0.035 * trowel + 0.05 * grit);
        colour = mixColour(colour, base * Vec3f(0.80f, 0.70f, 0.55f),
                           stains * smoothStep(0.05, 0.5, fbm(u, v, 3, 2, 4, seed + 13)));
        colour *= static_cast<float>(1.0 - 0.16 * crack * stains);
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintStoneWall() {
    const auto height = [](double u, double v) {
        const double wu = u + 0.018 * fbm(u, v, 6, 6, 3, 821);
        const double wv = v + 0.018 * fbm(u, v, 6, 6, 3, 823);
        const Cellular c = cellular(wu, wv, 6, 9, 0.72, 825);
        const double face = smoothStep(0.03, 0.20, c.second - c.nearest);
        return face * (0.8 + 0.2 * random01(c.id, 3)) + 0.16 * fbm(u, v, 14, 14, 4, 827);
    };
    return Canvas::paint(kMasonrySize, kMasonrySize, [&height](double u, double v) {
        const double wu = u + 0.018 * fbm(u, v, 6, 6, 3, 821);
        const double wv = v + 0.018 * fbm(u, v, 6, 6, 3, 823);
        const Cellular c = cellular(wu, wv, 6, 9, 0.72, 825);
        const double joint = smoothStep(0.03, 0.12, c.second - c.nearest);
        const double hue = random01(c.id, 5);
        const Vec3f stone = mixColour(mixColour(Vec3f(0.47f, 0.45f, 0.42f), Vec3f(0.56f, 0.50f, 0.41f), hue),
                                      Vec3f(0.37f, 0.37f, 0.38f), random01(c.id, 6) * 0.8);
        const double relief = (height(u, v) - height(u + 0.006, v + 0.008)) * 1.9;
        Vec3f colour = mixColour(Vec3f(0.30f, 0.28f, 0.245f), stone, joint);
        colour *=
            static_cast<float>(0.93 + 0.26 * fbm(u, v, 16, 16, 4, 829) - std::clamp(relief, -0.35, 0.35));
        colour = mixColour(colour, Vec3f(0.30f, 0.34f, 0.18f),
                           0.4 * smoothStep(0.15, 0.5, fbm(u, v, 3, 3, 4, 831)) * (1.2 - joint));
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintFlagstones() {
    return Canvas::paint(kMasonrySize, kMasonrySize, [](double u, double v) {
        const double wu = u + 0.006 * fbm(u, v, 8, 8, 3, 841);
        const double wv = v + 0.006 * fbm(u, v, 8, 8, 3, 843);
        const BlockHit b = courseBlock(wu, wv - std::floor(wv), 4, 3, 0.45, 845);
        const double face = smoothStep(0.02, 0.07, b.edge);
        const Vec3f stone =
            mixColour(Vec3f(0.42f, 0.41f, 0.385f), Vec3f(0.50f, 0.455f, 0.385f), random01(b.id, 1));
        const double worn = 0.95 + 0.18 * (random01(b.id, 2) - 0.5) + 0.22 * fbm(u, v, 8, 8, 5, 847);
        const double bevel = 1.0 - 0.22 * (1.0 - smoothStep(0.05, 0.16, b.edge));
        Vec3f colour = stone * static_cast<float>(worn * bevel);
        colour = mixColour(Vec3f(0.17f, 0.155f, 0.13f), colour, face);
        return Vec4f(colour, 1.0f);
    });
}

Canvas paintBricks() {
    return Canvas::paint(kMasonrySize, kMasonrySize, [](double u, double v) {
        const BlockHit b = courseBlock(u + 0.003 * fbm(u, v, 16, 16, 2, 861), v, 12, 4, 0.06, 865);
        const double face = smoothStep(0.06, 0.14, b.edge + 0.05 * fbm(u, v, 32, 32, 2, 867));
        Vec3f brick = mixColour(Vec3f(0.50f, 0.25f, 0.17f), Vec3f(0.36f, 0.17f, 0.125f), random01(b.id, 1));
        brick = mixColour(brick, Vec3f(0.24f, 0.16f, 0.14f), random01(b.id, 2) > 0.8 ? 0.6 : 0.0);
        brick *=
            static_cast<float>(0.95 + 0.32 * fbm(u, v, 24, 24, 4, 869) + (b.across < 0.3 ? 0.06 : -0.04));
        return Vec4f(mixColour(Vec3f(0.46f, 0.42f, 0.36f), brick, face), 1.0f);
    });
}

Canvas paintThatch() {
    Canvas canvas = Canvas::paint(kMasonrySize, kMasonrySize, [](double u, double v) {
        const double tone = 0.5 + 0.5 * fbm(u, v, 48, 4, 3, 881);
        return Vec4f(mixColour(Vec3f(0.24f, 0.185f, 0.10f), Vec3f(0.45f, 0.36f, 0.20f), tone), 1.0f);
    });
    for (std::uint32_t i = 0; i < 5200; ++i) {
        // Bundles overlap in four bands; each stalk begins at its band and points down.
        const double band = std::floor(random01(i, 3, 883) * 4.0) * (kMasonrySize / 4.0);
        const double x = random01(i, 1, 883) * kMasonrySize;
        const double y = band + 10.0 * random01(i, 2, 883);
        const double length = 26.0 + 34.0 * random01(i, 4, 883);
        const double tone = random01(i, 5, 883);
        const double grey = random01(i, 6, 883);
        Vec3f colour = mixColour(Vec3f(0.30f, 0.225f, 0.115f), Vec3f(0.66f, 0.54f, 0.31f), tone * tone);
        colour = mixColour(colour, Vec3f(0.42f, 0.40f, 0.35f), grey * 0.55);
        drawStroke(
            canvas,
            {{x, y}, {x + 8.0 * (random01(i, 7, 883) - 0.5), y + length}, 1.5, 0.5, Vec4f(colour, 0.75f)});
    }
    for (int y = 0; y < kMasonrySize; ++y) {
        for (int x = 0; x < kMasonrySize; ++x) {
            const double u = (x + 0.5) / kMasonrySize;
            const double v = (y + 0.5) / kMasonrySize;
            const double ragged = v * 4.0 + 0.10 * fbm(u, v, 20, 4, 2, 885);
            const double within = ragged - std::floor(ragged);
            const double shade =
                0.66 + 0.34 * smoothStep(0.0, 0.35, within) - 0.10 * smoothStep(0.9, 1.0, within);
            const double moss = 0.35 * smoothStep(0.12, 0.5, fbm(u, v, 2, 2, 5, 887));
            const Vec3f c = Vec3f(canvas.at(x, y)) * static_cast<float>(shade);
            canvas.at(x, y) = Vec4f(mixColour(c, c * Vec3f(0.70f, 0.86f, 0.50f), moss), 1.0f);
        }
    }
    return canvas;
}

Canvas paintRock(int size) {
    const auto height = [](double u, double v) {
        return 0.6 * ridged(u + 0.03 * fbm(u, v, 3, 3, 3, 891), v, 3, 4, 5, 893) +
               0.35 * fbm(u, v, 6, 6, 5, 895);
    };
    return Canvas::paint(size, size, [&height](double u, double v) {
        const double h = height(u, v);
        const double relief = std::clamp((h - height(u + 0.005, v + 0.007)) * 4.0, -0.35, 0.35);
        Vec3f colour = mixColour(Vec3f(0.33f, 0.32f, 0.31f), Vec3f(0.55f, 0.52f, 0.47f), h);
        colour *= static_cast<float>(0.95 - relief);
        colour = mixColour(colour, Vec3f(0.36f, 0.38f, 0.22f),
                           0.55 * smoothStep(0.12, 0.45, fbm(u, v, 4, 4, 4, 897)));
        return Vec4f(colour, 1.0f);
    });
}

} // namespace limen::worlds
