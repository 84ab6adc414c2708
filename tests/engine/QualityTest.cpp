#include "engine/Quality.h"

#include "engine/SessionOptions.h"

#include <gtest/gtest.h>

namespace limen::engine {
namespace {

TEST(Quality, eachIsFoundByItsName) {
    for (std::size_t i = 0; i < kQualities.size(); ++i)
        EXPECT_EQ(qualityNamed(kQualities[i].name), i);
    EXPECT_FALSE(qualityNamed("best"));
    EXPECT_FALSE(qualityNamed(""));
}

TEST(Quality, aHigherOneLacksNothingThatALowerOneHas) {
    for (std::size_t i = 1; i < kQualities.size(); ++i) {
        const Quality &low = kQualities[i - 1], &high = kQualities[i];
        EXPECT_GT(high.radius, low.radius);
        EXPECT_GT(high.farRadius, low.farRadius);
        EXPECT_GT(high.detail, low.detail);
        EXPECT_GE(high.samples, low.samples);
        EXPECT_GT(high.anisotropy, low.anisotropy);
        EXPECT_GT(low.farRadius, low.radius);
        EXPECT_GE(high.leastScale, low.leastScale);
        EXPECT_GE(high.mostScale, low.mostScale);
        EXPECT_GE(low.mostScale, low.leastScale);
    }
}

TEST(Quality, leavesZonesAsTheyWere) {
    world::LoadOptions load;
    load.mergeZones = false;
    const world::LoadOptions now = loadBy(kQualities.front(), load);
    EXPECT_FALSE(now.mergeZones);
    EXPECT_EQ(now.radius, kQualities.front().radius);
    EXPECT_EQ(now.farRadius, kQualities.front().farRadius);
}

TEST(Quality, multisamplesOnACardOnlyUnlessTheOptionsSayASampleCount) {
    gpu::Capabilities card, software;
    software.software = true;
    SessionOptions options;
    EXPECT_EQ(samplesOn(card, options), 1u);
    applyQuality(*qualityNamed("ultra"), options);
    EXPECT_EQ(samplesOn(card, options), 4u);
    EXPECT_EQ(samplesOn(software, options), 1u);
    options.samples = 4;
    EXPECT_EQ(samplesOn(software, options), 4u);
    options.samples = 1;
    EXPECT_EQ(samplesOn(card, options), 1u);
    applyQuality(*qualityNamed("ultra"), options); // a level replaces the single options
    EXPECT_EQ(samplesOn(card, options), 4u);
}

} // namespace
} // namespace limen::engine
