#include "world/Loader.h"

#include "support/LoadTestWorld.h"
#include "world/terrain/Terrain.h"

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;

/// Two rooms in a row with a door between them, in a house with a front door and a rear window.
struct House {
    TestWorld source;
    TestWorld::Cell front = 0, rear = 0;
    explicit House(dat::BlockCoord home = {0x20, 0x30}) : source(home) {
        TestWorld::CellOptions lit;
        lit.seenOutside = true;
        front = source.addBox({50, 50, 2}, {54, 54, 5}, "wood", lit);
        rear = source.addBox({50, 54, 2}, {54, 58, 5}, "brick", lit);
        source.link(front, rectangle({51, 54, 2}, {52, 54, 4}), rear);
        const auto door = source.openOutside(front, rectangle({51, 50, 2}, {52, 50, 4}));
        const auto window = source.openOutside(rear, rectangle({51, 58, 3}, {53, 58, 4}));
        source.addBuilding(test::boxExterior({50, 50, 2}, {54, 58, 5}), {door, window});
        source.setFlatTerrain(source.home(), 1);
    }
};

TEST(LoadWorld, joinsRoomsAndTheOutsideThroughPortals) {
    House house;
    const World world = test::loadTestWorld(house.source);
    ASSERT_EQ(world.spaces.size(), 3u);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    EXPECT_EQ(world.portals.size(), 6u);
    EXPECT_EQ(world.spaces[kOutside].portalCount, 2u);
    for (PortalIndex p = 0; p < world.portals.size(); ++p) {
        const Portal& portal = world.portals[p];
        ASSERT_LT(portal.destination, world.spaces.size());
        ASSERT_LT(portal.reciprocal, world.portals.size());
        EXPECT_EQ(world.portals[portal.reciprocal].reciprocal, p);
        EXPECT_EQ(world.portals[portal.reciprocal].space, portal.destination);
        EXPECT_TRUE(portal.exact);
        const Space& space = world.spaces[portal.space];
        EXPECT_GE(p, space.firstPortal);
        EXPECT_LT(p, space.firstPortal + space.portalCount);
    }
    EXPECT_TRUE(world.spaces[1].ofBuilding && world.spaces[2].ofBuilding);
}

TEST(LoadWorld, putsTheSpaceInFrontOfItsPortals) {
    House house;
    const World world = test::loadTestWorld(house.source);
    for (const Portal& portal : world.portals) {
        if (portal.space == kOutside)
            continue;
        EXPECT_GT(portal.plane.signedDistance(world.spaces[portal.space].bounds.centre()), 0.5);
        EXPECT_EQ(polygonOf(world, portal).size(), 4u);
        const Portal& back = world.portals[portal.reciprocal];
        EXPECT_NEAR(glm::dot(portal.plane.n, back.plane.n), -1.0, 1e-9);
        EXPECT_NEAR(portal.plane.d, -back.plane.d, 1e-6);
    }
}

TEST(LoadWorld, mergesTheRoomsOfAHouseIntoOneZone) {
    House house;
    const World merged = test::loadTestWorld(house.source);
    EXPECT_EQ(merged.zones.size(), 2u);
    EXPECT_EQ(merged.spaces[1].zone, merged.spaces[2].zone);
    const World apart = test::loadTestWorld(house.source, {4, false});
    EXPECT_EQ(apart.zones.size(), 3u);
    EXPECT_EQ(apart.zones[kOutsideZone].spaceCount, 1u);
}

TEST(LoadWorld, numbersEveryPolygonOnce) {
    House house;
    const World world = test::loadTestWorld(house.source);
    std::uint32_t next = 2;
    for (const auto* instances : {&world.instances, &world.movingParts}) {
        for (const Instance& instance : *instances) {
            EXPECT_EQ(instance.idBase, next);
            next += world.meshes[instance.mesh].polygonCount;
        }
    }
    EXPECT_EQ(world.idEnd, next + kMostSprites);
}

