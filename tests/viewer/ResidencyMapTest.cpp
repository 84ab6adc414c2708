#include "viewer/inspect/ResidencyMap.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

using State = ResidentBlock::State;

/// Terrain at (10, 20) with two cells and a building portal; a dungeon at (11, 20) of one cell; far away,
/// terrain.
world::World someWorld() {
    world::World world;
    world.blocks.resize(3);
    world.blocks[0].coord = {10, 20};
    world.blocks[1].coord = {11, 20};
    world.blocks[2].coord = {40, 20};
    world.blocks[0].hasTerrain = world.blocks[2].hasTerrain = true;
    world.spaces.resize(4);
    world.spaces[1].block = world.spaces[2].block = 0;
    world.spaces[1].cellId = 0x0A140100;
    world.spaces[3].block = 1;
    world.spaces[3].cellId = 0x0B140100;
    world.portals.resize(2);
    world.portals[0].space = world::kOutside;
    world.portals[0].block = 0;
    world.portals[1].space = 1; // leads outside: not a building portal
    world.portals[1].block = 0;
    return world;
}

TEST(ResidencyMap, northIsUpAndTheEyesBlockInTheMiddle) {
    const ResidencyMap map = residencyMap(someWorld(), {10, 20}, {10, 21}, 1);
    ASSERT_EQ(map.side, 3);
    ASSERT_EQ(map.blocks.size(), 9u);
    EXPECT_EQ(map.blocks[0].coord, (dat::BlockCoord{9, 21}));
    EXPECT_EQ(map.blocks[8].coord, (dat::BlockCoord{11, 19}));
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(map.blocks[i].holdsEye, i == 4) << i;
        EXPECT_EQ(map.blocks[i].holdsPlayer, i == 1) << i;
        EXPECT_EQ(map.blocks[i].state, i == 4 || i == 5 ? State::Loaded : State::Absent) << i;
    }
}

TEST(ResidencyMap, tellsOfEachBlockWhatItHoldsAndCountsAll) {
    const ResidencyMap map = residencyMap(someWorld(), {10, 20}, {10, 20}, 1);
    EXPECT_TRUE(map.blocks[4].hasTerrain);
    EXPECT_EQ(map.blocks[4].cells, 2u);
    EXPECT_EQ(map.blocks[4].buildingPortals, 1u);
    EXPECT_FALSE(map.blocks[5].hasTerrain);
    EXPECT_EQ(map.blocks[5].cells, 1u);
    EXPECT_EQ(map.loaded, 3u) << "one loaded block is not on the map";
    EXPECT_EQ(map.terrains, 2u);
    EXPECT_EQ(map.cells, 3u);
    EXPECT_EQ(map.buildingPortals, 1u);
}

TEST(ResidencyMap, atTheEdgeOfTheMapThereIsNothingBeyond) {
    const ResidencyMap map = residencyMap(someWorld(), {0, 254}, {0, 254}, 1);
    EXPECT_EQ(map.blocks[0].coord, (dat::BlockCoord{-1, 255}));
    for (const ResidentBlock& block : map.blocks)
        EXPECT_EQ(block.state, State::Absent);
    EXPECT_EQ(residencyMap(world::World(), {3, 3}, {3, 3}, 0).blocks.size(), 1u);
}

TEST(ResidencyMap, acellBelongsToItsOwnBlockWhereverItsCoordinatesAre) {
    EXPECT_EQ(blockOf(someWorld(), 3, {0, 0, 0}), (dat::BlockCoord{11, 20}));
    EXPECT_EQ(blockOf(someWorld(), world::kOutside, {192.0 * 7 + 1, 192.0 * 9 + 1, 0}),
              (dat::BlockCoord{7, 9}));
}

} // namespace
} // namespace limen::viewer
