#include "world/SkyCover.h"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace limen::world {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Vec3f at(double elevation, double azimuth, double radius = 300.0) {
    const double e = elevation * kDegree, a = azimuth * kDegree;
    return Vec3f(radius * Vec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)));
}

/// Rings from the zenith down to `rim` degrees, seen from inside. `radius`: of each vertex, by ring and step.
template <class Radius>
std::vector<Vec3f> dome(double rim, Radius radius) {
    constexpr int kAround = 8, kRings = 5;
    const auto vertex = [&](int ring, int step) {
        const int k = step % kAround;
        return ring == 0 ? at(90.0, 0.0, radius(0, 0))
                         : at(90.0 + (rim - 90.0) * ring / kRings, 360.0 * k / kAround, radius(ring, k));
    };
    std::vector<Vec3f> corners;
    for (int ring = 0; ring < kRings; ++ring) {
        for (int k = 0; k < kAround; ++k) {
            const Vec3f a = vertex(ring, k), b = vertex(ring, k + 1), c = vertex(ring + 1, k + 1),
                        d = vertex(ring + 1, k);
            corners.insert(corners.end(), {a, b, c, a, c, d}); // of the first ring, a and b are one
        }
    }
    return corners;
}

std::vector<Vec3f> dome(double rim) {
    return dome(rim, [](int, int) { return 300.0; });
}

bool isHit(std::span<const Vec3f> corners, const Vec3& direction) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const Vec3 a(corners[i]), b(corners[i + 1]), c(corners[i + 2]);
        const auto right = [&](const Vec3& from, const Vec3& to) {
            return glm::dot(glm::cross(from, to), direction) <= 1e-9 * glm::length(from) * glm::length(to);
        };
        if (right(a, b) && right(b, c) && right(c, a) && glm::dot(a + b + c, direction) > 0.0)
            return true;
    }
    return false;
}

TEST(SkyCover, aDomeCoversEveryDirectionAboveItsRim) {
    for (const double rim : {-5.0, -22.5, -60.0})
        EXPECT_NEAR(coveredFrom(dome(rim)), std::sin(rim * kDegree), 2e-4) << rim;
}

TEST(SkyCover, aClosedMeshCoversEverything) {
    std::vector<Vec3f> corners = dome(-40.0);
    const Vec3f nadir(0, 0, -300);
    for (int k = 0; k < 8; ++k)
        corners.insert(corners.end(), {at(-40.0, 45.0 * k), at(-40.0, 45.0 * ((k + 1) % 8)), nadir});
    EXPECT_NEAR(coveredFrom(corners), -1.0, 2e-4);
}

TEST(SkyCover, everyDirectionAboveHasATriangle_forAnyDome) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    for (int i = 0; i < 50; ++i) {
        std::array<std::array<double, 8>, 6> radii;
        for (auto& ring : radii)
            for (double& radius : ring)
                radius = between(250.0, 350.0);
        const std::vector<Vec3f> corners = dome(between(-60.0, -2.0), [&](int ring, int k) {
            return radii[static_cast<std::size_t>(ring)][static_cast<std::size_t>(k)];
        });
        const double from = coveredFrom(corners);
        ASSERT_LT(from, 0.0);
        for (int ray = 0; ray < 200; ++ray) {
            const double sine = between(from, 1.0), across = std::sqrt(1.0 - sine * sine),
                         a = between(0.0, 7.0);
            EXPECT_TRUE(isHit(corners, {across * std::cos(a), across * std::sin(a), sine}))
                << i << ' ' << ray;
        }
    }
}

TEST(SkyCover, nothingIsCoveredByAMeshWithAHole_orARimAboveTheHorizon_orSeenFromBehind) {
    for (std::size_t hole = 0; hole < 5 * 8 * 2 - 16; ++hole) { // triangles above the last ring
        std::vector<Vec3f> corners = dome(-22.5);
        const auto first = corners.begin() + static_cast<std::ptrdiff_t>(3 * hole);
        if (hole < 16 && hole % 2 == 0)
            continue; // at the zenith: two corners are one
        corners.erase(first, first + 3);
        const double from = coveredFrom(corners);
        EXPECT_TRUE(from == SkyPart::kCoversNothing || hole >= 48)
            << hole << ": the hole is above the horizon, " << from;
    }
    EXPECT_EQ(coveredFrom(dome(3.0)), SkyPart::kCoversNothing);
    std::vector<Vec3f> outward = dome(-22.5);
    for (std::size_t i = 0; i < outward.size(); i += 3)
        std::swap(outward[i], outward[i + 1]);
    EXPECT_EQ(coveredFrom(outward), SkyPart::kCoversNothing);
    EXPECT_EQ(coveredFrom(std::vector<Vec3f>{}), SkyPart::kCoversNothing);
}