TEST(LoadWorld, keepsIndicesInRange) {
    House house;
    house.source.addStatic(house.front, house.source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1})),
                           test::frameAt({52, 52, 2}, 30));
    const World world = test::loadTestWorld(house.source);
    for (const Mesh& mesh : world.meshes) {
        for (const Mesh::Range& range : mesh.ranges) {
            ASSERT_LE(range.firstIndex + range.indexCount, world.indices.size());
            for (std::uint32_t i = 0; i < range.indexCount; ++i)
                ASSERT_LT(world.indices[range.firstIndex + i], mesh.vertexCount);
        }
        for (std::uint32_t v = 0; v < mesh.vertexCount; ++v)
            ASSERT_LT(world.vertices[mesh.firstVertex + v].polygon, mesh.polygonCount);
    }
    for (const Instance& instance : world.instances) {
        ASSERT_LT(instance.mesh, world.meshes.size());
        ASSERT_GE(instance.memberCount, 1u);
        EXPECT_EQ(world.members[instance.firstMember], instance.placedIn);
    }
    for (const std::uint32_t ref : world.materialRefs)
        ASSERT_LT(ref, world.materials.size());
}

TEST(LoadWorld, isTheSameAtAnyCornerOfTheMapButForThePlace) {
    for (const dat::BlockCoord corner :
         {dat::BlockCoord{0, 0}, dat::BlockCoord{254, 254}, dat::BlockCoord{254, 0}}) {
        House here, there(corner);
        const World a = test::loadTestWorld(here.source, {0, true}),
                    b = test::loadTestWorld(there.source, {0, true});
        EXPECT_TRUE(b.findings.empty()) << test::findingsOf(b);
        ASSERT_EQ(a.vertices.size(), b.vertices.size());
        ASSERT_EQ(a.spaces.size(), b.spaces.size());
        EXPECT_EQ(a.idEnd, b.idEnd);
        const Vec3 shift = b.blocks[0].origin() - a.blocks[0].origin();
        for (std::size_t i = 0; i < a.portalVertices.size(); ++i)
            EXPECT_EQ(a.portalVertices[i] + shift, b.portalVertices[i]);
    }
}

TEST(LoadWorld, portalVerticesAreTheWallsCornersExactly) {
    House house({254, 254});
    const World world = test::loadTestWorld(house.source);
    std::set<std::array<double, 3>> wallVertices;
    for (const MeshVertex& v : world.vertices)
        wallVertices.insert({v.corner().x, v.corner().y, v.corner().z});
    const Vec3 origin = world.blocks[0].origin();
    for (const Vec3& p : world.portalVertices) {
        const Vec3 local = p - origin;
        EXPECT_EQ(local + origin, p);
        EXPECT_TRUE(wallVertices.contains({local.x, local.y, local.z}));
    }
}

TEST(LoadWorld, givesTheSameArraysEveryTime) {
    House first, second;
    const World a = test::loadTestWorld(first.source), b = test::loadTestWorld(second.source);
    const auto sameVertex = [](const MeshVertex& v, const MeshVertex& w) {
        return v.position == w.position && v.rest == w.rest && v.normal == w.normal && v.uv == w.uv &&
               v.polygon == w.polygon && v.surface == w.surface;
    };
    EXPECT_TRUE(
        std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), sameVertex));
    EXPECT_EQ(a.indices, b.indices);
    EXPECT_EQ(a.portalVertices, b.portalVertices);
    EXPECT_EQ(a.portalCorners, b.portalCorners);
    EXPECT_EQ(a.zoneSpaces, b.zoneSpaces);
    EXPECT_EQ(a.members, b.members);
    EXPECT_EQ(a.spaceInstances, b.spaceInstances);
    EXPECT_EQ(a.materialRefs, b.materialRefs);
}

TEST(LoadWorld, loadsAPureDungeonAloneAndWithoutTerrain) {
    TestWorld source;
    source.addBox({-500, -300, -20}, {-490, -290, -10});
    source.setFlatTerrain(source.home(), 0);
    source.setFlatTerrain({0x21, 0x30}, 0);
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.blocks.size(), 1u);
    EXPECT_FALSE(world.blocks[0].hasTerrain);
    EXPECT_TRUE(
        std::isnan(terrainHeight(world, world.blocks[0].origin().x + 5, world.blocks[0].origin().y + 5)));
    EXPECT_NEAR(world.spaces[1].bounds.min.x, 0x20 * 192.0 - 500, 1e-3);
    EXPECT_FALSE(world.spaces[1].ofBuilding);
}

TEST(LoadWorld, leavesOutBlocksThatDoNotExist) {
    House house;
    house.source.setFlatTerrain({0x22, 0x30}, 1);
    EXPECT_EQ(test::loadTestWorld(house.source, {4, true}).blocks.size(), 2u);
    EXPECT_EQ(test::loadTestWorld(house.source, {1, true}).blocks.size(), 1u);
}

