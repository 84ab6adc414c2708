#include "motion/Locate.h"

#include "support/LoadTestWorld.h"

namespace limen::motion {
namespace {

using test::rectangle;
using test::TestWorld;
using world::kNone;
using world::kOutside;
using world::World;

/// A hut of two rooms with a door between them, a trapdoor to a cellar, and a front door; a dungeon cell far
/// off.
struct HutAlone {
    TestWorld source;
    TestWorld::Cell front = source.addBox({10, 10, 2}, {14, 14, 5}),
                    rear = source.addBox({14, 10, 2}, {18, 14, 5}),
                    cellar = source.addBox({10, 10, -1}, {14, 14, 2}),
                    dungeon = source.addBox({50, 50, -20}, {60, 60, -10});
    World world;
    HutAlone() {
        source.link(front, rectangle({14, 11, 2}, {14, 12, 4}), rear);
        source.link(front, rectangle({12, 12, 2}, {13, 13, 2}), cellar);
        const auto door = source.openOutside(front, rectangle({10, 11, 2}, {10, 12, 4}));
        source.addBuilding(test::boxExterior({10, 10, 2}, {18, 14, 5}), {door});
        source.setFlatTerrain(source.home(), 1);
        world = test::loadTestWorld(source);
    }
    [[nodiscard]] Vec3 at(double x, double y, double z) const { return test::toGlobal(source, {x, y, z}); }
};

TEST(Locate, findsTheCellOfABuildingElseTheOutside) {
    const HutAlone hut;
    EXPECT_EQ(locate(hut.world, hut.at(12, 12, 3)).space, 1u);
    EXPECT_EQ(locate(hut.world, hut.at(16, 12, 3)).space, 2u);
    EXPECT_EQ(locate(hut.world, hut.at(12, 12, 0)).space, 3u);
    EXPECT_EQ(locate(hut.world, hut.at(12, 12, 6)).space, kOutside);
    EXPECT_FALSE(locate(hut.world, hut.at(12, 12, 3)).ambiguous);
}

TEST(Locate, neverGuessesADungeonCell) {
    const HutAlone hut;
    EXPECT_TRUE(cellContains(hut.world, 4, hut.at(55, 55, -15)));
    EXPECT_EQ(locate(hut.world, hut.at(55, 55, -15)).space, kOutside);
}

TEST(Locate, saysWhenTwoCellsClaimThePlace) {
    HutAlone hut;
    const Located between =
        locate(hut.world, hut.at(14, 12, 3)); // in the plane of the door: both cells contain it
    EXPECT_EQ(between.space, 1u);
    EXPECT_TRUE(between.ambiguous);
    EXPECT_FALSE(locate(hut.world, hut.at(14.001, 12, 3)).ambiguous);
}

TEST(Locate, copesWithPositionsThatAreNotNumbers) {
    const HutAlone hut;
    EXPECT_EQ(locate(hut.world, Vec3(std::nan(""), 0, 0)).space, kOutside);
    EXPECT_FALSE(cellContains(hut.world, 1, Vec3(INFINITY)));
    EXPECT_FALSE(cellContains(hut.world, kOutside, hut.at(12, 12, 3)));
    EXPECT_FALSE(cellContains(hut.world, 999, hut.at(12, 12, 3)));
}

TEST(CellContains, reachesATenthOfAMillimetreBeyondItsWalls) {
    const HutAlone hut;
    EXPECT_TRUE(cellContains(hut.world, 1, hut.at(10, 10, 2)));
    EXPECT_TRUE(cellContains(hut.world, 1, hut.at(9.9999, 12, 3)));
    EXPECT_FALSE(cellContains(hut.world, 1, hut.at(9.9995, 12, 3)));
}

/// An L: the box 0..4 each way without the quarter x > 2, y > 2. In front of the plane x = 2 every point is
/// inside; behind it, the points south of y = 2 are.
world::World ell() {
    world::World world;
    world.spaces.resize(2);
    world.spaces[1].bspNodeCount = 4;
    world.cellBspNodes = {{{{0, 0, 1}, 0.0}, 1, kNone}, // above the floor
                          {{{-1, 0, 0}, 4.0}, 2, kNone},
                          {{{-1, 0, 0}, 2.0}, kNone, 3}, // x < 2: inside
                          {{{0, -1, 0}, 2.0}, kNone, kNone}};
    return world;
}

TEST(CellContains, goesOnBehindAPlaneOfACellThatIsNotConvex) {
    const world::World world = ell();
    EXPECT_TRUE(cellContains(world, 1, {1, 3, 1}));
    EXPECT_TRUE(cellContains(world, 1, {3, 1, 1})) << "behind a plane, and inside";
    EXPECT_FALSE(cellContains(world, 1, {3, 3, 1}));
    EXPECT_FALSE(cellContains(world, 1, {5, 1, 1}));
    EXPECT_FALSE(cellContains(world, 1, {1, 1, -1}));
}

TEST(CellContains, triesBothSidesOfAPlaneThatThePointLiesIn) {
    world::World world = ell();
    std::swap(world.cellBspNodes[2], world.cellBspNodes[3]); // now the front child is the longer branch
    world.cellBspNodes[2] = {{{-1, 0, 0}, 2.0}, 4, 3};
    world.cellBspNodes[3] = {{{0, -1, 0}, 2.0}, kNone, kNone};
    world.cellBspNodes.push_back({{{0, 1, 0}, -3.0}, kNone, kNone}); // x < 2 only north of y = 3
    world.spaces[1].bspNodeCount = 5;
    EXPECT_TRUE(cellContains(world, 1, {2.0, 1.0, 1.0}));
    EXPECT_TRUE(cellContains(world, 1, {2.0, 3.5, 1.0}));
    EXPECT_FALSE(cellContains(world, 1, {2.0, 2.5, 1.0}));
}

TEST(CellContains, readsNegativeChildrenOfRecords) {
    HutAlone hut;
    dat::BspNode x, y, leaf;
    x.tag = dat::BspTag::BPIN;
    x.plane = {Vec3f(-1, 0, 0), 16.0f};
    x.positive = 1;
    x.negative = 2;
    y.tag = dat::BspTag::BPIn;
    y.plane = {Vec3f(0, -1, 0), 12.0f};
    y.positive = 3;
    TestWorld::CellOptions options;
    options.tree = dat::BspTree{{x, leaf, y, leaf}};
    const TestWorld::Cell odd = hut.source.addBox({14, 20, 2}, {18, 24, 5}, "grey", options);
    const world::World world = test::loadTestWorld(hut.source);
    const world::SpaceIndex space = world::findCell(world, hut.source.id(odd));
    EXPECT_TRUE(cellContains(world, space, hut.at(15, 22, 3)));
    EXPECT_TRUE(cellContains(world, space, hut.at(17, 11, 3)));
    EXPECT_FALSE(cellContains(world, space, hut.at(17, 22, 3)));
}

TEST(Sweep, followsPortalsBothWays) {
    const HutAlone hut;
    const Vec3 yard = hut.at(5, 11.5, 3), front = hut.at(12, 11.5, 3), rear = hut.at(17, 11.5, 3);
    EXPECT_EQ(sweep(hut.world, kOutside, yard, front), 1u);
    EXPECT_EQ(sweep(hut.world, kOutside, yard, rear), 2u);
    EXPECT_EQ(sweep(hut.world, 2, rear, yard), kOutside);
    EXPECT_EQ(sweep(hut.world, 1, front, front), 1u);
    EXPECT_EQ(sweep(hut.world, 1, hut.at(12.5, 12.5, 3), hut.at(12.5, 12.5, 0)), 3u);
    EXPECT_EQ(sweep(hut.world, 3, hut.at(12.5, 12.5, 0), hut.at(12.5, 12.5, 3)), 1u);
}

TEST(Sweep, staysInItsSpaceWhereItMissesTheOpening) {
    const HutAlone hut;
    EXPECT_EQ(sweep(hut.world, 1, hut.at(12, 13, 3), hut.at(17, 13, 3)), 1u);
    EXPECT_EQ(sweep(hut.world, kOutside, hut.at(5, 13, 3), hut.at(17, 13, 3)), kOutside);
}

TEST(Sweep, countsTheEdgeOfAnOpeningAsOpen) {
    const HutAlone hut;
    EXPECT_EQ(sweep(hut.world, 1, hut.at(13, 12, 3), hut.at(15, 12, 3)), 2u);
    EXPECT_EQ(sweep(hut.world, 1, hut.at(13, 12.01, 3), hut.at(15, 12.01, 3)), 1u);
}

TEST(Sweep, neverPassesTheSameOpeningBackAtOnce) {
    const HutAlone hut;
    const Vec3 inPlane = hut.at(14, 11.5, 3);
    EXPECT_EQ(sweep(hut.world, 1, inPlane, hut.at(14.001, 11.5, 3)), 2u);
    EXPECT_EQ(sweep(hut.world, 2, inPlane, hut.at(13.999, 11.5, 3)), 1u);
    EXPECT_EQ(sweep(hut.world, 1, inPlane, hut.at(14, 11.6, 3)), 1u) << "a movement within the plane stays";
    // Steps of a tenth of a millimetre through the door change the space exactly once.
    world::SpaceIndex space = 1;
    int changes = 0;
    for (int i = -50; i < 50; ++i) {
        const world::SpaceIndex next =
            sweep(hut.world, space, hut.at(14 + i * 1e-4, 11.5, 3), hut.at(14 + (i + 1) * 1e-4, 11.5, 3));
        changes += next != space ? 1 : 0;
        space = next;
    }
    EXPECT_EQ(space, 2u);
    EXPECT_EQ(changes, 1);
}

TEST(Sweep, copesWithBadInput) {
    const HutAlone hut;
    EXPECT_EQ(sweep(hut.world, 1, hut.at(12, 12, 3), Vec3(std::nan(""))), 1u);
    EXPECT_EQ(sweep(hut.world, 77, hut.at(12, 12, 3), hut.at(12, 12, 4)), 77u);
    EXPECT_EQ(sweep(World{}, kOutside, {}, {}), kOutside);
}

} // namespace
} // namespace limen::motion
