#include "visibility/OcclusionBuffer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace limen::visibility {
namespace {

constexpr std::uint32_t kWidth = 61, kHeight = 47; // not whole tiles

/// North from the origin, 90 degrees wide and high.
View north() {
    return {.eye = Vec3(0.0)};
}

using Corners = std::array<Vec3, 3>;

struct Scene {
    View view = north();
    double near = 0.05;
    std::vector<Corners> triangles;
    OcclusionBuffer buffer;

    void draw() {
        buffer.begin(view, kWidth, kHeight, near);
        for (const Corners& triangle : triangles)
            buffer.cover(triangle, std::array<std::uint32_t, 3>{0, 1, 2});
        buffer.finish();
    }
    /// The direction of a pixel's centre, 1 m forward.
    [[nodiscard]] Vec3 ray(std::uint32_t x, std::uint32_t y) const {
        const double across = ((x + 0.5) / kWidth * 2.0 - 1.0) * view.tanHalfX;
        const double upwards = ((y + 0.5) / kHeight * 2.0 - 1.0) * view.tanHalfY;
        return view.forward + across * view.right + upwards * view.up;
    }
    /// Metres forward to the nearest triangle at a pixel's centre; infinity: none. Edges count if the ray is within `slack`.
    [[nodiscard]] double distance(std::uint32_t x, std::uint32_t y, double slack) const {
        const Vec3 along = ray(x, y);
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : triangles) {
            const Vec3 normal = glm::cross(b - a, c - a);
            const double towards = glm::dot(normal, along);
            if (!(towards < 0.0)) // its back, or edge-on
                continue;
            const double t = glm::dot(normal, a) / towards;
            const Vec3 at = along * t;
            const auto isIn = [&](const Vec3& p, const Vec3& q) {
                return glm::dot(glm::cross(q - p, at - p), normal) > -slack * glm::dot(normal, normal);
            };
            if (t >= near && isIn(a, b) && isIn(b, c) && isIn(c, a))
                nearest = std::min(nearest, t);
        }
        return nearest;
    }
    /// Metres forward to a sphere; infinity: the pixel does not show it.
    [[nodiscard]] double distanceTo(const Sphere& sphere, std::uint32_t x, std::uint32_t y) const {
        const Vec3 along = ray(x, y);
        const double square = glm::dot(along, along), half = glm::dot(along, sphere.centre);
        const double root =
            half * half - square * (glm::dot(sphere.centre, sphere.centre) - sphere.radius * sphere.radius);
        return root < 0.0 ? std::numeric_limits<double>::infinity() : (half - std::sqrt(root)) / square;
    }
    [[nodiscard]] bool shows(const Sphere& sphere, double slack) const {
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x)
                if (const double to = distanceTo(sphere, x, y);
                    std::isfinite(to) && !(distance(x, y, slack) < to))
                    return true;
        return false;
    }
};

/// Two triangles, facing south.
void addWall(Scene& scene, double distance, double left, double right, double low, double high) {
    const Vec3 a(left, distance, low), b(right, distance, low), c(right, distance, high),
        d(left, distance, high);
    scene.triangles.push_back({a, b, c});
    scene.triangles.push_back({a, c, d});
}

TEST(OcclusionBuffer, AWallHidesWhatIsBehindItAlone) {
    Scene scene;
    addWall(scene, 10.0, -100.0, 100.0, -100.0, 100.0);
    scene.draw();
    EXPECT_TRUE(scene.buffer.hides({{0, 12, 0}, 1.5}));
    EXPECT_TRUE(scene.buffer.hides({{5, 20, 5}, 3.0}));
    EXPECT_TRUE(scene.buffer.hidesBox({0, 12, 0}, {5, 1.5, 5}));
    EXPECT_FALSE(scene.buffer.hides({{0, 12, 0}, 2.5})) << "it reaches through the wall";
    EXPECT_FALSE(scene.buffer.hidesBox({0, 12, 0}, {1, 2.5, 1}));
    EXPECT_FALSE(scene.buffer.hides({{0, 6, 0}, 1.0}));
    EXPECT_FALSE(scene.buffer.hides({{0, 4.5, 0}, 1.0})) << "within kNearest nothing is hidden";
}

TEST(OcclusionBuffer, NothingIsHiddenWithoutATriangle) {
    Scene scene;
    scene.draw();
    EXPECT_FALSE(scene.buffer.hides({{0, 100, 0}, 1.0}));
    EXPECT_FALSE(scene.buffer.hidesBox({0, 100, 0}, {1, 1, 1}));
    EXPECT_TRUE(scene.buffer.hides({{300, 100, 0}, 1.0})) << "it is beside the picture";
}

TEST(OcclusionBuffer, ATriangleThatFacesAwayHidesNothing) {
    Scene scene;
    addWall(scene, 10.0, -100.0, 100.0, -100.0, 100.0);
    for (Corners& triangle : scene.triangles)
        std::swap(triangle[1], triangle[2]);
    scene.draw();
    EXPECT_FALSE(scene.buffer.hides({{0, 20, 0}, 1.0}));
}

TEST(OcclusionBuffer, AGapOfOnePixelShows) {
    // A pixel is 0.328 m wide at 10 m.
    const double pixel = 20.0 / kWidth;
    for (int column = 3; column < 58; ++column) {
        Scene scene;
        const double left = -10.0 + column * pixel;
        addWall(scene, 10.0, -100.0, left, -100.0, 100.0);
        addWall(scene, 10.0, left + pixel, 100.0, -100.0, 100.0);
        scene.draw();
        EXPECT_FALSE(scene.buffer.hides({{2.0 * left, 20, 0}, 1.0})) << column;
        EXPECT_TRUE(scene.buffer.hides({{2.0 * (left - 8.0 * pixel), 20, 0}, 1.0})) << column;
    }
}

