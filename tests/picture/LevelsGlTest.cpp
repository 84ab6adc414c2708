// Levels of detail: static and dynamic, opaque and transparent instances change at their distances, drawn and
// traced alike.
#include "picture/CaseHelp.h"
#include "picture/EveryCulling.h"
#include "support/MovingHut.h"

#include <cmath>

namespace limen::test {
namespace {

constexpr double kNear = 12.0, kFar = 30.0; // metres

/// A meadow with a stone box, a glass box and a villager. Each is replaced by a smaller one from kNear on and
/// absent from kFar on.
struct LevelsGl : ::testing::TestWithParam<gpu::Culling> {
    TestWorld source;
    world::MovingEntries moving;
    std::uint32_t stone = 0, pebble = 0, glass = 0, shard = 0, coat = 0, scarf = 0;
    const Vec3 stoneAt{40.3, 40.1, 2.0}, glassAt{43.7, 40.1, 2.0}, folkFrom{46.9, 38.0, 2.0},
        folkTo{46.9, 42.0, 2.0};

    LevelsGl() {
        source.setFlatTerrain(source.home(), 1);
        source.solid("glass", 0xFF80A0C0u, 0x10, 0.6f);
        const auto add = [&](const char* surface, std::uint32_t& near, std::uint32_t& far) {
            far = source.addModel(boxExterior({-0.5, -0.5, 0}, {0.5, 0.5, 1.2}, surface));
            near = source.addModel(boxExterior({-1, -1, 0}, {1, 1, 3}, surface),
                                   {{TestWorld::kItself, 1, 0, 0, kNear}, {far, 1, 0, 0, kFar}});
        };
        add("stone", stone, pebble);
        add("glass", glass, shard);
        add("coat", coat, scarf);
        source.addObject(stone, frameAt(stoneAt, 20));
        source.addObject(glass, frameAt(glassAt, 10));
        world::RouteEntry route;
        route.name = "lane";
        const auto at = [&](const Vec3& local) { return toGlobal(source, local); };
        route.points = {{at(folkFrom), 0}, {at(folkTo), 0}};
        moving.routes.push_back(route);
        moving.villagers.push_back({"anna", "lane", coat, 1.0, 0.0, {}, {}});
    }

    /// The eye `metres` south of the static boxes, slightly above their base.
    [[nodiscard]] static Vec3 southOf(const Vec3& place, double metres) {
        return place + Vec3(0, -metres, 0.7);
    }
};

INSTANTIATE_TEST_SUITE_P(Culling, LevelsGl, everyCulling(), nameOfCulling);

TEST_P(LevelsGl, changeAtTheirDistances) {
    PictureWorld pictures(source, {.moving = moving, .culling = GetParam()});
    pictures.fov = 95.0;
    for (const double metres : {10.0, 11.5, 12.5, 20.0, 29.5, 30.5, 50.0}) {
        SCOPED_TRACE(metres);
        frame::FrameView frame = pictures.look(southOf(stoneAt, metres), 0, 0, world::kOutside);
        pictures.setDynamics(dynamicsFor(frame, 0.0, 0.0));
        const Picture picture = pictures.expectClean(frame, {.wantLayers = true});
        EXPECT_EQ(pixelsOfRecord(pictures, picture, stone) > 0, metres < kNear);
        EXPECT_EQ(pixelsOfRecord(pictures, picture, pebble) > 0, metres > kNear && metres < kFar);
        const Vec3 folk(folkFrom - southOf(stoneAt, metres));
        EXPECT_EQ(pixelsOfRecord(pictures, picture, coat) > 0, glm::length(folk) < kNear);
        EXPECT_EQ(pixelsOfRecord(pictures, picture, scarf) > 0,
                  glm::length(folk) > kNear && glm::length(folk) < kFar);
    }
}

TEST_P(LevelsGl, ofGlassCountAsLayers) {
    PictureWorld pictures(source, {.moving = moving, .culling = GetParam()});
    std::array<std::size_t, 3> layers{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double metres[] = {kNear - 1, kNear + 1, kFar + 1};
        const Picture picture = pictures.expectClean(
            pictures.look(southOf(glassAt, metres[i]), 0, 0, world::kOutside), {.wantLayers = true});
        layers[i] = static_cast<std::size_t>(std::count_if(picture.layers.begin(), picture.layers.end(),
                                                           [](const auto& sum) { return sum.count > 0; }));
    }
    EXPECT_GT(layers[0], 2 * layers[1]);
    EXPECT_GT(layers[1], 0u);
    EXPECT_EQ(layers[2], 0u);
}

// Limits are whole sixteenths of a metre, so that float rounding cannot change the level.
TEST_P(LevelsGl, areTheSameDrawnAndTracedWithinARoundingOfTheirLimits) {
    PictureWorld pictures(source, {.moving = moving, .culling = GetParam()});
    std::size_t near = 0, far = 0;
    for (int i = 0; i < 60; ++i) {
        // Eyes on a sphere around the stone, and slightly to both sides of the steps.
        const double turn = 0.02 * i, hair = (i % 3 - 1) * 1e-9;
        Vec3 eye = stoneAt + kNear * Vec3(-std::sin(turn), -std::cos(turn), 0.0) + Vec3(hair, hair, 0.5);
        if (i % 2 == 1) // onto a step's edge
            eye.x = std::floor(eye.x * 16.0) / 16.0 + hair;
        const Picture picture =
            pictures.expectClean(pictures.look(eye, glm::degrees(turn), 0, world::kOutside));
        near += pixelsOfRecord(pictures, picture, stone) > 0 ? 1 : 0;
        far += pixelsOfRecord(pictures, picture, pebble) > 0 ? 1 : 0;
    }
    EXPECT_EQ(near + far, 60u);
    EXPECT_GT(near, 5u);
    EXPECT_GT(far, 5u);
}

} // namespace
} // namespace limen::test
