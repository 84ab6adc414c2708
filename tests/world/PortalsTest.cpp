#include "geometry/ConvexPolygon.h"
#include "support/LoadTestWorld.h"
#include "world/OpeningParts.h"
#include "world/PolygonDistance.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;
using testing::HasSubstr;

const std::vector<Vec3> kDoor = rectangle({4, 1, 0}, {4, 2, 2});

struct TwoRooms {
    TestWorld source;
    TestWorld::Cell a = source.addBox({0, 0, 0}, {4, 4, 3}), b = source.addBox({4, 0, 0}, {8, 4, 3});
};

const Portal& firstPortal(const World& world, SpaceIndex space) {
    return world.portals[world.spaces[space].firstPortal];
}

TEST(Portals, faceTheirSpaceHoweverTheRecordWindsThem) {
    for (const bool positive : {true, false}) {
        TwoRooms rooms;
        TestWorld::LinkOptions options;
        options.insideIsPositive = positive;
        rooms.source.link(rooms.a, kDoor, rooms.b, options);
        const World world = test::loadTestWorld(rooms.source);
        EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
        EXPECT_NEAR(firstPortal(world, 1).plane.n.x, -1.0, 1e-9);
        EXPECT_NEAR(firstPortal(world, 2).plane.n.x, 1.0, 1e-9);
        EXPECT_GT(newellNormal(polygonOf(world, firstPortal(world, 2))).x, 0.0);
    }
}

TEST(Portals, trustGeometryWhereTheFlagContradicts) {
    TwoRooms rooms;
    TestWorld::LinkOptions options;
    options.wrongSideFlag = true;
    rooms.source.link(rooms.a, kDoor, rooms.b, options);
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_NEAR(firstPortal(world, 1).plane.n.x, -1.0, 1e-9);
    EXPECT_EQ(world.findings.size(), 2u);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("wrong side"));
}

TEST(Portals, anInexactPairStaysInexactAndApart) {
    TwoRooms rooms;
    TestWorld::LinkOptions options;
    options.exact = false;
    options.polygonInB = rectangle({4, 1.5, 0}, {4, 3, 2});
    rooms.source.link(rooms.a, kDoor, rooms.b, options);
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_FALSE(firstPortal(world, 1).exact);
    EXPECT_FALSE(firstPortal(world, 2).exact);
    EXPECT_NE(world.spaces[1].zone, world.spaces[2].zone);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
}

TEST(Portals, aFalseClaimOfExactnessIsReported) {
    TwoRooms rooms;
    TestWorld::LinkOptions options;
    options.polygonInB = rectangle({4, 1, 0}, {4, 2.1, 2});
    rooms.source.link(rooms.a, kDoor, rooms.b, options);
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_FALSE(firstPortal(world, 1).exact);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("exact match"));
}

TEST(Portals, oneWayPortalsHaveNoWayBack) {
    TwoRooms rooms;
    const auto [there, back] = rooms.source.link(rooms.a, kDoor, rooms.b);
    rooms.source.record(rooms.a).portals[there.index].otherPortalId = dat::kNoPortal;
    rooms.source.record(rooms.b).portals.clear();
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_EQ(firstPortal(world, 1).destination, 2u);
    EXPECT_EQ(firstPortal(world, 1).reciprocal, kNone);
    EXPECT_NE(world.spaces[1].zone, world.spaces[2].zone);
}

TEST(Portals, aWrongWayBackIsFoundByGeometry) {
    TwoRooms rooms;
    rooms.source.link(rooms.a, kDoor, rooms.b);
    rooms.source.link(rooms.a, rectangle({4, 3, 1}, {4, 3.5, 2}), rooms.b);
    rooms.source.record(rooms.a).portals[0].otherPortalId = 1;
    rooms.source.record(rooms.a).portals[1].otherPortalId = 77;
    const World world = test::loadTestWorld(rooms.source);
    const PortalIndex first = world.spaces[1].firstPortal, back = world.spaces[2].firstPortal;
    EXPECT_EQ(world.portals[first].reciprocal, back);
    EXPECT_EQ(world.portals[back].reciprocal, first);
    EXPECT_EQ(world.portals[first + 1].reciprocal, back + 1);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("does not lead back"));
}

