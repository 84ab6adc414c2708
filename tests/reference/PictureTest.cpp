#include "reference/Picture.h"

#include "reference/TracedWorld.h"

namespace limen::test {
namespace {

using reference::Answer;
using reference::Camera;

TEST(Picture, raysGoThroughPixelCentres) {
    Camera camera;
    camera.width = 4;
    camera.height = 2;
    camera.tanHalfX = 2.0;
    camera.tanHalfY = 1.0;
    const auto ray = reference::rayThrough(camera, 0, 0); // top left: 1.5 left, 0.5 up, 1 ahead
    EXPECT_EQ(ray.direction, Vec3(-1.5, 1.0, 0.5));
    EXPECT_EQ(reference::rayThrough(camera, 1.5, 0.5).direction, Vec3(0, 1, 0));
    EXPECT_EQ(reference::rayThrough(camera, -1, 2).direction, Vec3(-2.5, 1.0, -1.5)) << "beyond the border";
}

TEST(Picture, everyPixelIsItsRayWhateverTheThreads) {
    House house;
    const TracedWorld traced(house.world);
    Camera camera;
    camera.eye = traced.origin() + Vec3(92.7, 74, 1.6);
    camera.width = 61; // no multiple of a tile
    camera.height = 35;
    camera.tanHalfX = 0.9;
    camera.tanHalfY = 0.5;
    reference::Scene scene(traced.world());
    reference::Picture one, other;
    reference::tracePicture(scene, camera, 1, one);
    ASSERT_EQ(one.answers.size(), 63u * 37u);
    std::uint32_t visits = 0;
    for (int y = -1; y <= 35; ++y) {
        for (int x = -1; x <= 61; ++x) {
            const Answer answer = scene.trace(camera.root, reference::rayThrough(camera, x, y));
            ASSERT_TRUE(same(one.at(x, y), answer)) << x << " " << y;
            visits = std::max(visits, answer.spacesVisited);
        }
    }
    EXPECT_EQ(visits, 3u) << "the view goes in by the window and out by the door";
    for (const unsigned threads : {0u, 2u, 3u, 16u}) {
        reference::tracePicture(scene, camera, threads, other);
        ASSERT_EQ(other.answers.size(), one.answers.size());
        for (std::size_t i = 0; i < one.answers.size(); ++i)
            ASSERT_TRUE(same(one.answers[i], other.answers[i])) << "threads " << threads << " pixel " << i;
    }
}

TEST(Picture, twoRoomsStatedByHand) {
    // From the middle of a room 8 m wide and high, 4 m before its far wall, 90 degrees, 8 × 8 pixels: each is
    // 1 m of that wall. The opening is its middle 4 × 4 m; 4 m behind it is the next room's far wall.
    TestWorld source;
    const auto a = source.addBox({0, 0, 0}, {8, 8, 8}, "brown");
    const auto b = source.addBox({0, 8, 0}, {8, 12, 8}, "blue");
    source.link(a, rectangle({2, 8, 2}, {6, 8, 6}), b);
    const TracedWorld traced(source, {.radius = 0});
    const world::SpaceIndex near = traced.space(source.id(a)), far = traced.space(source.id(b));
    Camera camera;
    camera.eye = traced.origin() + Vec3(4, 4, 4);
    camera.width = camera.height = 8;
    camera.root = near;
    const reference::Scene scene(traced.world());
    reference::Picture picture;
    reference::tracePicture(scene, camera, 2, picture);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const bool open = x >= 2 && x < 6 && y >= 2 && y < 6;
            EXPECT_TRUE(traced.isShell(picture.at(x, y).id, open ? far : near)) << x << " " << y;
            EXPECT_NEAR(picture.at(x, y).t, open ? 8.0 : 4.0, 1e-9);
        }
    }
}

} // namespace
} // namespace limen::test