TEST(OcclusionBuffer, LandFromAboveIsAsFarAsItIs) {
    // Corners behind the eye are cut by the near plane. That of `limen check` is 20 nanometres away.
    for (const double near : {0.05, 1.9e-8}) {
        Scene scene;
        scene.near = near;
        const double yaw = 26.147172609916513 * M_PI / 180.0, pitch = -60.50739334761315 * M_PI / 180.0;
        scene.view.forward =
            Vec3(std::sin(yaw) * std::cos(pitch), std::cos(yaw) * std::cos(pitch), std::sin(pitch));
        scene.view.right = Vec3(std::cos(yaw), -std::sin(yaw), 0.0);
        scene.view.up = glm::cross(scene.view.right, scene.view.forward);
        const double left = -9.785846404, low = -18.989753061, height = -10.980806281;
        const Vec3 a(left, low, height), b(left + 24, low, height), c(left + 24, low + 24, height),
            d(left, low + 24, height);
        scene.triangles = {{a, b, c}, {a, c, d}};
        scene.draw();
        EXPECT_FALSE(scene.buffer.hides({{5.414151, 1.410247, -10.539644}, 0.642694})) << near;
        EXPECT_FALSE(scene.buffer.hides({{5.532373, 1.530070, -9.804510}, 0.167254})) << near;
        EXPECT_TRUE(scene.buffer.hides({{2.0, 1.0, -13.0}, 0.2})) << near;
    }
}

TEST(OcclusionBuffer, WhateverItHidesNoPixelShows) {
    std::mt19937 random(5);
    const auto between = [&](double from, double to) {
        return std::uniform_real_distribution<>(from, to)(random);
    };
    int hidden = 0, shown = 0;
    for (int round = 0; round < 300; ++round) {
        Scene scene;
        scene.view.tanHalfX = between(0.3, 2.0);
        scene.view.tanHalfY = between(0.3, 2.0);
        scene.near = round % 3 == 0 ? 1e-8 : 0.05;
        const auto place = [&](double most) {
            return Vec3(between(-most, most), between(round % 2 == 0 ? 1.0 : -most, most),
                        between(-most, most));
        };
        for (int i = 0; i < 12; ++i) {
            const double most = between(5.0, 60.0);
            scene.triangles.push_back({place(most), place(most), place(most)});
        }
        scene.draw();
        for (int i = 0; i < 60; ++i) {
            const Sphere sphere{Vec3(between(-30, 30), between(6, 60), between(-30, 30)), between(0.1, 2.0)};
            const bool shows = scene.shows(sphere, 1e-7);
            if (scene.buffer.hides(sphere)) {
                ++hidden;
                EXPECT_FALSE(shows) << "round " << round << ", sphere " << i;
            } else {
                shown += shows ? 1 : 0;
            }
            if (scene.buffer.hidesBox(sphere.centre, Vec3(sphere.radius)))
                EXPECT_FALSE(shows) << "the box contains the sphere";
        }
    }
    EXPECT_GT(hidden, 1000);
    EXPECT_GT(shown, 1000);
}

TEST(OcclusionBuffer, SharedEdgesLeaveNoPixelUncovered) {
    std::mt19937 random(7);
    const auto between = [&](double from, double to) {
        return std::uniform_real_distribution<>(from, to)(random);
    };
    for (int round = 0; round < 200; ++round) {
        // A fan around a point: every pixel near it is in one of its triangles.
        Scene scene;
        const Vec3 middle(between(-8, 8), 10.0, between(-8, 8));
        const int count = 3 + round % 9;
        std::vector<Vec3> around;
        for (int i = 0; i < count; ++i) {
            const double angle = -2.0 * M_PI * (i + between(0.0, 0.3)) / count;
            around.push_back(middle + 60.0 * Vec3(std::cos(angle), 0.0, std::sin(angle)));
        }
        for (int i = 0; i < count; ++i) // clockwise about north is counter-clockwise on the screen
            scene.triangles.push_back({middle, around[static_cast<std::size_t>((i + 1) % count)],
                                       around[static_cast<std::size_t>(i)]});
        scene.draw();
        EXPECT_TRUE(scene.buffer.hides({2.0 * middle, 3.0})) << round;
    }
}

TEST(OcclusionBuffer, NumbersThatAreNotFiniteCoverNothing) {
    const double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {inf, -inf, nan, 1e300})
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis) {
                Scene scene;
                Corners triangle{Vec3(-100, 10, -100), Vec3(100, 10, -100), Vec3(0, 10, 100)};
                (axis == 0 ? triangle[corner].x : axis == 1 ? triangle[corner].y : triangle[corner].z) = bad;
                scene.triangles.push_back(triangle);
                scene.draw();
                if (bad != 1e300)
                    EXPECT_FALSE(scene.buffer.hides({{0, 20, 0}, 1.0}))
                        << bad << ", " << corner << ", " << axis;
            }
    Scene scene;
    addWall(scene, 10.0, -100.0, 100.0, -100.0, 100.0);
    scene.draw();
    EXPECT_FALSE(scene.buffer.hides({{nan, nan, nan}, 1.0}));
    EXPECT_FALSE(scene.buffer.hides({{0, 20, 0}, nan}));
    EXPECT_FALSE(scene.buffer.hidesBox({0, 20, 0}, {inf, 1, 1}));
}

} // namespace
} // namespace limen::visibility
