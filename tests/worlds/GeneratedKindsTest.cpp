// The special properties of each kind of generated world.
#include "world/terrain/Terrain.h"
#include "worlds/GeneratedWorlds.h"
#include "worlds/generate/DungeonLayout.h"

#include <chrono>
#include <map>
#include <set>

namespace limen::worlds::test {
namespace {

std::size_t overlapsOf(const world::World& world) {
    std::size_t overlaps = 0;
    for (std::size_t a = 1; a < world.spaces.size(); ++a) {
        for (std::size_t b = a + 1; b < world.spaces.size(); ++b) {
            const Vec3 common = glm::min(world.spaces[a].bounds.max, world.spaces[b].bounds.max) -
                                glm::max(world.spaces[a].bounds.min, world.spaces[b].bounds.min);
            overlaps += std::min({common.x, common.y, common.z}) > 0.05 ? 1 : 0;
        }
    }
    return overlaps;
}

TEST(GeneratedDungeon, hasLoopsDeadEndsRampsShaftsAndTwinOpenings) {
    const GeneratedWorld generated({GeneratedKind::Dungeon, 300, 3});
    const world::World world = generated.load(generated.blocks().at(0));
    std::size_t pairs = 0, deadEnds = 0, horizontal = 0, sloped = 0;
    std::set<std::pair<world::SpaceIndex, world::SpaceIndex>> joined;
    std::map<std::pair<world::SpaceIndex, world::SpaceIndex>, int> openings;
    for (const world::Portal& portal : world.portals) {
        openings[{portal.space, portal.destination}] += 1;
        joined.insert(std::minmax(portal.space, portal.destination));
        horizontal += std::abs(portal.plane.n.z) > 0.99 ? 1 : 0;
    }
    for (const auto& [between, count] : openings)
        pairs += count == 2 ? 1 : 0;
    std::vector<int> neighbours(world.spaces.size(), 0);
    for (const auto& [a, b] : joined) {
        ++neighbours[a];
        ++neighbours[b];
    }
    for (std::size_t s = 1; s < world.spaces.size(); ++s)
        deadEnds += neighbours[s] == 1 ? 1 : 0;
    for (const world::MeshVertex& vertex : world.vertices)
        sloped += vertex.normal.z > 0.5f && vertex.normal.z < 0.999f ? 1 : 0;
    EXPECT_GT(joined.size(), world.spaces.size()) << "no loops";
    EXPECT_GT(pairs, 10u);
    EXPECT_GT(deadEnds, 10u);
    EXPECT_GT(horizontal, 10u);
    EXPECT_GT(sloped, 10u);
}

TEST(GeneratedMap, isTheWholeMapWithTownsAndDungeons) {
    const GeneratedWorld generated({GeneratedKind::Map, 3000, 2});
    std::size_t land = 0, dungeons = 0, cells = 0;
    for (const dat::BlockCoord coord : generated.blocks()) {
        const auto info = generated.archive().load<dat::LandBlockInfo>(dat::landBlockInfoId(coord));
        const auto block = generated.archive().load<dat::LandBlock>(dat::landBlockId(coord));
        ASSERT_TRUE(block);
        ASSERT_EQ(block->hasObjects != 0, info.has_value());
        cells += info ? info->numCells : 0;
        const bool isDungeon = world::isDungeon(generated.archive(), coord);
        dungeons += isDungeon ? 1 : 0;
        land += isDungeon ? 0 : 1;
    }
    EXPECT_EQ(land + dungeons, 255u * 255u);
    EXPECT_EQ(dungeons, 14u) << "of 200 cells each";
    EXPECT_NEAR(static_cast<double>(cells), 3000.0, 100.0);
    for (const char* name : {"middle", "east", "north", "town", "room."}) {
        const auto& places = generated.file().places;
        const auto place = std::find_if(places.begin(), places.end(),
                                        [&](const auto& p) { return p.name.starts_with(name); });
        ASSERT_NE(place, places.end()) << name;
        const dat::BlockCoord coord =
            place->cell != 0 ? dat::blockOf(place->cell) : world::blockAt(place->eye);
        const world::World world = generated.load(coord, true, place->cell != 0 ? 0 : 1);
        EXPECT_TRUE(world.findings.empty()) << name;
        EXPECT_EQ(world.spaces.size() > 1, std::string_view(name) == "town" || place->cell != 0) << name;
        if (place->cell == 0) { // eye height above the heights of the records
            constexpr double kAbove = 1.7 + world::kLandBelowHeights;
            EXPECT_NEAR(place->eye.z - world::terrainHeight(world, place->eye.x, place->eye.y), kAbove, 0.01)
                << name;
        }
    }
}

TEST(GeneratedDungeon, overlapsAsMuchAsAskedFor) {
    for (const double share : {0.0, 0.02, 0.05}) {
        const DungeonLayout layout = layOutDungeon(3000, share, Random(7));
        EXPECT_EQ(layout.cells, 3000u);
        EXPECT_NEAR(layout.crossings, share * 3000.0, 0.1 * share * 3000.0 + 1.0);
    }
    GeneratedSpec spec{GeneratedKind::Dungeon, 1000, 3, 0.0};
    const GeneratedWorld apart(spec);
    spec.overlapShare = 0.05;
    const GeneratedWorld crossing(spec);
    EXPECT_EQ(overlapsOf(apart.load(apart.blocks().at(0))), 0u);
    EXPECT_GT(overlapsOf(crossing.load(crossing.blocks().at(0))), 20u);
}

TEST(GeneratedDungeon, beyondALandblockFillsSeveralInBoundedTime) {
    const auto begin = std::chrono::steady_clock::now();
    const GeneratedWorld generated({GeneratedKind::Dungeon, 65000, 1});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(taken.count(), 60.0);
    ASSERT_EQ(generated.blocks().size(), 2u);
    std::size_t cells = 0;
    for (const dat::BlockCoord block : generated.blocks()) {
        const auto info = generated.archive().load<dat::LandBlockInfo>(dat::landBlockInfoId(block));
        ASSERT_TRUE(info.has_value());
        cells += info->numCells;
        EXPECT_TRUE(generated.archive().contains<dat::EnvCell>(dat::blockWord(block) |
                                                               (dat::kFirstCell + info->numCells - 1)));
    }
    EXPECT_EQ(cells, 65000u);
}

TEST(GeneratedTown, everyHouseHasAFrontDoorAndAWindowAtTheBack) {
    const GeneratedWorld generated({GeneratedKind::Town, 45, 2});
    ASSERT_EQ(generated.blocks().size(), 4u); // two by two
    std::size_t houses = 0, turned = 0;
    for (const dat::BlockCoord block : generated.blocks()) {
        const auto info = generated.archive().load<dat::LandBlockInfo>(dat::landBlockInfoId(block));
        ASSERT_TRUE(info.has_value());
        houses += info->buildings.size();
        for (const dat::Building& building : info->buildings) {
            EXPECT_GE(building.portals.size(), 2u);
            const float z = std::abs(building.frame.orientation.z);
            turned += z > 0.01f && std::abs(z - 1.0f) > 0.01f && std::abs(z - 0.70711f) > 0.01f ? 1 : 0;
        }
    }
    EXPECT_EQ(houses, 45u);
    EXPECT_GT(turned, 5u);
    EXPECT_GT(generated.file().moving.doors.size(), 30u);
    const world::World world = generated.load(generated.blocks().front(), true, 2);
    EXPECT_EQ(world.doors.size(), generated.file().moving.doors.size());
    EXPECT_EQ(limen::test::findingsOf(world), "");
}

TEST(GeneratedTown, groundStaysBelowTheFloors) {
    const GeneratedWorld generated({GeneratedKind::Town, 20, 6});
    const world::World world = generated.load(generated.blocks().front());
    std::size_t cellars = 0;
    for (std::size_t s = 1; s < world.spaces.size(); ++s) {
        const Aabb& box = world.spaces[s].bounds;
        const Vec3 middle = box.centre();
        const double ground = world::terrainHeight(world, middle.x, middle.y);
        cellars += ground > box.max.z - 0.6 ? 1 : 0;
        for (const double x : {box.min.x + 1.0, middle.x, box.max.x - 1.0}) {
            const double below = world::terrainHeight(world, x, middle.y);
            EXPECT_TRUE(below < box.min.z || below > box.min.z + 1.5) << "the ground runs through a floor";
        }
    }
    EXPECT_GT(cellars, 0u);
}

TEST(GeneratedComplex, seedsDifferInWhatTheyAreMadeOf) {
    std::size_t inexact = 0, toGround = 0, negative = 0, slivers = 0, sharedEdges = 0, twelve = 0;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        const GeneratedWorld generated({GeneratedKind::Complex, 30, seed});
        const world::World world = generated.load(generated.blocks().at(0));
        toGround += world.spaces[world::kOutside].portalCount > 0 ? 1 : 0;
        for (const world::Portal& portal : world.portals) {
            inexact += portal.exact ? 0 : 1;
            const std::span<const Vec3> corners = world::cornersOf(world, portal);
            twelve += corners.size() >= 12 ? 1 : 0;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                slivers +=
                    corners.size() == 4 && glm::length(corners[i] - corners[(i + 1) % 4]) < 0.0102 ? 1 : 0;
            }
        }
        for (const world::Space& space : world.spaces) {
            std::map<std::pair<double, double>, int> seen;
            for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p)
                for (const Vec3& corner : world::cornersOf(world, world.portals[p]))
                    sharedEdges += seen[{corner.x, corner.y}]++ > 0 ? 1 : 0;
        }
        const dat::RecordId first = dat::blockWord(generated.blocks().at(0)) | dat::kFirstCell;
        for (dat::RecordId id = first; id < first + 30; ++id) {
            const auto cell = generated.archive().load<dat::EnvCell>(id);
            ASSERT_TRUE(cell.has_value());
            for (const dat::CellPortal& portal : cell->portals)
                negative += (portal.flags & dat::CellPortal::kPortalSide) == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(inexact, 4u);
    EXPECT_GT(toGround, 1u);
    EXPECT_LT(toGround, 11u);
    EXPECT_GT(negative, 50u);
    EXPECT_GT(slivers, 10u);
    EXPECT_GT(sharedEdges, 50u);
    EXPECT_GT(twelve, 5u);
}

TEST(GeneratedTerrain, groundRunsThroughCells) {
    const GeneratedWorld generated({GeneratedKind::Terrain, 12, 4});
    std::size_t pierced = 0, buried = 0, cells = 0;
    for (const dat::BlockCoord block : generated.blocks()) {
        const world::World world = generated.load(block);
        for (std::size_t s = 1; s < world.spaces.size(); ++s) {
            const Aabb& box = world.spaces[s].bounds;
            bool through = false, above = true;
            for (int k = 0; k < 25; ++k) {
                const Vec3 t((k % 5 + 0.5) / 5.0, (k / 5 + 0.5) / 5.0, 0.0);
                const Vec3 p = glm::mix(box.min, box.max, t);
                const double ground = world::terrainHeight(world, p.x, p.y);
                through = through || (ground > box.min.z + 0.1 && ground < box.max.z - 0.1);
                above = above && ground > box.max.z;
            }
            pierced += through ? 1 : 0;
            buried += above ? 1 : 0;
            ++cells;
        }
    }
    EXPECT_GT(cells, 30u);
    EXPECT_GT(pierced, 6u);
    EXPECT_GE(buried, 6u);
}

TEST(GeneratedWorlds, showTheSameSpacesMergedAndApart) {
    for (const GeneratedKind kind :
         {GeneratedKind::Dungeon, GeneratedKind::Town, GeneratedKind::Complex, GeneratedKind::Terrain,
          GeneratedKind::Skewed, GeneratedKind::Thin, GeneratedKind::Nested}) {
        const GeneratedWorld generated({kind, 12, 2});
        const world::World merged = generated.load(generated.blocks().at(0), true);
        const world::World apart = generated.load(generated.blocks().at(0), false);
        EXPECT_EQ(merged.spaces.size(), apart.spaces.size());
        EXPECT_EQ(apart.zones.size(), apart.spaces.size());
        EXPECT_LT(merged.zones.size(), apart.zones.size()) << nameOf(generated.spec());
    }
}

} // namespace
} // namespace limen::worlds::test
