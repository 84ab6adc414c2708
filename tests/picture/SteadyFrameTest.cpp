// A steady frame allocates nothing on the heap. Counted over a warm path.
#include "picture/CountedAllocations.h"
#include "picture/PictureWorld.h"
#include "picture/SteadyWalk.h"

#include "gpu/device/NullDevice.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

TEST(SteadyFrame, allocatesNothing) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    const auto room = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
    const auto closet = world.addBox({96, 80, 0}, {99, 86, 3}, "blue");
    world.link(room, rectangle({96, 82, 0}, {96, 83, 2}), closet);
    const auto exit = world.openOutside(room, rectangle({92, 86, 0.1}, {93.2, 86, 2.1}));
    world.addBuilding(boxExterior({90, 80, 0}, {99, 86, 3}), {exit});
    PictureWorld pictures(world, {false, 1});
    visibility::VisibleSet visible;
    frame::FramePlan plan;
    const auto walk = [&] {
        for (double yaw = 0; yaw < 360; yaw += 20) {
            pictures.plan(pictures.look({92.3, 82.1, 1.6}, yaw, 0, pictures.space(world.id(room))), visible,
                          plan);
            pictures.plan(pictures.look({92.3, 92.1, 1.6}, yaw, 0, world::kOutside), visible, plan);
        }
    };
    walk();
    const std::size_t before = allocations();
    EXPECT_GT(before, 0u) << "the counter counts";
    walk();
    EXPECT_EQ(allocations(), before);
}

class SteadyFrameOf : public testing::TestWithParam<gpu::Drawing> {};

TEST_P(SteadyFrameOf, allocatesNothingFromTheMomentToTheDriver_andMakesFewCalls) {
    constexpr std::uint32_t kMostCalls = 40; // of GL, a frame with ids or without
    Tour tour(1);
    gpu::NullDevice device;
    SteadyWalk walk(std::move(*tour.world), device, 640, 360, {.drawing = GetParam()});
    walk.go(tour.way);
    const std::size_t before = allocations();
    walk.go(tour.way);
    EXPECT_EQ(allocations(), before);
    EXPECT_GT(walk.frames(), 400u) << "the path has the same length";
    EXPECT_GT(walk.inside(), 100u);
    EXPECT_LE(walk.mostCalls(), kMostCalls);
    EXPECT_GT(walk.mostCalls(), 20u);
}

INSTANTIATE_TEST_SUITE_P(BothWays, SteadyFrameOf, testing::Values(gpu::Drawing::Exact, gpu::Drawing::Fast));

} // namespace
} // namespace limen::test
