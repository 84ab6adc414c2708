#include "engine/report/Picked.h"
#include "support/SmallWorld.h"

#include <gtest/gtest.h>

#include <limits>

namespace limen::engine {
namespace {

using test::smallWorld;
using test::twoVisits;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Picked, tellsThePolygonItsObjectAndTheWayThere) {
    const world::World world = smallWorld();
    const IdTable table(world);
    visibility::VisibleSet visible = twoVisits();
    visible.regionVertices[4] = {0, 0, 4};
    const Picked picked = pickedPixel(world, table, {}, visible, 5, 1, 2.5);
    EXPECT_EQ(picked.object, 0x1122u);
    EXPECT_FALSE(picked.isLandscape);
    EXPECT_EQ(pickedLines(picked), (std::vector<std::string>{"shell 0xA9B40105, polygon 20",
                                                             "object 0000000000001122, placed in 0xA9B40105",
                                                             "2.50 m away", "0 0xA9B40105, the eye's, 100 %",
                                                             "1 outside, portal 2 of 0xA9B40105, 6.25 %"}));
}

TEST(Picked, namesAPlacedObject_itsTemplate_andItsCell) {
    world::World world = smallWorld();
    world::PlacedObject gate;
    gate.object = 0x1122;
    gate.name = "Old Gate 7C000001";
    gate.templateId = 412;
    world::PlacedObject other = gate;
    other.object = 0x3344;
    other.name = "Other";
    world.placed = {other, gate};
    const IdTable table(world);
    const std::vector<std::string> lines = pickedLines(pickedPixel(world, table, {}, twoVisits(), 5, 1, 2.5));
    ASSERT_GE(lines.size(), 3u);
    EXPECT_EQ(lines[0], "Old Gate 7C000001, template 412");
    EXPECT_EQ(lines[2], "object 0000000000001122, placed in 0xA9B40105");
}

TEST(Picked, aBlocksTerrainIsLandscape) {
    const world::World world = smallWorld();
    const IdTable table(world);
    EXPECT_TRUE(pickedPixel(world, table, {}, twoVisits(), 3, 0, 1.0).isLandscape);
}

TEST(Picked, theSkyIsNobodysAndNowhere) {
    const world::World world = smallWorld();
    const IdTable table(world);
    const Picked picked = pickedPixel(world, table, {}, twoVisits(), kSkyPixel, 0, kInfinite);
    EXPECT_EQ(picked.object, 0u);
    EXPECT_EQ(pickedLines(picked), (std::vector<std::string>{"sky", "0 0xA9B40105, the eye's, 100 %"}));
}

TEST(Picked, ofAVisitThatIsNotThereThereIsNoChain) {
    const world::World world = smallWorld();
    const IdTable table(world);
    EXPECT_TRUE(pickedPixel(world, table, {}, twoVisits(), 5, 7, 1.0).chain.empty());
}

} // namespace
} // namespace limen::engine
