// Properties of generated worlds of every kind, size and seed.
#include "motion/Locate.h"
#include "world/OpeningParts.h"
#include "worlds/GeneratedWorlds.h"

#include <fmt/format.h>
#include <fstream>
#include <random>

namespace limen::worlds::test {
namespace {

std::vector<GeneratedSpec> specs() {
    std::vector<GeneratedSpec> out;
    for (std::uint32_t seed = 1; seed <= 30; ++seed) {
        out.push_back({GeneratedKind::Dungeon, seed * 3 % 47 + 1, seed});
        out.push_back({GeneratedKind::Town, seed % 7 + 1, seed});
        out.push_back({GeneratedKind::Complex, seed * 5 % 37 + 1, seed});
        out.push_back({GeneratedKind::Terrain, seed % 6 + 1, seed});
        out.push_back({GeneratedKind::Skewed, seed * 5 % 37 + 1, seed});
        out.push_back({GeneratedKind::Thin, seed * 3 % 29 + 1, seed});
        out.push_back({GeneratedKind::Nested, seed * 7 % 41 + 1, seed});
    }
    for (std::uint32_t seed = 1; seed <= 2; ++seed)
        for (const GeneratedKind kind : {GeneratedKind::Dungeon, GeneratedKind::Town})
            out.push_back({kind, 11 * seed, seed, 0.02, true});
    return out;
}

class EveryGeneratedWorld : public ::testing::TestWithParam<GeneratedSpec> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryGeneratedWorld, ::testing::ValuesIn(specs()), [](const auto& spec) {
    std::string name = nameOf(spec.param);
    std::erase_if(name, [](char c) { return c == ','; });
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

/// The number of corners at which a portal's outline bends; others only match vertices of neighbours.
std::size_t bendsOf(std::span<const Vec3> corners) {
    std::size_t bends = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& a = corners[i];
        const Vec3 along = glm::normalize(corners[(i + 2) % corners.size()] - a);
        bends += glm::length(glm::cross(corners[(i + 1) % corners.size()] - a, along)) > 0.0005 ? 1 : 0;
    }
    return bends;
}

/// Whether a portal is walled, or leads to a space with a walled portal back: such pairs are one-way portals.
bool isOfWalledPair(const world::World& world, const world::Portal& portal) {
    return portal.walled ||
           std::any_of(world.portals.begin(), world.portals.end(), [&](const world::Portal& back) {
               return back.walled && back.space == portal.destination && back.destination == portal.space;
           });
}

/// Expects every portal to have a reciprocal, but for walled ones and those against them.
/// `mostBends`: of an outline. Rounding bends an outline at vertices of neighbours, too.
void expectPaired(const world::World& world, std::size_t mostBends) {
    for (world::PortalIndex p = 0; p < world.portals.size(); ++p) {
        const world::Portal& portal = world.portals[p];
        if (portal.destination ==
            world::kNone) { // a part that one polygon of a bent inexact pair has (decision 207)
            ASSERT_NE(portal.whole, world::kNone);
            EXPECT_FALSE(portal.exact && portal.reciprocal != world::kNone);
            continue;
        }
        ASSERT_TRUE(portal.reciprocal != world::kNone || isOfWalledPair(world, portal));
        EXPECT_TRUE(portal.reciprocal == world::kNone || !portal.walled);
        EXPECT_GE(bendsOf(world::cornersOf(world, openingOf(world, p))), 3u);
        EXPECT_LE(bendsOf(world::cornersOf(world, openingOf(world, p))), mostBends);
    }
}

std::size_t cellsOf(const world::World& world) {
    return world.spaces.size() - 1;
}

/// Points around a block's cells: those inside a cell's tree are in the cell's bounds.
void expectTreesHoldNothingFarOff(const world::World& world, std::uint32_t seed) {
    constexpr double kSlack = 0.02; // metres
    std::mt19937 random(seed);
    std::uniform_real_distribution<> offset(-30.0, 30.0);
    for (world::SpaceIndex s = 1; s < world.spaces.size(); ++s) {
        const Aabb& bounds = world.spaces[s].bounds;
        for (int i = 0; i < 200; ++i) {
            const Vec3 at = bounds.centre() + Vec3(offset(random), offset(random), offset(random));
            const bool isNear = glm::all(glm::greaterThan(at, bounds.min - kSlack)) &&
                                glm::all(glm::lessThan(at, bounds.max + kSlack));
            EXPECT_TRUE(isNear || !motion::cellContains(world, s, at)) << s;
        }
    }
}

void expectPlacesInTheirCells(const GeneratedWorld& generated, const world::World& world,
                              dat::BlockCoord block) {
    for (const world::Place& place : generated.file().places) {
        if (place.cell == 0 || !(dat::blockOf(place.cell) == block))
            continue;
        const world::SpaceIndex space = world::findCell(world, place.cell);
        ASSERT_NE(space, world::kNone) << place.name;
        EXPECT_TRUE(motion::cellContains(world, space, place.eye)) << place.name;
    }
}

TEST_P(EveryGeneratedWorld, loadsWithoutFindingsAndHangsTogether) {
    const GeneratedWorld generated(GetParam());
    ASSERT_FALSE(generated.blocks().empty());
    EXPECT_FALSE(generated.file().places.empty());
    std::size_t cells = 0;
    for (const dat::BlockCoord block : generated.blocks()) {
        const world::World world = generated.load(block);
        EXPECT_EQ(limen::test::findingsOf(world), "");
        expectPaired(world, GetParam().kind == GeneratedKind::Skewed ? 24 : 12);
        expectPlacesInTheirCells(generated, world, block);
        expectTreesHoldNothingFarOff(world, GetParam().seed);
        cells += cellsOf(world);
        const bool dungeon = world.spaces[world::kOutside].portalCount == 0;
        if (cellsOf(world) > 0)
            EXPECT_EQ(reachedFrom(world, dungeon ? 1 : world::kOutside), cellsOf(world));
    }
    const GeneratedSpec& spec = GetParam();
    if (spec.kind == GeneratedKind::Dungeon || spec.kind == GeneratedKind::Complex ||
        spec.kind == GeneratedKind::Skewed)
        EXPECT_EQ(cells, spec.size);
    else
        EXPECT_GE(cells, spec.size);
}

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Generated, theSameSpecGivesTheSameBytesAndAnotherSeedOthers) {
    for (const GeneratedKind kind :
         {GeneratedKind::Dungeon, GeneratedKind::Town, GeneratedKind::Complex, GeneratedKind::Terrain,
          GeneratedKind::Skewed, GeneratedKind::Thin, GeneratedKind::Nested}) {
        const GeneratedWorld one({kind, 9, 5}), same({kind, 9, 5}), other({kind, 9, 6});
        for (const char* name : {"client_portal.dat", "client_cell_1.dat", "world.json"}) {
            const std::string bytes = bytesOf(one.directory() / name);
            EXPECT_FALSE(bytes.empty());
            EXPECT_TRUE(bytes == bytesOf(same.directory() / name)) << nameOf(one.spec()) << " " << name;
        }
        EXPECT_FALSE(bytesOf(one.directory() / "client_cell_1.dat") ==
                     bytesOf(other.directory() / "client_cell_1.dat"));
    }
}

std::size_t lampsOf(const GeneratedWorld& generated) {
    std::size_t lamps = 0;
    for (const dat::BlockCoord block : generated.blocks())
        lamps += generated.load(block).lights.size();
    return lamps;
}

TEST(Generated, furnitureChangesNoCellDoorOrPlace_andLightsRooms) {
    for (const GeneratedKind kind : {GeneratedKind::Dungeon, GeneratedKind::Town}) {
        const GeneratedWorld bare({kind, 12, 5}), furnished({kind, 12, 5, 0.02, true});
        ASSERT_EQ(bare.blocks(), furnished.blocks());
        for (const dat::BlockCoord block : bare.blocks()) {
            const world::World a = bare.load(block), b = furnished.load(block);
            EXPECT_EQ(a.portals, b.portals);
            EXPECT_EQ(a.portalCorners, b.portalCorners);
            EXPECT_EQ(a.doors.size(), b.doors.size());
        }
        ASSERT_EQ(bare.file().places.size(), furnished.file().places.size());
        for (std::size_t i = 0; i < bare.file().places.size(); ++i)
            EXPECT_EQ(bare.file().places[i].eye, furnished.file().places[i].eye);
        EXPECT_GE(lampsOf(furnished), 8u);
        EXPECT_GT(lampsOf(furnished), 2 * lampsOf(bare));
    }
}

TEST(Generated, everyRoomAndPassageOfAFurnishedDungeonHasALight) {
    const GeneratedWorld generated({GeneratedKind::Dungeon, 60, 5, 0.02, true});
    std::size_t shafts = 0;
    for (const dat::BlockCoord block : generated.blocks()) {
        const world::World world = generated.load(block);
        for (std::size_t s = 1; s < world.spaces.size(); ++s) {
            const Aabb& cell = world.spaces[s].bounds;
            if (cell.max.x - cell.min.x < 2.5 &&
                cell.max.y - cell.min.y < 2.5) { // a shaft between two storeys
                ++shafts;
                continue;
            }
            EXPECT_TRUE(std::any_of(world.lights.begin(), world.lights.end(),
                                    [&](const world::Light& light) {
                                        const Vec3 beyond =
                                            glm::max(cell.min - light.position, light.position - cell.max);
                                        return std::max({beyond.x, beyond.y, beyond.z}) < 0.0;
                                    }))
                << "cell " << s << " of " << world.spaces.size();
        }
    }
    EXPECT_GT(shafts, 0u);
}

TEST(Generated, sizesAndSharesOutOfRangeAreErrors) {
    const limen::test::TempDir directory;
    for (const GeneratedSpec& spec :
         {GeneratedSpec{GeneratedKind::Dungeon, 0, 1}, GeneratedSpec{GeneratedKind::Dungeon, 1000001, 1},
          GeneratedSpec{GeneratedKind::Town, 2001, 1}, GeneratedSpec{GeneratedKind::Complex, 5001, 1},
          GeneratedSpec{GeneratedKind::Terrain, 501, 1}, GeneratedSpec{GeneratedKind::Skewed, 5001, 1},
          GeneratedSpec{GeneratedKind::Thin, 401, 1}, GeneratedSpec{GeneratedKind::Nested, 2001, 1},
          GeneratedSpec{GeneratedKind::Dungeon, 5, 1, 0.3}}) {
        const Result<void> written = writeGeneratedWorld(spec, directory.path());
        ASSERT_FALSE(written.has_value());
        EXPECT_EQ(written.error().code, ErrorCode::BadArgument);
    }
    const Result<void> nowhere = writeGeneratedWorld({GeneratedKind::Dungeon, 5, 1}, "/proc/nowhere");
    ASSERT_FALSE(nowhere.has_value());
    EXPECT_EQ(nowhere.error().code, ErrorCode::Unreadable);
}

} // namespace
} // namespace limen::worlds::test
