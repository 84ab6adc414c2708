// Colours with exact outlines equal the rasteriser's own, except at edges. Ids and depths are compared with
// rays elsewhere, colours only here. In the built-in world, from its places, and from eyes at which corners
// of the ground have no depth.
#include "picture/PictureWorld.h"
#include "support/TemporaryDirectory.h"

#include "motion/Locate.h"
#include "world/Loader.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

/// Equal colours: at most 1 of 255 apart in each channel.
constexpr int kMostDifference = 12;

struct Counts {
    std::size_t pixels = 0, unlike = 0;
};

/// Both pictures show the same in the pixel's neighbourhood.
bool isWithin(const Picture& a, const Picture& b, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t id = a.id(x, y);
    for (std::uint32_t v = y - 1; v <= y + 1; ++v) {
        for (std::uint32_t u = x - 1; u <= x + 1; ++u)
            if (a.id(u, v) != id || b.id(u, v) != id)
                return false;
    }
    return true;
}

Counts compare(const Picture& a, const Picture& b) {
    Counts counts;
    for (std::uint32_t y = 1; y + 1 < a.frame.height; ++y) {
        for (std::uint32_t x = 1; x + 1 < a.frame.width; ++x) {
            if (!isWithin(a, b, x, y))
                continue;
            ++counts.pixels;
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t at = (std::size_t{y} * a.frame.width + x) * 4 + c;
                most = std::max(most, std::abs(int{a.colour[at]} - int{b.colour[at]}));
            }
            counts.unlike += most > kMostDifference ? 1 : 0;
        }
    }
    return counts;
}

struct Painted : ::testing::Test {
    Painted() {
        const auto written = worlds::writeBuiltInWorld(directory.path());
        EXPECT_TRUE(written) << written.error().message();
        file = *world::loadWorldFile(directory.path());
        const dat::BlockCoord home = world::blockAt(file.places.front().eye);
        PictureOptions options{.radius = 1, .moving = file.moving};
        exact = std::make_unique<PictureWorld>(directory.path(), home, options);
        options.exactOutlines = false;
        plain = std::make_unique<PictureWorld>(directory.path(), home, options);
    }
    /// Share of the pixels away from edges that have another colour.
    double shareUnlike(const Vec3& eye, double yaw, double pitch) {
        const world::SpaceIndex root = motion::locate(exact->world(), eye).space;
        const auto frame = frame::makeView(eye, yaw, pitch, 75.0, 120, 80, root);
        const Counts counts = compare(exact->shoot(frame), plain->shoot(frame));
        compared += counts.pixels;
        return static_cast<double>(counts.unlike) /
               static_cast<double>(std::max<std::size_t>(counts.pixels, 1));
    }

    const TemporaryDirectory directory;
    world::WorldFile file;
    std::unique_ptr<PictureWorld> exact, plain;
    std::size_t compared = 0;
};

TEST_F(Painted, isWhatTheRasteriserPaintsFromPlacesOfTheWorld) {
    for (const world::Place& place : file.places) {
        if (world::findBlock(exact->world(), world::blockAt(place.eye)) != nullptr) {
            EXPECT_LT(shareUnlike(place.eye, place.yaw, place.pitch), 0.01) << place.name;
            EXPECT_LT(shareUnlike(place.eye, 90.0, 0.0), 0.01) << place.name << ", to the east";
        }
    }
    EXPECT_GT(compared, 100'000u);
}

TEST_F(Painted, isWhatTheRasteriserPaintsRightOverCornersOfTheGround) {
    const Vec3 origin = world::findBlock(exact->world(), world::blockAt(file.places.front().eye))->origin();
    for (int corner = 0; corner < 16; ++corner) {
        Vec3 eye = origin + Vec3(24.0 * (1 + corner % 4), 24.0 * (1 + corner / 4), 0.0);
        eye.z = world::terrainHeight(exact->world(), eye.x, eye.y) + 1.7;
        for (const double yaw : {0.0, 90.0, 73.0})
            EXPECT_LT(shareUnlike(eye, yaw, 0.0), 0.01) << corner << ", " << yaw;
    }
    EXPECT_GT(compared, 100'000u);
}

} // namespace
} // namespace limen::test
