#include "worlds/pictures/Noise.h"
#include "worlds/pictures/Painters.h"

namespace limen::worlds {

namespace {

constexpr int kGroundSize = 512;

/// Small stones scattered on bare ground, lit from the upper left.
Vec3f withPebbles(Vec3f ground, double u, double v, int cells, double share, std::uint32_t seed) {
    const Cellular c = cellular(u, v, cells, cells, 0.9, seed);
    const double radius = 0.12 + 0.22 * random01(c.id, 2);
    if (random01(c.id, 1) > share || c.nearest > radius)
        return ground;
    const Vec3f stone = mixColour(Vec3f(0.36f, 0.33f, 0.29f), Vec3f(0.52f, 0.47f, 0.39f), random01(c.id, 3));
    return stone * static_cast<float>(1.06 - 0.28 * (c.nearest / radius) * (c.nearest / radius));
}

} // namespace

Canvas paintGrass(const GrassStyle& s) {
    const auto cover = [&s](double u, double v) {
        return fbm(u, v, 4, 4, 5, s.seed + 1) + 0.5 - 1.1 * s.bare;
    };
    Canvas canvas = Canvas::paint(kGroundSize, kGroundSize, [&](double u, double v) {
        const double tone = 0.35 + 0.6 * fbm(u, v, 8, 8, 5, s.seed + 3);
        const Vec3f green = mixColour(s.dark, s.light, tone * 0.8);
        const Vec3f bare =
            withPebbles(s.earth * static_cast<float>(1.0 + 0.4 * fbm(u, v, 16, 16, 4, s.seed + 5)), u, v, 40,
                        0.25, s.seed + 7);
        return Vec4f(mixColour(bare, green, smoothStep(-0.12, 0.12, cover(u, v))), 1.0f);
    });
    for (std::uint32_t i = 0; i < 15000; ++i) {
        const double x = random01(i, 1, s.seed) * kGroundSize;
        const double y = random01(i, 2, s.seed) * kGroundSize;
        if (cover(x / kGroundSize, y / kGroundSize) < 0.06 * (random01(i, 3, s.seed) - 0.5))
            continue;
        const double patch = 0.3 * fbm(x / kGroundSize, y / kGroundSize, 3, 3, 3, s.seed + 9);
        const double angle = 6.2831853 * random01(i, 4, s.seed);
        const double length = 5.0 + 9.0 * random01(i, 5, s.seed);
        const Vec3f colour = mixColour(s.dark, s.light, random01(i, 6, s.seed) * 1.05 + patch);
        drawStroke(canvas, {{x, y},
                            {x + length * std::cos(angle), y + length * std::sin(angle)},
                            1.9,
                            0.6,
                            Vec4f(colour, 0.8f)});
    }
    return canvas;
}

Canvas paintDirt() {
    return Canvas::paint(kGroundSize, kGroundSize, [](double u, double v) {
        const double tone = 0.5 + 0.6 * fbm(u, v, 4, 4, 6, 1301);
        const Vec3f earth = mixColour(Vec3f(0.29f, 0.22f, 0.145f), Vec3f(0.47f, 0.38f, 0.265f), tone);
        return Vec4f(withPebbles(withPebbles(earth, u, v, 48, 0.16, 1303), u, v, 90, 0.22, 1305), 1.0f);
    });
}

Canvas paintForestFloor() {
    Canvas canvas = Canvas::paint(kGroundSize, kGroundSize, [](double u, double v) {
        const double tone = 0.5 + 0.7 * fbm(u, v, 6, 6, 6, 1401);
        const double moss = smoothStep(-0.25, 0.2, fbm(u, v, 3, 3, 5, 1403));
        const Vec3f soil = mixColour(Vec3f(0.125f, 0.12f, 0.06f), Vec3f(0.23f, 0.215f, 0.105f), tone);
        return Vec4f(mixColour(soil, Vec3f(0.165f, 0.235f, 0.075f), 0.85 * moss), 1.0f);
    });
    for (std::uint32_t i = 0; i < 2800; ++i) {
        const Vec2 centre{random01(i, 1, 1405) * kGroundSize, random01(i, 2, 1405) * kGroundSize};
        const double hue = random01(i, 3, 1405);
        Vec3f colour =
            mixColour(Vec3f(0.20f, 0.16f, 0.08f), Vec3f(0.34f, 0.28f, 0.13f), random01(i, 4, 1405));
        if (hue > 0.35)
            colour = mixColour(Vec3f(0.17f, 0.22f, 0.07f), Vec3f(0.27f, 0.33f, 0.11f), random01(i, 7, 1405));
        const double size = 8.0 + 8.0 * random01(i, 5, 1405);
        drawLeaf(canvas, {centre, 6.2831853 * random01(i, 6, 1405), size, size * 0.5, Vec4f(colour, 0.85f)},
                 true);
    }
    for (std::uint32_t i = 0; i < 160; ++i) {
        const Vec2 from{random01(i, 1, 1407) * kGroundSize, random01(i, 2, 1407) * kGroundSize};
        const double a = 6.2831853 * random01(i, 3, 1407);
        const double length = 15.0 + 40.0 * random01(i, 4, 1407);
        drawStroke(canvas, {from, from + Vec2(std::cos(a), std::sin(a)) * length, 2.6, 1.2,
                            Vec4f(0.20f, 0.14f, 0.09f, 0.9f)});
    }
    return canvas;
}

Canvas paintStream() {
    // One repeat covers a landcell, so that no repetition shows from a hill.
    return Canvas::paint(kGroundSize, kGroundSize, [](double u, double v) {
        const double depth = 0.5 + 0.6 * fbm(u, v, 4, 4, 5, 1601);
        Vec3f water = mixColour(Vec3f(0.13f, 0.20f, 0.20f), Vec3f(0.20f, 0.285f, 0.27f), depth);
        // Slower noise moves the crests. The sky's reflection is brightest where two crests meet.
        const double wander = 0.02 * fbm(u, v, 10, 10, 3, 1603);
        const double crest = ridged(u + wander, v - wander, 26, 26, 3, 1605);
        const double sky = smoothStep(0.62, 0.95, crest);
        water = mixColour(water, Vec3f(0.46f, 0.54f, 0.56f), 0.4 * sky);
        return Vec4f(water * static_cast<float>(0.95 + 0.10 * crest), 1.0f);
    });
}

Canvas paintRoad() {
    // The picture lies the same way under lanes of every direction: it has no direction of its own.
    Canvas canvas = Canvas::paint(kGroundSize, kGroundSize, [](double u, double v) {
        const double tone = 0.5 + 0.5 * fbm(u, v, 6, 6, 6, 1501);
        Vec3f earth = mixColour(Vec3f(0.36f, 0.28f, 0.19f), Vec3f(0.55f, 0.455f, 0.325f), tone);
        earth = withPebbles(withPebbles(earth, u, v, 40, 0.3, 1503), u, v, 84, 0.3, 1505);
        const double worn = smoothStep(-0.1, 0.35, fbm(u, v, 3, 3, 4, 1507));
        return Vec4f(earth * static_cast<float>(1.04 - 0.16 * worn), 1.0f);
    });
    for (std::uint32_t i = 0; i < 900; ++i) {
        const double x = kGroundSize * random01(i, 1, 1509), y = kGroundSize * random01(i, 2, 1509);
        if (fbm(x / kGroundSize, y / kGroundSize, 5, 5, 3, 1511) < 0.2)
            continue;
        const double a = 6.2831853 * random01(i, 3, 1509);
        const Vec3f colour =
            mixColour(Vec3f(0.24f, 0.28f, 0.11f), Vec3f(0.45f, 0.45f, 0.21f), random01(i, 4, 1509));
        drawStroke(canvas,
                   {{x, y}, {x + 7.0 * std::cos(a), y + 7.0 * std::sin(a)}, 1.8, 0.7, Vec4f(colour, 0.7f)});
    }
    return canvas;
}

namespace {

constexpr std::uint32_t kCrownSeed = 1513;

/// The share of a lane that its grassy crown covers, between the wheel tracks. `fromMiddle`: shares of a landcell from the
/// middle; `toEnd`: from the nearer end of the lane in this landcell. Lanes bend at the ends, so the crown stops there.
/// In the middle the crown depends on `toEnd` alone: there two landcells meet, each with a picture turned its own way.
double crownOf(double fromMiddle, double toEnd, double u, double v, std::uint32_t seed) {
    const double strip = 1.0 - smoothStep(0.010, 0.032, fromMiddle + 0.012 * fbm(u, v, 12, 12, 3, seed + 1));
    const double shared = fbm(0.0, toEnd, 14, 14, 3, kCrownSeed), own = fbm(u, v, 7, 7, 3, seed + 2);
    const double patch =
        smoothStep(-0.22, 0.12, shared + (own - shared) * smoothStep(0.004, 0.03, fromMiddle));
    return 0.8 * strip * patch * smoothStep(0.01, 0.10, toEnd);
}

/// Shares of a landcell by which the border of two grounds sways, so that it does not follow the grid. It is 0 at the landcell's
/// borders. Corners are cut: a line of corners then runs straight, not in steps. `u`, `v`: as in paintBlend.
double swayOf(BlendShape shape, double u, double v, std::uint32_t seed) {
    constexpr double kTurn = 6.283185307179586;
    const double vary = 2.0 * random01(seed, 1, 1701) - 1.0;
    if (shape == BlendShape::Corner) {
        const double across = std::sin(2.0 * std::atan2(v, u));
        return (0.10 + 0.03 * vary) * across * across;
    }
    const double once = 1.0 - std::cos(kTurn * v), twice = std::sin(kTurn * v) * std::sin(0.5 * kTurn * v);
    return 0.03 * vary * once + 0.055 * (random01(seed, 2, 1701) < 0.5 ? twice : -twice);
}

} // namespace

Canvas paintBlend(BlendShape shape, std::uint32_t seed) {
    // North is up: v = 0 is the north edge. The overlay shows where alpha is 0.
    return Canvas::paint(256, 256, [=](double u, double v) {
        const bool road = shape >= BlendShape::RoadCorner;
        const double reach = road ? 0.125 : 0.5;
        const double soft = road ? 0.035 : 0.10;
        const double rough = road ? 0.045 : 0.18;
        double distance = 0.0, crown = 0.0;
        switch (shape) {
        case BlendShape::RoadCorner:
            distance = (u + v) * 0.70710678;
            break;
        case BlendShape::Corner:
            distance = std::hypot(u, v) + swayOf(shape, u, v, seed);
            break;
        case BlendShape::Side:
            distance = u + swayOf(shape, u, v, seed);
            break;
        case BlendShape::RoadSide:
            distance = u;
            crown = crownOf(distance, std::min(v, 1.0 - v), u, v, seed);
            break;
        case BlendShape::RoadDiagonal:
            distance = std::abs(u - v) * 0.70710678;
            crown = crownOf(distance, std::min({u, v, 1.0 - u, 1.0 - v}), u, v, seed);
            break;
        }
        // The edge gets smooth towards the cell's borders, so that neighbouring cells match.
        const double calm = std::min(1.0, 8.0 * std::min({u, v, 1.0 - u, 1.0 - v}));
        distance += rough * calm * fbm(u, v, 5, 5, road ? 5 : 4, seed);
        const double edge = smoothStep(reach - soft, reach + soft, distance);
        return Vec4f(1.0f, 1.0f, 1.0f, static_cast<float>(std::max(edge, crown)));
    });
}

} // namespace limen::worlds
