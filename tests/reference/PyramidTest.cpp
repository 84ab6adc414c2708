// The conservative tests of a tile's rays: everything that a ray meets passes them, and most other things do
// not.
#include "reference/Pyramid.h"

#include <bit>
#include <gtest/gtest.h>
#include <random>

namespace limen::test {
namespace {

using reference::Box;
using reference::Pyramid;
using reference::Tile;

double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
Vec3 within(std::mt19937& random, double size) {
    return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

/// A tile somewhere in a picture, seen by an eye up to some blocks away from the origin.
struct RandomTile {
    reference::Camera camera;
    Vec3 origin;
    Tile tile{camera};
    explicit RandomTile(std::mt19937& random, bool telescopes = true) : origin(within(random, 40'000.0)) {
        camera.eye = origin + within(random, 2000.0);
        camera.forward = glm::normalize(within(random, 1.0));
        camera.right = glm::normalize(glm::cross(camera.forward, within(random, 1.0)));
        camera.up = glm::cross(camera.right, camera.forward);
        const double fields[] = {1e-4, 0.3, 1.0, 4.0};
        camera.tanHalfX = fields[telescopes ? random() % 4 : 1 + random() % 3];
        camera.tanHalfY = camera.tanHalfX * between(random, 0.4, 1.2);
        camera.width = static_cast<std::uint32_t>(40 + random() % 800);
        camera.height = static_cast<std::uint32_t>(40 + random() % 500);
        tile.left = static_cast<int>(random() % camera.width) - 1;
        tile.top = static_cast<int>(random() % camera.height) - 1;
        camera.place =
            random() % 2 ? Vec2(0.0) : Vec2(between(random, -0.5, 0.5), between(random, -0.5, 0.5));
    }
    RandomTile(const RandomTile&) = delete;
    [[nodiscard]] Vec3 eye() const { return camera.eye - origin; }
    [[nodiscard]] Vec3 direction(std::uint32_t pixel) const {
        return tile.ray(pixel % Tile::kSide, pixel / Tile::kSide).direction;
    }
};

Box boxAround(std::span<const Vec3> points) {
    reference::Extent extent;
    for (const Vec3& p : points)
        extent.include(p);
    return extent.box();
}

/// Tests one box, as the only one of a node's four.
int meetsBox(const Pyramid& pyramid, const Box& box, float& least) {
    alignas(16) float sides[2][3][4];
    alignas(16) float leasts[4];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 4; ++i) {
            sides[0][axis][i] = i == 2 ? box.min[axis] : 1e30f;
            sides[1][axis][i] = i == 2 ? box.max[axis] : -1e30f;
        }
    }
    const int met = pyramid.meetsBoxes(sides, leasts);
    EXPECT_EQ(met & ~4, 0) << "children that are not there are not met";
    least = leasts[2];
    return met;
}

TEST(Pyramid, neverMissesWhatARayMeets) {
    std::mt19937 random(5);
    std::size_t met = 0;
    for (int i = 0; i < 20'000; ++i) {
        const RandomTile of(random);
        const Pyramid pyramid(of.tile, of.origin);
        const auto pixel = static_cast<std::uint32_t>(random() % Tile::kPixels);
        const Vec3 direction = of.direction(pixel);
        const reference::RayFrame ray(of.eye(), direction);
        // A triangle around a point of the ray, often aslant or tiny, or with the ray through an edge or a
        // corner.
        const double t = std::exp(between(random, -6, 8)), size = std::exp(between(random, -9, 5));
        const Vec3 point = of.eye() + direction * t;
        const Vec3 a = point + within(random, size), b = point + within(random, size);
        Vec3 c = point * 3.0 - a - b;
        if (random() % 4 == 0)
            c = point;
        if (random() % 4 == 0)
            c = a + (b - a) * between(random, 0.2, 0.8) + within(random, size * 1e-6);
        for (const reference::Triangle& triangle :
             {reference::Triangle{a, b, c}, reference::Triangle{a, c, b}}) {
            reference::Meeting at;
            if (!meetsFront(ray, triangle, at) || !(at.t > 0.0))
                continue;
            ++met;
            const Vec3 corners[] = {triangle.a, triangle.b, triangle.c};
            const Pyramid::Cover cover = pyramid.coverOf(triangle);
            EXPECT_TRUE(cover.pixels >> pixel & 1) << "at " << t << " size " << size;
            EXPECT_LE(cover.least, at.t);
            EXPECT_GE(cover.most, at.t);
            const Box box = boxAround(corners);
            float least = 0.0f;
            EXPECT_NE(meetsBox(pyramid, box, least), 0) << "at " << t << " size " << size;
            EXPECT_LE(static_cast<double>(least), at.t);
            EXPECT_TRUE(pyramid.pixelsOf(box) >> pixel & 1) << "at " << t << " size " << size;
            EXPECT_TRUE(pyramid.mayMeet(corners, 0.0));
        }
    }
    EXPECT_GT(met, 10'000u);
}

TEST(Pyramid, neverMissesABoxAroundTheEye) {
    std::mt19937 random(6);
    for (int i = 0; i < 2000; ++i) {
        const RandomTile of(random);
        const Pyramid pyramid(of.tile, of.origin);
        const Vec3 eye = of.eye(), flat(between(random, 0, 3), 0.0, between(random, 0, 3));
        const Vec3 corners[] = {eye - flat, eye + flat}; // flat: the eye is in both of the box's sides
        float least = 0.0f;
        EXPECT_NE(meetsBox(pyramid, boxAround(corners), least), 0);
        EXPECT_LE(least, 0.0f);
        EXPECT_EQ(pyramid.pixelsOf(boxAround(corners)), ~reference::PixelMask{0});
    }
}

TEST(Pyramid, coversHardlyAPixelMoreThanIsMet) {
    std::mt19937 random(7);
    std::size_t covered = 0, met = 0, boxed = 0, beside = 0;
    for (int i = 0; i < 2000; ++i) {
        const RandomTile of(random, false);
        const Pyramid pyramid(of.tile, of.origin);
        const double t = std::exp(between(random, 0, 5));
        const double width = t * 2 * of.camera.tanHalfX / of.camera.width * Tile::kSide; // of the tile
        const Vec3 middle = of.eye() + of.direction(static_cast<std::uint32_t>(random() % Tile::kPixels)) * t;
        const reference::Triangle triangle{middle + within(random, width), middle + within(random, width),
                                           middle + within(random, width)};
        const Vec3 corners[] = {triangle.a, triangle.b, triangle.c};
        covered += static_cast<std::size_t>(std::popcount(pyramid.coverOf(triangle).pixels));
        boxed += static_cast<std::size_t>(std::popcount(pyramid.pixelsOf(boxAround(corners))));
        for (std::uint32_t pixel = 0; pixel < Tile::kPixels; ++pixel) {
            reference::Meeting at;
            met += meetsFront({of.eye(), of.direction(pixel)}, triangle, at) ? 1 : 0;
        }
        Vec3 aside[3];
        for (std::size_t k = 0; k < 3; ++k)
            aside[k] = corners[k] + of.camera.right * (width * 8.0);
        float least = 0.0f;
        beside += meetsBox(pyramid, boxAround(aside), least) != 0 || pyramid.mayMeet(aside, 0.0) ? 1 : 0;
    }
    EXPECT_GT(met, 5000u);
    EXPECT_GE(covered, met);
    EXPECT_LT(covered, met + met / 1000);
    EXPECT_LT(boxed, met * 20);
    EXPECT_EQ(beside, 0u);
}

} // namespace
} // namespace limen::test
