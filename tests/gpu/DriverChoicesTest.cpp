#include "gpu/DriverChoices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace limen::gpu {
namespace {

Capabilities card() {
    Capabilities capabilities;
    capabilities.bindless = true;
    return capabilities;
}

Capabilities software() {
    Capabilities capabilities;
    capabilities.software = true;
    return capabilities;
}

RendererOptions fast() {
    RendererOptions options;
    options.drawing = Drawing::Fast;
    options.textures.nearestLevel = true;
    return options;
}

std::string valueOf(const DriverChoices& choices, std::string_view name) {
    for (const DriverChoice& choice : describe(choices))
        if (choice.name == name)
            return choice.value;
    return "missing";
}

TEST(DriverChoices, aCardFiltersAndASoftwareRasteriserDoesNot) {
    const DriverChoices with = driverChoices(fast(), card(), 4),
                        without = driverChoices(fast(), software(), 1);
    EXPECT_EQ(with.anisotropy, 4.0f);
    EXPECT_FALSE(with.nearestLevel);
    EXPECT_EQ(with.samples, 4u);
    EXPECT_EQ(without.anisotropy, 1.0f);
    EXPECT_TRUE(without.nearestLevel);
    EXPECT_EQ(without.samples, 1u);
}

TEST(DriverChoices, pagesBySoftwareAreSelectedByIndexUnlessTexturesHaveHandles) {
    EXPECT_TRUE(driverChoices(fast(), software()).pagesByIndex);
    EXPECT_TRUE(driverChoices(fast(), software()).packsTerrain);
    EXPECT_FALSE(driverChoices({}, software()).packsTerrain);
    Capabilities both = software();
    both.bindless = true;
    EXPECT_FALSE(driverChoices(fast(), both).pagesByIndex);
    EXPECT_FALSE(driverChoices(fast(), both).packsTerrain);
    RendererOptions pages = fast();
    pages.textures.mode = TextureMode::ArrayPages;
    EXPECT_FALSE(driverChoices(pages, card()).pagesByIndex);
    EXPECT_TRUE(driverChoices(pages, both).pagesByIndex);
}

TEST(DriverChoices, texturesShareAnAtlasWherePagesAreSelectedByIndexAndDrawnFast) {
    EXPECT_TRUE(driverChoices(fast(), software()).atlas);
    EXPECT_FALSE(driverChoices({}, software()).atlas) << "exact frames keep their bytes";
    EXPECT_FALSE(driverChoices(fast(), card()).atlas);
    RendererOptions without = fast();
    without.textures.atlas = false;
    EXPECT_FALSE(driverChoices(without, software()).atlas);
}

TEST(DriverChoices, computePassesServeExactFramesOnly) {
    EXPECT_TRUE(driverChoices({}, card()).computes);
    EXPECT_EQ(driverChoices({}, card()).culling, Culling::Hidden);
    EXPECT_EQ(driverChoices({}, card(), 4).culling, Culling::None);
    EXPECT_FALSE(driverChoices(fast(), card()).computes);
    EXPECT_EQ(driverChoices(fast(), card()).culling, Culling::None);
}

TEST(DriverChoices, onlyAProcessorIsToldToBeginEarly) {
    EXPECT_TRUE(driverChoices(fast(), software()).overlaps);
    EXPECT_FALSE(driverChoices(fast(), card()).overlaps);
    EXPECT_FALSE(driverChoices({}, software()).overlaps);
}

TEST(DriverChoices, hiddenInstancesAreLeftOutWithoutACard) {
    EXPECT_TRUE(driverChoices(fast(), software()).occludes);
    EXPECT_FALSE(driverChoices(fast(), card()).occludes);
    EXPECT_FALSE(driverChoices({}, software()).occludes) << "exact frames prove what is hidden";
}

TEST(DriverChoices, openingsAreClearedWithoutACard) {
    EXPECT_TRUE(driverChoices(fast(), software()).rootFirst);
    EXPECT_FALSE(driverChoices(fast(), card()).rootFirst);
    EXPECT_FALSE(driverChoices({}, software()).rootFirst) << "exact frames test every fragment";
    RendererOptions compared = fast();
    compared.rootFirst = false;
    EXPECT_FALSE(driverChoices(compared, software()).rootFirst);
}

TEST(DriverChoices, everyDecisionIsListedOnceWithAReason) {
    std::set<std::string> names;
    for (const DriverChoice& choice : describe(driverChoices(fast(), software()))) {
        EXPECT_TRUE(names.insert(choice.name).second) << choice.name;
        EXPECT_FALSE(choice.value.empty());
        EXPECT_FALSE(std::string(choice.reason).empty());
    }
    const std::set<std::string> expected{
        "rasteriser",       "drawing",    "textures",         "pages_by_index", "packed_landcells",
        "mip_levels",       "anisotropy", "multisampling",    "draw_commands",  "early_start",
        "triangle_culling", "atlas",      "hidden_instances", "openings"};
    EXPECT_EQ(names, expected);
}

TEST(DriverChoices, textsFollowTheDecisions) {
    const DriverChoices without = driverChoices(fast(), software());
    EXPECT_EQ(valueOf(without, "rasteriser"), "software");
    EXPECT_EQ(valueOf(without, "mip_levels"), "nearest");
    EXPECT_EQ(valueOf(without, "anisotropy"), "off");
    EXPECT_EQ(valueOf(without, "pages_by_index"), "on");
    const DriverChoices with = driverChoices({}, card(), 4);
    EXPECT_EQ(valueOf(with, "rasteriser"), "graphics card");
    EXPECT_EQ(valueOf(with, "drawing"), "exact");
    EXPECT_EQ(valueOf(with, "textures"), "bindless");
    EXPECT_EQ(valueOf(with, "anisotropy"), "up to 4");
    EXPECT_EQ(valueOf(with, "multisampling"), "4 samples");
    EXPECT_EQ(valueOf(with, "triangle_culling"), "off");
}

} // namespace
} // namespace limen::gpu