TEST(Portals, leadNowhereWhereTheCellDoesNotExist) {
    TwoRooms rooms;
    rooms.source.link(rooms.a, kDoor, rooms.b);
    rooms.source.record(rooms.a).portals[0].otherCellId = 0x0200;
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_EQ(firstPortal(world, 1).destination, kNone);
    EXPECT_EQ(firstPortal(world, 1).reciprocal, kNone);
    EXPECT_EQ(firstPortal(world, 2).reciprocal, kNone);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("does not exist"));
}

std::size_t trianglesOf(const World& world, SpaceIndex space, SurfaceClass surfaces) {
    const Mesh& mesh = world.meshes[world.instances[world.spaces[space].shell].mesh];
    return mesh.ranges[static_cast<std::size_t>(surfaces)].indexCount / 3;
}

TEST(Portals, anOpaquePictureIsAWallOfItsOwnSide) {
    for (const bool positive : {true, false}) {
        TwoRooms plain, rooms;
        TestWorld::LinkOptions options;
        options.insideIsPositive = positive;
        plain.source.link(plain.a, kDoor, plain.b, options);
        options.surface = "painted door";
        options.twoSided = !positive; // a polygon wound outwards shows its back to the cell
        rooms.source.link(rooms.a, kDoor, rooms.b, options);
        const World open = test::loadTestWorld(plain.source), world = test::loadTestWorld(rooms.source);
        EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
        const Portal& there = firstPortal(world, 1);
        const Portal& back = firstPortal(world, 2);
        EXPECT_TRUE(there.walled);
        EXPECT_FALSE(back.walled);
        EXPECT_EQ(there.destination, 2u) << "bodies pass";
        EXPECT_EQ(back.destination, 1u);
        EXPECT_EQ(there.reciprocal, kNone);
        EXPECT_EQ(back.reciprocal, kNone);
        EXPECT_NE(world.spaces[1].zone, world.spaces[2].zone);
        EXPECT_EQ(trianglesOf(world, 1, SurfaceClass::Opaque),
                  trianglesOf(open, 1, SurfaceClass::Opaque) + (positive ? 2u : 4u));
    }
}

TEST(Portals, aPictureThatFacesAwayIsNoWall) {
    TwoRooms rooms;
    TestWorld::LinkOptions options;
    options.insideIsPositive = false;
    options.surface = "painted door";
    rooms.source.link(rooms.a, kDoor, rooms.b, options);
    EXPECT_FALSE(firstPortal(test::loadTestWorld(rooms.source), 1).walled);
}

TEST(Portals, aTransparentPictureLeavesTheOpening) {
    TwoRooms rooms;
    rooms.source.solid("pane", 0xFF80A0C0u, dat::Surface::kTranslucent, 0.5f);
    TestWorld::LinkOptions options;
    options.surface = "pane";
    rooms.source.link(rooms.a, kDoor, rooms.b, options);
    const World world = test::loadTestWorld(rooms.source);
    EXPECT_FALSE(firstPortal(world, 1).walled);
    EXPECT_EQ(world.spaces[1].zone, world.spaces[2].zone);
    EXPECT_EQ(trianglesOf(world, 1, SurfaceClass::Blended), 2u);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
}

TEST(Portals, severalBetweenTheSameCellsArePairedOneByOne) {
    TwoRooms rooms;
    for (int i = 0; i < 3; ++i)
        rooms.source.link(rooms.a, rectangle({4, 0.5 + i, 0}, {4, 1.0 + i, 2}), rooms.b);
    const World world = test::loadTestWorld(rooms.source);
    ASSERT_EQ(world.portals.size(), 6u);
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(world.portals[i].reciprocal, i + 3);
    EXPECT_EQ(world.spaces[1].zone, world.spaces[2].zone);
}

TEST(Portals, aCellMayLeadIntoItself) {
    TestWorld source;
    const auto a = source.addBox({0, 0, 0}, {4, 4, 3});
    TestWorld::LinkOptions options;
    options.exact = false;
    options.polygonInB = rectangle({0, 1, 0}, {0, 2, 2});
    source.link(a, kDoor, a, options);
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.portals.size(), 2u);
    EXPECT_EQ(world.portals[0].destination, 1u);
    EXPECT_EQ(world.portals[0].reciprocal, 1u);
    EXPECT_FALSE(world.portals[0].exact);
}

