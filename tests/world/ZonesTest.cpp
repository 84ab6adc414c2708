#include "support/LoadTestWorld.h"

#include <ctime>
#include <gmock/gmock.h>

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;

TEST(Zones, overlappingCellsStartZonesOfTheirOwn) {
    // A corridor of three pieces that ends inside the first room.
    TestWorld source;
    const auto room = source.addBox({0, 0, 0}, {6, 6, 3}), east = source.addBox({6, 0, 0}, {10, 6, 3});
    const auto back = source.addBox({3, 1, 0}, {10, 5, 3}); // overlaps both
    source.link(room, rectangle({6, 1, 0}, {6, 2, 2}), east);
    source.link(east, rectangle({10, 1, 0}, {10, 2, 2}), back, [] {
        TestWorld::LinkOptions options;
        options.exact = false;
        return options;
    }());
    source.link(east, rectangle({7, 0, 0}, {8, 0, 2}), source.addBox({6.5, -4, 0}, {9, 0, 3}));
    const World world = test::loadTestWorld(source);
    EXPECT_EQ(world.spaces[1].zone, world.spaces[2].zone);
    EXPECT_NE(world.spaces[3].zone, world.spaces[1].zone);
    EXPECT_EQ(world.spaces[4].zone, world.spaces[1].zone);
}

TEST(Zones, noCellIsBehindAnOpeningOfItsZoneThatLeadsElsewhere) {
    TestWorld source;
    // From a up into a loft, and down again into a closet in the middle of a.
    const auto a = source.addBox({0, 0, 0}, {6, 6, 3}), loft = source.addBox({0, 0, 3}, {6, 6, 6}),
               closet = source.addBox({2, 2, 0}, {4, 4, 3});
    source.link(a, rectangle({0, 0, 3}, {1, 1, 3}), loft);
    source.link(loft, rectangle({2.5, 2.5, 3}, {3.5, 3.5, 3}), closet);
    const World world = test::loadTestWorld(source);
    EXPECT_TRUE(world.portals[world.spaces[3].firstPortal].exact);
    EXPECT_NE(world.spaces[3].zone, world.spaces[1].zone)
        << "they overlap, although the portals to it are exact";
    // Rays from the closet come into the loft where the ceiling of a is. Picture: CasesNear.case45_aHatch...
    EXPECT_NE(world.spaces[1].zone, world.spaces[2].zone);
}

TEST(Zones, noOverlappingCellTouchesAnOpeningOfItsZoneFromBefore) {
    // Rooms around a vertical line, the first in the place of the last. Picture: CasesNear.case45_aRoomTouches...
    TestWorld source;
    const auto last = source.addBox({-6, -6, 0}, {0, 0, 3}), fourth = source.addBox({-6, 0, 0}, {0, 5, 3}),
               third = source.addBox({0, 0, 0}, {5, 5, 3}), second = source.addBox({0, -6, 0}, {5, 0, 3});
    source.link(second, rectangle({0, 0, 0}, {2, 0, 2}), third);
    source.link(third, rectangle({0, 0, 0}, {0, 2, 2}), fourth);
    source.link(fourth, rectangle({-2, 0, 0}, {0, 0, 2}), last);
    const World apart = test::loadTestWorld(source);
    for (int space = 2; space <= 4; ++space)
        EXPECT_EQ(apart.spaces[space].zone, apart.spaces[1].zone) << "no cell overlaps another";
    const auto first = source.addBox({-5, -5, 0}, {0, 0, 3});
    source.link(first, rectangle({0, -2, 0}, {0, 0, 2}), second);
    const World world = test::loadTestWorld(source);
    EXPECT_NE(world.spaces[3].zone, world.spaces[1].zone)
        << "its opening to the second has a wall of the last at its edge";
}

TEST(Zones, aCellThatIsNotClosedIsAloneAndReported) {
    TestWorld source;
    const auto a = source.addBox({0, 0, 0}, {4, 4, 3}), b = source.addBox({4, 0, 0}, {8, 4, 3});
    source.link(a, rectangle({4, 1, 0}, {4, 2, 2}), b);
    source.walls(b).pop_back();
    const World world = test::loadTestWorld(source);
    EXPECT_NE(world.spaces[1].zone, world.spaces[2].zone);
    EXPECT_THAT(test::findingsOf(world), testing::HasSubstr("not closed"));
}

TEST(Zones, pillarsAndTwoSidedPartitionsDoNotOpenACell) {
    TestWorld source;
    const auto a = source.addBox({0, 0, 0}, {4, 4, 3}), b = source.addBox({4, 0, 0}, {8, 4, 3});
    source.link(a, rectangle({4, 1, 0}, {4, 2, 2}), b);
    for (int i = 0; i < 4; ++i) { // a pillar from floor to ceiling, without top and bottom
        const test::Walls pillar = test::boxExterior({1.5, 1.5, 0}, {2, 2, 3});
        source.walls(a).push_back(pillar[static_cast<std::size_t>(test::kSouth + i)]);
    }
    source.walls(b).push_back({{{6, 1, 0}, {6, 3, 0}, {6, 3, 2}, {6, 1, 2}}, "screen", true});
    const World world = test::loadTestWorld(source);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    EXPECT_EQ(world.spaces[1].zone, world.spaces[2].zone);
}

TEST(Zones, aLargeDungeonIsOneZoneAndLoadsQuickly) {
    constexpr int kSide = 60; // 3,600 cells
    TestWorld source;
    std::vector<TestWorld::Cell> cells;
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) {
            const double left = x * 10.0 - 300.0, south = y * -10.0;
            cells.push_back(source.addBox({left, south, -12}, {left + 10, south + 10, -6}));
            if (x > 0)
                source.link(cells[cells.size() - 1 - kSide],
                            rectangle({left, south + 4, -12}, {left, south + 6, -9}), cells.back());
            if (y > 0)
                source.link(cells[cells.size() - 2],
                            rectangle({left + 4, south + 10, -12}, {left + 6, south + 10, -9}), cells.back());
        }
    }
    const test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    const std::clock_t start = std::clock(); // processor time: the machine may be busy
    const auto world = loadWorld(*archive, source.home(), {});
    const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    ASSERT_TRUE(world);
    EXPECT_EQ(world->spaces.size(), 1u + kSide * kSide);
    EXPECT_EQ(world->zones.size(), 2u);
    EXPECT_TRUE(world->findings.empty())
        << world->findings.size() << " findings, first: " << world->findings.front().what;
    RecordProperty("seconds", std::to_string(taken));
    EXPECT_LT(taken, 20.0) << "loading has become quadratic";
}

} // namespace
} // namespace limen::world
