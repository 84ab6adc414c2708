// Multisampled frames shaded flat by id, compared with rays traced through every sample (docs/testing.md).
#include "picture/PictureWorld.h"

#include "motion/Locate.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

struct Multisample : ::testing::TestWithParam<bool> {
    [[nodiscard]] PictureOptions options() const { return {GetParam(), 1}; }
};
INSTANTIATE_TEST_SUITE_P(Zones, Multisample, ::testing::Bool(),
                         [](const auto& zones) { return zones.param ? "merged" : "apart"; });

/// Two houses, each with a door and a window, a yard between them, and a person in a doorway.
struct Yard {
    TestWorld world;
    TestWorld::Cell south = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
    TestWorld::Cell north = world.addBox({90, 100, 0}, {96, 106, 3}, "blue");
    TestWorld::Cell back = world.addBox({96, 100, 0}, {102, 106, 3}, "green");
    Yard() {
        world.setFlatTerrain(world.home(), 0);
        world.link(north, rectangle({96, 102, 0.1}, {96, 103.3, 2.2}), back);
        const auto exit = world.openOutside(south, rectangle({92, 86, 0.1}, {93.2, 86, 2.1}));
        const auto hatch = world.openOutside(south, rectangle({92, 80, 1}, {93.2, 80, 2}));
        world.addBuilding(boxExterior({90, 80, 0}, {96, 86, 3}), {exit, hatch});
        const auto door = world.openOutside(north, rectangle({92, 100, 0.1}, {93.2, 100, 2.1}));
        const auto window = world.openOutside(back, rectangle({98, 100, 1}, {99.7, 100, 2}));
        world.addBuilding(boxExterior({90, 100, 0}, {102, 106, 3}), {door, window});
        const std::uint32_t body =
            world.addModel(insideOut(boxWalls({-0.3, -0.3, 0}, {0.3, 0.3, 1.8}, "pink")));
        world.addObject(body, frameAt({92.7, 100.0, 0.1}, 20));
    }
};

TEST_P(Multisample, everyPixelIsTheMeanOfWhatItsSamplesMeet) {
    Yard yard;
    PictureWorld pictures(yard.world, options());
    SampledTally sum;
    const Vec3 eyes[] = {{92.6, 94, 1.2}, {92.9, 99.2, 1.6}, {92.5, 84, 1.5}, {91, 101, 1.7},
                         {99, 97, 1.5},   {98, 104, 1.4},    {93, 85.96, 1.4}};
    for (std::size_t i = 0; i < std::size(eyes); ++i) {
        for (const double yaw : {0.0, 37.0, 80.0, 170.0, 265.0}) {
            const Vec3& eye = eyes[i];
            const auto located = motion::locate(pictures.world(), pictures.homeOrigin() + eye);
            const frame::FrameView frame =
                pictures.look(eye, yaw + static_cast<double>(i) * 7.0, -4, located.space);
            SCOPED_TRACE(::testing::Message() << "eye " << i << " yaw " << yaw);
            sum.judge(pictures, frame);
        }
    }
    EXPECT_GT(sum.mixed, sum.pixels / 500) << "edges are in the pictures";
    RecordProperty("mixed", static_cast<int>(sum.mixed));
    EXPECT_LT(sum.slivers, sum.mixed / 20);
    RecordProperty("slivers", static_cast<int>(sum.slivers));
}

} // namespace
} // namespace limen::test