TEST(Portals, badPolygonsStayShut) {
    const std::vector<std::pair<std::vector<Vec3>, const char*>> bad{
        {{{4, 1, 0}, {4, 2, 0}, {4.3, 2, 2}, {4, 1, 2}}, "not flat"},
        {{{4, 1, 0}, {4, 2, 0}, {4, 1.2, 0.2}, {4, 1, 2}}, "not convex"},
        {{{4, 1, 0}, {4, 2, 0}, {4, 3, 0}}, "no area"}};
    for (const auto& [polygon, words] : bad) {
        TwoRooms rooms;
        rooms.source.link(rooms.a, polygon, rooms.b);
        const World world = test::loadTestWorld(rooms.source);
        EXPECT_EQ(firstPortal(world, 1).destination, kNone);
        EXPECT_EQ(firstPortal(world, 1).vertexCount, 0u);
        EXPECT_THAT(test::findingsOf(world), HasSubstr(words));
    }
}

TEST(Portals, cornersOffThePlaneAreTolerated) {
    // Corners that are rounded to 2 mm are off by up to 1.7 mm each. The plane is that of the mean.
    for (const auto& [off, isOpen] : {std::pair{0.003, true}, {0.02, false}}) {
        TwoRooms rooms;
        rooms.source.link(rooms.a, {{4, 1, 0}, {4, 2, 0}, {4 + off, 2, 2}, {4, 1, 2}}, rooms.b);
        const World world = test::loadTestWorld(rooms.source);
        EXPECT_EQ(firstPortal(world, 1).destination != kNone, isOpen) << off;
    }
}

TEST(Portals, thePlaneIsThatOfTheCornersThatCount) {
    // The fifth corner is within the hull of the others and off their plane. The flood has the hull alone.
    TwoRooms rooms;
    TestWorld::LinkOptions options;
    options.exact = false;
    rooms.source.link(rooms.a, {{4, 1, 0}, {4, 2, 0}, {4, 2, 2}, {4.0008, 1.5, 1.9995}, {4, 1, 2}}, rooms.b,
                      options);
    const World world = test::loadTestWorld(rooms.source);
    const Portal& portal = openingOf(world, world.spaces[1].firstPortal); // its parts are triangles
    ASSERT_EQ(portal.cornerCount, 4u);
    const Plane plane = planeOf(cornersOf(world, portal));
    EXPECT_LT(glm::length(plane.n - portal.plane.n), 1e-12);
    EXPECT_NEAR(plane.d, portal.plane.d, 1e-9);
}

TEST(Portals, cornersAreConvexAndAmongTheVertices) {
    // b is smaller than a: its corners are inserted into the edges of a's opening.
    TestWorld source;
    const auto a = source.addBox({0, 0, 0}, {4, 4, 3}), b = source.addBox({4, 1, 0}, {8, 3, 3});
    source.link(a, rectangle({4, 1, 0}, {4, 3, 2}), b);
    source.addBox({4, 1.5, -3}, {6, 2.5, 0}); // touches the opening's lower edge with two corners
    const World world = test::loadTestWorld(source);
    const Portal& portal = firstPortal(world, 1);
    EXPECT_EQ(portal.cornerCount, 4u);
    EXPECT_EQ(portal.vertexCount, 6u);
    for (const Vec3& corner : cornersOf(world, portal))
        EXPECT_EQ(std::count(world.portalVertices.begin() + portal.firstVertex,
                             world.portalVertices.begin() + portal.firstVertex + portal.vertexCount, corner),
                  1);
    EXPECT_TRUE(samePolygon(cornersOf(world, portal), polygonOf(world, portal), 1e-4));
}

struct Hut {
    TestWorld source;
    TestWorld::Cell room = source.addBox({10, 10, 2}, {14, 14, 5});
    TestWorld::Portal door = source.openOutside(room, rectangle({11, 10, 2}, {12, 10, 4}));
    Hut() { source.setFlatTerrain(source.home(), 1); }
};

TEST(BuildingPortals, useTheCellsPolygonTurnedRound) {
    {
        Hut hut;
        TestWorld::BuildingOptions options;
        options.frame = test::frameAt({12, 12, 2}, 33);
        hut.source.addBuilding(test::boxExterior({10, 10, 2}, {14, 14, 5}), {hut.door}, options);
        const World world = test::loadTestWorld(hut.source);
        EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
        ASSERT_EQ(world.spaces[kOutside].portalCount, 1u);
        const Portal& in = world.portals[0];
        const Portal& out = firstPortal(world, 1);
        EXPECT_EQ(in.space, kOutside);
        EXPECT_EQ(in.destination, 1u);
        EXPECT_EQ(out.destination, kOutside);
        EXPECT_EQ(out.reciprocal, 0u);
        EXPECT_NEAR(in.plane.n.y, -1.0, 1e-6);
        const auto a = polygonOf(world, in), b = polygonOf(world, out);
        ASSERT_EQ(a.size(), b.size());
        EXPECT_TRUE(std::equal(a.begin(), a.end(), b.rbegin()));
    }
}

