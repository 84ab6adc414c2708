// Levels of detail: static and dynamic, opaque and transparent instances change at their distances, drawn and
// traced alike.
#include "picture/CaseHelp.h"
#include "picture/EveryCulling.h"
#include "support/MovingHut.h"

#include <cmath>
#include <limits>

namespace limen::test {
namespace {

constexpr double kNear = 62.0, kFar = 80.0; // metres
constexpr float kMost = std::numeric_limits<float>::max();

/// The distance of an eye from an object outdoors, as levels of detail count it.
double levelDistance(const Vec3& object, const Vec3& eye) {
    const Vec3 middle = (glm::floor(object / 24.0) + 0.5) * 24.0;
    const double across = std::hypot(middle.x - eye.x, middle.y - eye.y);
    return across > 50.0 ? across : glm::length(object - eye);
}

/// A meadow with a stone box, a glass box and a villager, all large. Each is replaced by a smaller one from kNear
/// on and absent from kFar on.
struct LevelsGl : ::testing::TestWithParam<gpu::Culling> {
    TestWorld source;
    world::MovingEntries moving;
    std::uint32_t stone = 0, pebble = 0, glass = 0, shard = 0, coat = 0, scarf = 0;
    const Vec3 stoneAt{36.3, 130.1, 2.0}, glassAt{57.7, 130.1, 2.0}, folkFrom{80.9, 128.0, 2.0},
        folkTo{80.9, 132.0, 2.0};

    LevelsGl() {
        source.setFlatTerrain(source.home(), 1);
        source.solid("glass", 0xFF80A0C0u, 0x10, 0.6f);
        const auto add = [&](const char* surface, std::uint32_t& near, std::uint32_t& far) {
            constexpr float kBefore = 50.0f;
            far = source.addModel(boxExterior({-2.5, -2.5, 0}, {2.5, 2.5, 6}, surface));
            near = source.addModel(boxExterior({-5, -5, 0}, {5, 5, 15}, surface),
                                   {{TestWorld::kItself, 1, 0, 0, static_cast<float>(kNear) - kBefore},
                                    {far, 1, 0, 0, static_cast<float>(kFar) - kBefore},
                                    {0, 1, kMost, kMost, kMost}});
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
    for (const double metres : {30.0, 55.0, 63.0, 67.0, 75.0, 82.0, 88.0, 110.0}) {
        SCOPED_TRACE(metres);
        frame::FrameView frame = pictures.look(southOf(stoneAt, metres), 0, 0, world::kOutside);
        pictures.setDynamics(dynamicsFor(frame, 0.0, 0.0));
        const Picture picture = pictures.expectClean(frame, {.wantLayers = true});
        const Vec3 eye = southOf(stoneAt, metres);
        const double stoneAway = levelDistance(stoneAt, eye), folkAway = levelDistance(folkFrom, eye);
        EXPECT_EQ(pixelsOfRecord(pictures, picture, stone) > 0, stoneAway < kNear);
        EXPECT_EQ(pixelsOfRecord(pictures, picture, pebble) > 0, stoneAway >= kNear && stoneAway < kFar);
        EXPECT_EQ(pixelsOfRecord(pictures, picture, coat) > 0, folkAway < kNear);
        EXPECT_EQ(pixelsOfRecord(pictures, picture, scarf) > 0, folkAway >= kNear && folkAway < kFar);
    }
}

TEST_P(LevelsGl, ofGlassCountAsLayers) {
    PictureWorld pictures(source, {.moving = moving, .culling = GetParam()});
    std::array<std::size_t, 3> layers{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double metres[] = {kNear - 8, kNear + 8, kFar + 20};
        const Picture picture = pictures.expectClean(
            pictures.look(southOf(glassAt, metres[i]), 0, 0, world::kOutside), {.wantLayers = true});
        layers[i] = static_cast<std::size_t>(std::count_if(picture.layers.begin(), picture.layers.end(),
                                                           [](const auto& sum) { return sum.count > 0; }));
    }
    EXPECT_GT(layers[0], 3 * layers[1]);
    EXPECT_GT(layers[1], 0u);
    EXPECT_EQ(layers[2], 0u);
}

// Limits are whole sixteenths of a metre, so that float rounding cannot change the level.
TEST_P(LevelsGl, areTheSameDrawnAndTracedWithinARoundingOfTheirLimits) {
    PictureWorld pictures(source, {.moving = moving, .culling = GetParam()});
    const Vec3 middle(36, 132, 2); // of the stone's landcell
    std::size_t near = 0, far = 0;
    for (int i = 0; i < 60; ++i) {
        // Eyes on circles around it, and slightly to both sides of the steps.
        const double turn = 0.02 * i, hair = (i % 3 - 1) * 1e-9, away = kNear + 0.04 * (i % 5 - 2);
        Vec3 eye = middle + away * Vec3(-std::sin(turn), -std::cos(turn), 0.0) + Vec3(hair, hair, 0.5);
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
