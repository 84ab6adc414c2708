#include "engine/FrameMemory.h"

#include <gmock/gmock.h>

namespace limen::engine {
namespace {

TEST(FrameMemory, growsWithPixelsAndSamples) {
    const FrameMemory one = frameMemory({1000, 1000}, 0), four = frameMemory({1000, 1000}, 4);
    EXPECT_EQ(one.device, 16'000'000u); // colour, depth, ownership and id of four bytes each
    EXPECT_EQ(four.device, 16'000'000u + 52'000'000u);
    EXPECT_EQ(frameMemory({kMaxSide, kMaxSide}, 4).device, std::uint64_t{kMaxSide} * kMaxSide * 68);
    EXPECT_GT(one.host, 3'000'000u);
}

TEST(FrameMemory, refusesMoreThanIsFree) {
    EXPECT_TRUE(checkMemory("--size", "a picture", 100, 100));
    EXPECT_TRUE(checkMemory("--size", "a picture", 100, std::nullopt));
    const Result<void> refused = checkMemory("--size", "a picture", 3'000'000'000, 2'000'000'000);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message(),
              "--size: a picture needs 3.0 GB of memory, and 2.0 GB are free; choose a smaller number");
}

TEST(FrameMemory, comparesAFrameWithDriverAndMemory) {
    gpu::Capabilities driver;
    driver.maxTextureSize = 8192;
    EXPECT_TRUE(checkFrameFits({8192, 8192}, 0, driver, std::nullopt));
    const Result<void> large = checkFrameFits({8193, 1}, 0, driver, std::nullopt);
    ASSERT_FALSE(large);
    EXPECT_THAT(large.error().message(), testing::HasSubstr("8192 pixels per side"));
    const FrameMemory need = frameMemory({1000, 1000}, 0);
    EXPECT_TRUE(checkFrameFits({1000, 1000}, 0, driver, need.host)) << "the targets are the card's";
    driver.software = true;
    EXPECT_FALSE(checkFrameFits({1000, 1000}, 0, driver, need.host));
    EXPECT_TRUE(checkFrameFits({1000, 1000}, 0, driver, need.host + need.device));
}

} // namespace
} // namespace limen::engine