TEST(Buildings, areDrawnAtLevel0AtEveryDistance) {
    Hut hut;
    TestWorld::BuildingOptions options;
    const std::uint32_t far = hut.source.addModel(test::boxExterior({10, 10, 2}, {14, 14, 5}));
    options.levels = {{TestWorld::kItself, dat::DegradeLevel::kMesh, 0, 0, 20},
                      {far, dat::DegradeLevel::kMesh, 20, 40, 60}};
    hut.source.addBuilding(test::boxExterior({10, 10, 2}, {14, 14, 5}), {hut.door}, options);
    const World world = test::loadTestWorld(hut.source);
    std::size_t exteriors = 0;
    for (const Instance& instance : world.instances) {
        EXPECT_NE(instance.record, far);
        if (instance.kind != InstanceKind::Exterior)
            continue;
        ++exteriors;
        EXPECT_EQ(instance.level, kNone) << "from anywhere";
    }
    EXPECT_EQ(exteriors, 1u);
}

TEST(BuildingPortals, aPictureInTheModelMakesAWallSeenFromOutside) {
    Hut hut;
    TestWorld::BuildingOptions options;
    options.portalSurface = "painted door";
    hut.source.addBuilding(test::boxExterior({10, 10, 2}, {14, 14, 5}), {hut.door}, options);
    const World world = test::loadTestWorld(hut.source);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    EXPECT_TRUE(world.portals[0].walled);
    EXPECT_FALSE(firstPortal(world, 1).walled) << "the cell's own polygon has no picture";
    EXPECT_TRUE(world.spaces[1].ofBuilding);
}

TEST(BuildingPortals, aPictureInTheCellMakesAWallSeenFromInside) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    const auto room = source.addBox({10, 10, 2}, {14, 14, 5});
    TestWorld::LinkOptions link;
    link.surface = "painted door";
    const auto door = source.openOutside(room, rectangle({11, 10, 2}, {12, 10, 4}), link);
    source.addBuilding(test::boxExterior({10, 10, 2}, {14, 14, 5}), {door});
    const World world = test::loadTestWorld(source);
    EXPECT_FALSE(world.portals[0].walled);
    EXPECT_TRUE(firstPortal(world, 1).walled);
}

TEST(BuildingPortals, aDifferentPolygonInTheModelIsReported) {
    Hut hut;
    TestWorld::BuildingOptions options;
    options.portalShift = {0.0, -0.02, 0.0};
    hut.source.addBuilding(test::boxExterior({10, 10, 2}, {14, 14, 5}), {hut.door}, options);
    const World world = test::loadTestWorld(hut.source);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("another polygon"));
    EXPECT_EQ(world.portals[0].reciprocal, 1u);
}

TEST(BuildingPortals, exitsWithoutABuildingAreOneWayAndReported) {
    Hut hut;
    const World world = test::loadTestWorld(hut.source);
    EXPECT_EQ(firstPortal(world, 1).destination, kOutside);
    EXPECT_EQ(firstPortal(world, 1).reciprocal, kNone);
    EXPECT_FALSE(world.spaces[1].ofBuilding);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("no building leads back"));
}

TEST(BuildingPortals, portalPolygonsWithoutAPictureAreNotDrawn) {
    Hut hut;
    hut.source.addBuilding(test::boxExterior({10, 10, 2}, {14, 14, 5}), {hut.door});
    const World world = test::loadTestWorld(hut.source);
    const Vec3 origin = world.blocks[0].origin();
    const Vec3 middle(11.5, 10.0, 3.0);
    for (const Mesh& mesh : world.meshes) {
        for (std::uint32_t i = 0; i + 2 < mesh.ranges[0].indexCount; i += 3) {
            std::vector<Vec3> t;
            for (std::uint32_t k = 0; k < 3; ++k)
                t.emplace_back(
                    world.vertices[mesh.firstVertex + world.indices[mesh.ranges[0].firstIndex + i + k]]
                        .position);
            EXPECT_GT(distanceToPolygon(t, planeOf(t), middle), 0.4);
        }
    }
    EXPECT_GT(origin.x, 0.0);
}

} // namespace
} // namespace limen::world