TEST(LoadWorld, failsWhereThereIsNothing) {
    TestWorld source({5, 5});
    source.setFlatTerrain({100, 100}, 1);
    const test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    EXPECT_EQ(loadWorld(*archive, {5, 5}, {}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(loadWorld(*archive, {255, 5}, {}).error().code, ErrorCode::BadArgument);
}

TEST(LoadWorld, reportsADamagedCellAndLoadsTheRest) {
    House house;
    TestWorld& source = house.source;
    const auto lost = source.addBox({100, 100, 2}, {104, 104, 5});
    const test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    source.cellFile().add(source.id(lost), dat::Bytes(3));
    ASSERT_TRUE(source.cellFile().write(directory.path() / "client_cell_1.dat"));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    const auto world = loadWorld(*archive, source.home(), {});
    ASSERT_TRUE(world);
    EXPECT_EQ(world->spaces.size(), 3u);
    ASSERT_EQ(world->findings.size(), 1u) << test::findingsOf(*world);
    EXPECT_EQ(world->findings[0].record, source.id(lost));
}

// The bounds of a cell without polygons are infinite. The search for neighbours must not use their corners.
TEST(LoadWorld, leavesOutACellWithoutAUsablePolygon) {
    House house;
    const test::TempDir directory;
    ASSERT_TRUE(house.source.write(directory.path()));
    const auto whole = dat::Archive::open(directory.path());
    ASSERT_TRUE(whole);
    const auto copied = [](const dat::File& file, dat::Writer writer, dat::RecordId broken) {
        dat::Bytes scratch;
        EXPECT_TRUE(file.forEach([&](const dat::Entry& entry) {
            const auto payload = *file.read(entry, scratch);
            writer.add(entry.id, dat::Bytes(payload.begin(), payload.end()));
            if (entry.id == broken) {
                dat::Environment shape = *dat::decode<dat::Environment>(entry.id, payload);
                for (auto& [key, vertex] : shape.cells.front().second.vertexArray.vertices)
                    vertex.position = Vec3f(1e30f);
                writer.add(shape);
            }
            return true;
        }));
        return *dat::File::fromBytes(*writer.build(), "copy");
    };
    const auto front = whole->load<dat::EnvCell>(house.source.id(house.front));
    ASSERT_TRUE(front);
    const dat::Archive archive = dat::Archive::of(
        copied(whole->portal(), dat::Writer(dat::FileTraits::portal()), 0x0D000000u | front->environment),
        copied(whole->cell(), dat::Writer(dat::FileTraits::cell()), 0));
    const Result<World> world = loadWorld(archive, house.source.home(), {});
    ASSERT_TRUE(world) << world.error().message();
    EXPECT_EQ(findCell(*world, house.source.id(house.front)), kNone);
    EXPECT_NE(findCell(*world, house.source.id(house.rear)), kNone);
    EXPECT_NE(test::findingsOf(*world).find("none of its polygons can be used"), std::string::npos)
        << test::findingsOf(*world);
}

TEST(FindCell, findsExactlyTheResidentCells) {
    House house;
    const World world = test::loadTestWorld(house.source);
    EXPECT_EQ(findCell(world, house.source.id(house.front)), 1u);
    EXPECT_EQ(findCell(world, house.source.id(house.rear)), 2u);
    EXPECT_EQ(findCell(world, house.source.id(house.rear) + 1), kNone);
    EXPECT_EQ(findCell(world, 0), kNone);
    EXPECT_EQ(findCell(World{}, 0x20300100), kNone);
}

TEST(BlockAt, clampsToTheMap) {
    EXPECT_EQ(blockAt({0.0, 191.9, 0.0}), (dat::BlockCoord{0, 0}));
    EXPECT_EQ(blockAt({192.0, 384.0, 0.0}), (dat::BlockCoord{1, 2}));
    EXPECT_EQ(blockAt({-50.0, 1e9, 0.0}), (dat::BlockCoord{0, 254}));
}

TEST(TerrainHeight, isFlatOnFlatGround) {
    House house;
    const World world = test::loadTestWorld(house.source);
    const Vec3 origin = world.blocks[0].origin();
    EXPECT_DOUBLE_EQ(terrainHeight(world, origin.x + 77.0, origin.y + 13.0), landHeight(2.0f));
    EXPECT_TRUE(std::isnan(terrainHeight(world, origin.x + 193.0, origin.y + 13.0)));
}

} // namespace
} // namespace limen::world