/// Three parts: two domes of one shape and a disc.
Sky threeParts() {
    Sky sky;
    sky.parts.resize(3);
    for (SkyPart& part : sky.parts)
        part.isOpaque = true;
    sky.parts[0].coversFrom = sky.parts[1].coversFrom = -0.3;
    sky.parts[2].shape = 2;
    return sky;
}

std::vector<SkyPlacement> placed() {
    std::vector<SkyPlacement> placements(3);
    for (std::uint32_t i = 0; i < 3; ++i)
        placements[i].part = i;
    return placements;
}

std::vector<std::uint32_t> left(const Sky& sky, std::vector<SkyPlacement> placements) {
    leaveOutCovered(sky, placements);
    std::vector<std::uint32_t> parts;
    for (const SkyPlacement& placement : placements)
        parts.push_back(placement.part);
    return parts;
}

TEST(SkyCover, leavesOutAPartBehindAnOpaqueOneOfItsShape) {
    using Parts = std::vector<std::uint32_t>;
    const Parts all{0, 1, 2}, without{1, 2};
    EXPECT_EQ(left(threeParts(), placed()), without);
    const auto changed = [&](auto change) {
        Sky sky = threeParts();
        std::vector<SkyPlacement> placements = placed();
        change(sky, placements);
        return left(sky, placements);
    };
    EXPECT_EQ(changed([](Sky& s, auto&) { s.parts[1].isOpaque = false; }), all);
    EXPECT_EQ(changed([](Sky& s, auto&) { s.parts[0].isOpaque = false; }), without);
    EXPECT_EQ(changed([](Sky& s, auto&) { s.parts[1].shape = 1; }), all);
    EXPECT_EQ(changed([](Sky&, auto& p) { p[1].transparent = 0.1f; }), all);
    EXPECT_EQ(changed([](Sky&, auto& p) { p[1].rotation[0].y = 0.1f; }), all);
    EXPECT_EQ(changed([](Sky&, auto& p) { p[1].offset.x = 1.0f; }), all);
    EXPECT_EQ(changed([](Sky&, auto& p) { p[1].isOverLand = true; }), all);
    EXPECT_EQ(changed([](Sky&, auto& p) { p[0].isOverLand = true; }), all);
}

TEST(SkyCover, aLevelOpaquePartAroundTheEyeCoversThePlainSky) {
    const auto from = [](auto change) {
        Sky sky = threeParts();
        std::vector<SkyPlacement> placements = placed();
        placements.erase(placements.begin());
        change(sky, placements.front());
        return coveredFrom(sky, placements);
    };
    EXPECT_EQ(from([](Sky&, auto&) {}), -0.3);
    EXPECT_EQ(from([](Sky&, auto& p) { p.rotation = {0, 1, 0, -1, 0, 0, 0, 0, 1}; }), -0.3)
        << "turned about the zenith";
    EXPECT_EQ(from([](Sky&, auto& p) { p.rotation = {1, 0, 0, 0, 0, 1, 0, -1, 0}; }),
              SkyPart::kCoversNothing);
    EXPECT_EQ(from([](Sky&, auto& p) { p.offset.z = 2.0f; }), SkyPart::kCoversNothing);
    EXPECT_EQ(from([](Sky&, auto& p) { p.transparent = 0.5f; }), SkyPart::kCoversNothing);
    EXPECT_EQ(from([](Sky&, auto& p) { p.isOverLand = true; }), SkyPart::kCoversNothing);
    EXPECT_EQ(from([](Sky& s, auto&) { s.parts[1].isOpaque = false; }), SkyPart::kCoversNothing);
}

} // namespace
} // namespace limen::world
