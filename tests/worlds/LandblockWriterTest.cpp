#include "worlds/records/LandblockWriter.h"
#include "geometry/Plane.h"
#include "worlds/shapes/RoomPlan.h"

#include <gtest/gtest.h>

// Plans of cells become the same links under the rules of built-in and of generated worlds.
namespace limen::worlds::test {
namespace {

/// Two rooms with a door between them; the northern one has a window in its north wall. A third room is behind the
/// southern one, its door in line with the others.
BuildingPlan threeRooms() {
    const Rect door{1.0, 0.0, 2.0, 2.0}, window{1.0, 1.0, 2.0, 2.0};
    BuildingPlan plan;
    plan.cells.push_back(roomWithOpenings({.name = "middle", .min = {0, 4, 0}, .max = {3, 8, 3}},
                                          {{Side::South, door}, {Side::North, door}}));
    plan.cells.push_back(roomWithOpenings({.name = "north", .min = {0, 8, 0}, .max = {3, 12, 3}},
                                          {{Side::South, door}, {Side::North, window}}));
    plan.cells.push_back(
        roomWithOpenings({.name = "south", .min = {0, 0, 0}, .max = {3, 4, 3}}, {{Side::North, door}}));
    for (CellPlan& cell : plan.cells)
        cell.eye = Vec3(1.5, 6.0, 1.5);
    plan.cells[1].eye = Vec3(1.5, 10.0, 1.5);
    plan.cells[2].eye = Vec3(1.5, 2.0, 1.5);
    plan.cells[2].statics.push_back({0x02000001u, {{1.0, 1.0, 0.0}, 90.0}});
    plan.exterior.add(flipped(portalFace(rectOnSide(Side::North, 12.0, window))));
    plan.exterior.box({0, 0, 3}, {3, 12, 4}, Material::StoneWall);
    return linkedByPoints(std::move(plan));
}

WorldRecords written(const CellRules& rules, int plans = 1) {
    WorldRecords records;
    ModelWriter writer(records);
    LandblockWriter block(writer, {3, 4}, rules);
    for (int k = 0; k < plans; ++k)
        EXPECT_EQ(block.add(threeRooms(), {{20.0 * k, 0.0, 0.0}, 0.0}).size(), 3u);
    EXPECT_FALSE(block.empty());
    block.finish();
    return records;
}

TEST(LinkedByPoints, pairsPortalsWithTheSamePoints) {
    const BuildingPlan plan = threeRooms();
    ASSERT_EQ(plan.cells[0].links.size(), 2u);
    EXPECT_EQ(plan.cells[0].links[0].cell, 2u);
    EXPECT_EQ(plan.cells[0].links[0].portal, 0u);
    EXPECT_EQ(plan.cells[0].links[1].cell, 1u);
    EXPECT_EQ(plan.cells[1].links[0].cell, 0u);
    EXPECT_EQ(plan.cells[1].links[0].portal, 1u);
    EXPECT_EQ(plan.cells[1].links[1].cell, CellLink::kOutside);
    ASSERT_EQ(plan.exits.size(), 1u);
    EXPECT_EQ(plan.exits[0].cell, 1u);
    EXPECT_EQ(plan.exits[0].portal, 1u);
}

TEST(LinkedByPointsDeathTest, anOpeningWithoutAPartnerFails) {
    BuildingPlan plan;
    plan.cells.push_back(roomWithOpenings({.name = "room", .min = {0, 0, 0}, .max = {3, 4, 3}},
                                          {{Side::North, {1.0, 0.0, 2.0, 2.0}}}));
    EXPECT_DEATH((void)linkedByPoints(plan), "leads to no other cell");
}

TEST(CellsWithin, countsOpenings) {
    const Neighbours chain{{1}, {0, 2}, {1, 3}, {2}};
    EXPECT_EQ(cellsWithin(chain, 0, 0), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(cellsWithin(chain, 1, 1), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(cellsWithin(chain, 3, kAnyStep), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(LandblockWriter, writesTheSameLinksUnderBothRules) {
    const WorldRecords builtIn = written(kBuiltInCells), generated = written(kGeneratedCells);
    ASSERT_EQ(builtIn.envCells.size(), 3u);
    ASSERT_EQ(generated.envCells.size(), 3u);
    for (std::size_t c = 0; c < 3; ++c) {
        const dat::EnvCell &a = builtIn.envCells[c], &b = generated.envCells[c];
        EXPECT_EQ(a.id, 0x03040100u + c);
        EXPECT_EQ(b.id, a.id);
        EXPECT_EQ(b.flags, a.flags);
        EXPECT_EQ(b.visibleCells, a.visibleCells);
        EXPECT_EQ(b.surfaces, a.surfaces);
        ASSERT_EQ(b.portals.size(), a.portals.size());
        for (std::size_t k = 0; k < a.portals.size(); ++k) {
            EXPECT_EQ(b.portals[k].otherCellId, a.portals[k].otherCellId);
            EXPECT_EQ(b.portals[k].otherPortalId, a.portals[k].otherPortalId);
            EXPECT_EQ(b.portals[k].polygonId, a.portals[k].polygonId);
            EXPECT_EQ(b.portals[k].flags, a.portals[k].flags);
        }
    }
    EXPECT_EQ(builtIn.envCells[2].flags, dat::EnvCell::kHasStatics | dat::EnvCell::kSeenOutside);
    ASSERT_EQ(builtIn.landBlockInfos.size(), 1u);
    ASSERT_EQ(builtIn.landBlockInfos[0].buildings.size(), 1u);
    EXPECT_EQ(builtIn.landBlockInfos[0].buildings[0].portals.at(0).otherCellId, 0x0101u);
    EXPECT_EQ(builtIn.landBlockInfos[0].numCells, 3u);
}

TEST(LandblockWriter, plansHaveOwnEnvironmentsOrShareThem) {
    EXPECT_EQ(written(kBuiltInCells, 2).environments.size(), 2u);
    EXPECT_EQ(written(kGeneratedCells, 2).environments.size(), 1u);
    EXPECT_EQ(written(kGeneratedCells, 2).envCells.back().cellStructure, 5u);
}

TEST(ShapeLibrary, storesReversedPortalsWithTheOppositeWinding) {
    BuildingPlan plan = threeRooms();
    plan.cells[0].links[1].insidePositive = false;
    WorldRecords records;
    ModelWriter writer(records);
    LandblockWriter(writer, {3, 4}, kGeneratedCells).add(plan, {});
    const auto normalOf = [&](std::size_t portal) {
        const dat::CellStruct& shape = records.environments.at(0).cells.at(0).second;
        std::vector<Vec3> points;
        for (const std::uint16_t key : shape.polygons.at(shape.portalPolygons[portal]).second.vertexKeys)
            points.emplace_back(shape.vertexArray.vertices.at(key).second.position);
        return planeOf(points).n;
    };
    EXPECT_GT(normalOf(0).y, 0.9); // south wall, looks into the room
    EXPECT_GT(normalOf(1).y, 0.9); // north wall, looks out of it
    EXPECT_EQ(records.envCells.at(0).portals.at(1).flags & dat::CellPortal::kPortalSide, 0u);
}

} // namespace
} // namespace limen::worlds::test
