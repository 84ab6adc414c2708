// Like SteadyFrameTest.cpp, up to the driver.
#include "picture/CountedAllocations.h"
#include "picture/SteadyWalk.h"

#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

TEST(SteadyFrameGl, allocatesNothing) {
    const auto context = gpu::HeadlessContext::create();
    ASSERT_TRUE(context);
    const auto device = gpu::GlDevice::create();
    ASSERT_TRUE(device);
    Tour tour(16);
    SteadyWalk walk(std::move(*tour.world), **device, 64, 36);
    walk.go(tour.way);
    const std::size_t before = allocations();
    walk.go(tour.way);
    EXPECT_EQ(allocations(), before);
    EXPECT_GT(walk.frames(), 20u) << "the path has the same length";
    EXPECT_GT(walk.inside(), 8u);
}

} // namespace
} // namespace limen::test
