#include "support/LoadTestWorld.h"
#include "world/mesh/PolygonMesher.h"
#include "world/records/PolygonSource.h"
#include "world/records/Pose.h"
#include "world/records/Records.h"

namespace limen::world {
namespace {

dat::VertexArray square() {
    dat::VertexArray array;
    const Vec3f corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (std::uint16_t i = 0; i < 4; ++i) {
        dat::Vertex vertex;
        vertex.position = corners[i];
        vertex.normal = {0, 0, 1};
        vertex.uvs = {Vec2f(0.25f), Vec2f(0.75f)};
        array.vertices.emplace_back(i, vertex);
    }
    return array;
}

dat::Polygon quad() {
    dat::Polygon polygon;
    polygon.posSurface = 0;
    polygon.vertexKeys = {0, 1, 2, 3};
    polygon.posUv = {0, 1, 0, 9};
    return polygon;
}

std::vector<SourcePolygon> read(const dat::Polygon& polygon, std::vector<Finding>& findings,
                                std::set<std::uint16_t> portals = {}) {
    return readPolygons(square(), {{7, polygon}}, {true, true, false}, portals, 0x01000001, findings);
}

TEST(ReadPolygons, followsTheSidesRule) {
    std::vector<Finding> findings;
    dat::Polygon polygon = quad();
    auto read1 = read(polygon, findings);
    ASSERT_EQ(read1.size(), 1u);
    EXPECT_EQ(read1[0].frontSlot, 0);
    EXPECT_EQ(read1[0].backSlot, -1);
    EXPECT_EQ(read1[0].corners[1].front, Vec2f(0.75f));
    EXPECT_EQ(read1[0].corners[3].front, Vec2f(0.25f)) << "an index beyond the list counts as 0";
    polygon.sides = 1;
    EXPECT_EQ(read(polygon, findings)[0].backSlot, 0);
    polygon.sides = 2;
    polygon.negSurface = 1;
    polygon.negUv = {1, 1, 1, 1};
    const auto both = read(polygon, findings);
    EXPECT_EQ(both[0].backSlot, 1);
    EXPECT_EQ(both[0].corners[0].back, Vec2f(0.75f));
    EXPECT_TRUE(findings.empty());
}

TEST(ReadPolygons, stipplingSaysRepeatAndThatNoUvsFollow) {
    std::vector<Finding> findings;
    dat::Polygon polygon = quad();
    polygon.sides = 2;
    polygon.negSurface = 1;
    for (const bool front : {false, true}) {
        for (const bool back : {false, true}) {
            polygon.stippling = static_cast<std::uint8_t>((front ? dat::kRepeatPositive : 0) |
                                                          (back ? dat::kRepeatNegative : 0));
            const auto sides = read(polygon, findings);
            EXPECT_EQ(sides[0].frontRepeats, front);
            EXPECT_EQ(sides[0].backRepeats, back);
        }
    }
    polygon.stippling = dat::kNoPositiveUv | dat::kNoNegativeUv;
    polygon.posUv.clear();
    const auto bare = read(polygon, findings);
    ASSERT_EQ(bare.size(), 1u) << "no bit hides a polygon";
    EXPECT_EQ(bare[0].frontSlot, 0);
    EXPECT_EQ(bare[0].backSlot, 1);
    EXPECT_EQ(bare[0].corners[1].front, Vec2f(0.25f)) << "the first UV of each vertex";
    EXPECT_EQ(bare[0].corners[1].back, Vec2f(0.25f));
    EXPECT_TRUE(findings.empty());
}

TEST(ReadPolygons, aSurfaceWithoutAPictureIsDrawnOnThingsOnly) {
    test::TestWorld source;
    const std::vector<dat::RecordId> surfaces{source.solid("wall", 0xFF808080),
                                              source.plain("bare", 0xFFC8C8C8), 0x0800FFFF};
    const test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    Records records(*archive);
    EXPECT_EQ(drawnSlots(surfaces, MeshOwner::Thing, records), (std::vector<bool>{true, true, true}));
    EXPECT_EQ(drawnSlots(surfaces, MeshOwner::Structure, records), (std::vector<bool>{true, false, true}));
}

TEST(ReadPolygons, leavesOutPolygonsThatAreNotDrawn) {
    std::vector<Finding> findings;
    dat::Polygon bare = quad();
    bare.posSurface = -1;
    EXPECT_TRUE(read(bare, findings).empty());
    bare.posSurface = 3;
    EXPECT_TRUE(read(bare, findings).empty()) << "no such surface";
    bare.posSurface = 2;
    EXPECT_TRUE(read(bare, findings).empty()) << "a surface that is not drawn";
    const auto opening = read(bare, findings, {7});
    ASSERT_EQ(opening.size(), 1u) << "a portal is read in any case";
    EXPECT_FALSE(opening[0].isDrawn());
    const auto filled = read(quad(), findings, {7});
    ASSERT_EQ(filled.size(), 1u);
    EXPECT_TRUE(filled[0].isDrawn());
    EXPECT_TRUE(filled[0].isPortal);
    EXPECT_TRUE(findings.empty());
}

TEST(ReadPolygons, reportsDamage) {
    std::vector<Finding> findings;
    dat::Polygon polygon = quad();
    polygon.vertexKeys[2] = 99;
    EXPECT_TRUE(read(polygon, findings).empty());
    EXPECT_EQ(findings.size(), 1u);
    dat::VertexArray broken = square();
    broken.vertices[0].second.position.x = std::nanf("");
    EXPECT_TRUE(readPolygons(broken, {{7, quad()}}, {true}, {}, 1, findings).empty());
    EXPECT_EQ(findings.size(), 2u);
}

TEST(ReadPolygons, findsVerticesByKeyInAnyOrder) {
    dat::VertexArray array = square();
    std::reverse(array.vertices.begin(), array.vertices.end());
    std::vector<Finding> findings;
    const auto polygons = readPolygons(array, {{7, quad()}}, {true}, {}, 1, findings);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].corners[1].position, Vec3(1, 0, 0));
}

TEST(Meshes, drawTwoSidedPolygonsTwiceUnderOneNumber) {
    test::TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    const auto model = source.addModel({{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, "flag", true},
                                        {{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}}, "flag", false}});
    source.addObject(model, test::frameAt({20, 20, 2}));
    const World world = test::loadTestWorld(source);
    const Instance& object = world.instances.back();
    const Mesh& mesh = world.meshes[object.mesh];
    EXPECT_EQ(mesh.polygonCount, 2u);
    EXPECT_EQ(mesh.vertexCount, 15u);
    EXPECT_EQ(mesh.ranges[0].indexCount, 15u);
    for (std::uint32_t v = 0; v < 6; ++v) {
        EXPECT_EQ(world.vertices[mesh.firstVertex + v + 6].normal,
                  world.vertices[mesh.firstVertex + v].normal)
            << "both faces are lit by the front's normal";
        EXPECT_EQ(world.vertices[mesh.firstVertex + v + 6].polygon, 0);
    }
    for (std::uint32_t i = 0; i < mesh.ranges[0].indexCount; i += 3) {
        const MeshVertex* t[3];
        for (std::uint32_t k = 0; k < 3; ++k)
            t[k] = &world.vertices[mesh.firstVertex + world.indices[mesh.ranges[0].firstIndex + i + k]];
        const Vec3f n = glm::cross(t[1]->position - t[0]->position, t[2]->position - t[0]->position);
        const bool isBack = i >= 6 && i < 12;
        EXPECT_EQ(glm::dot(n, t[0]->normal) > 0.0f, !isBack);
        for (std::uint32_t k = 0; k < 3; ++k) {
            EXPECT_EQ(t[k], t[0] + k) << "vertices come in threes";
            EXPECT_NEAR(glm::dot(t[k]->facet, glm::normalize(n)), 1.0f, 1e-6f);
        }
    }
}

/// A mesh of one polygon, with the slots of a thing.
MeshData meshOf(const dat::VertexArray& vertices, const dat::PolygonList& polygons,
                std::vector<bool>& clamped) {
    std::vector<Finding> findings;
    BakedGeometry geometry;
    std::vector<std::uint32_t> handles;
    for (SourcePolygon& polygon : readPolygons(vertices, polygons, {true, true, true}, {}, 1, findings))
        handles.push_back(geometry.add(std::move(polygon), {}));
    geometry.bake();
    PolygonMesher mesher({SurfaceList::Opaque, SurfaceList::Opaque, SurfaceList::Opaque});
    for (const std::uint32_t handle : handles)
        mesher.add(geometry, handle);
    clamped = mesher.clamped();
    return mesher.finish();
}

TEST(Meshes, keepZeroNormals) {
    dat::VertexArray vertices = square();
    vertices.vertices[0].second.normal = Vec3f(0.0f);
    std::vector<bool> clamped;
    const MeshData mesh = meshOf(vertices, {{7, quad()}}, clamped);
    std::size_t zero = 0;
    for (const MeshVertex& vertex : mesh.vertices) {
        const bool isFirst = vertex.position == Vec3f(0.0f);
        EXPECT_EQ(vertex.normal, isFirst ? Vec3f(0.0f) : Vec3f(0, 0, 1));
        zero += isFirst;
    }
    EXPECT_GT(zero, 0u);
}

TEST(Meshes, negateNormalsOfABackWithItsOwnSurfaceOnly) {
    dat::Polygon polygon = quad();
    polygon.sides = 2;
    polygon.negSurface = 1;
    std::vector<bool> clamped;
    const MeshData mesh = meshOf(square(), {{7, polygon}}, clamped);
    for (const MeshVertex& vertex : mesh.vertices)
        EXPECT_EQ(vertex.normal, vertex.surface == 1 ? Vec3f(0, 0, -1) : Vec3f(0, 0, 1));
}

TEST(Meshes, repeatAPictureIfOneOfItsPolygonsDoes) {
    dat::Polygon first = quad(), second = quad(), third = quad();
    second.stippling = dat::kRepeatPositive;
    third.posSurface = 1;
    std::vector<bool> clamped;
    (void)meshOf(square(), {{7, first}, {8, second}, {9, third}}, clamped);
    EXPECT_EQ(clamped, (std::vector<bool>{false, true, true}));
}

TEST(Setups, areDisplayedByPlacement65Then0ThenTheIdentity) {
    dat::AnimationFrame at1, at2;
    at1.parts = {test::frameAt({1, 0, 0})};
    at2.parts = {test::frameAt({2, 0, 0})};
    dat::Setup setup;
    setup.placementFrames = {{0, at1}, {0x65, at2}};
    EXPECT_EQ(restOf(setup, 0).origin, Vec3(2, 0, 0));
    setup.placementFrames = {{3, at2}, {0, at1}};
    EXPECT_EQ(restOf(setup, 0).origin, Vec3(1, 0, 0));
    setup.placementFrames = {{3, at2}};
    EXPECT_EQ(restOf(setup, 0).origin, Vec3(0.0)) << "not the first one";
    EXPECT_EQ(restOf(setup, 1).origin, Vec3(0.0));
}

TEST(Meshes, areSharedByContentAndPlacedBySetups) {
    test::TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    const auto box = source.addModel(test::boxExterior({-1, -1, -1}, {1, 1, 1}));
    dat::Setup setup;
    setup.flags = dat::Setup::kScales;
    setup.parts = {box, box};
    setup.scales = {Vec3f(1.0f), Vec3f(2.0f, 1.0f, 0.5f)};
    dat::AnimationFrame rest, other;
    rest.parts = {test::frameAt({0, 0, 1}), test::frameAt({0, 3, 1}, 90)};
    other.parts = {test::frameAt({9, 9, 9}), test::frameAt({9, 9, 9})};
    setup.placementFrames = {{0, other}, {0x65, rest}};
    const auto model = source.addSetup(setup);
    source.addObject(model, test::frameAt({50, 60, 2}, 90));
    source.addObject(box, test::frameAt({80, 60, 2}));
    const World world = test::loadTestWorld(source);
    std::vector<const Instance*> parts;
    for (const Instance& instance : world.instances)
        if (instance.kind == InstanceKind::Static)
            parts.push_back(&instance);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0]->mesh, parts[1]->mesh);
    EXPECT_EQ(parts[0]->mesh, parts[2]->mesh);
    EXPECT_EQ(parts[0]->object, parts[1]->object);
    EXPECT_NE(parts[0]->object, parts[2]->object);
    EXPECT_EQ(parts[0]->firstMaterial, parts[2]->firstMaterial);
    EXPECT_NEAR(glm::length(parts[1]->origin - Vec3f(47, 60, 3)), 0.0f, 1e-4f) << "rotated with the object";
    // The part's x axis is scaled by 2 and rotated by 90 degrees twice: with the part and with the object.
    EXPECT_NEAR(glm::length(parts[1]->linear[0] - Vec3f(-2, 0, 0)), 0.0f, 1e-4f);
    EXPECT_NEAR(glm::length(parts[1]->linear[2] - Vec3f(0, 0, 0.5f)), 0.0f, 1e-4f);
}

TEST(Meshes, shellsKnowTheWallBeyondEachEdge) {
    test::TestWorld source;
    const auto room = source.addBox({0, 0, 0}, {4, 3, 2}, "brown"),
               next = source.addBox({4, 0, 0}, {8, 3, 2});
    source.link(room, test::rectangle({4, 1, 0.5}, {4, 2, 1.5}), next);
    const World world = test::loadTestWorld(source);
    const Space& space = world.spaces[findCell(world, source.id(room))];
    const Instance& shell = world.instances[world.spaceInstances[space.firstInstance]];
    ASSERT_EQ(shell.kind, InstanceKind::Shell);
    const Mesh& mesh = world.meshes[shell.mesh];
    std::size_t corners = 0, none = 0;
    for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v) {
        if (world.vertices[v].facet.x < 0.5f)
            continue; // the opening divides the other walls
        const float length = glm::length(world.vertices[v].neighbour);
        const float cosine = glm::dot(world.vertices[v].neighbour, world.vertices[v].facet);
        corners += std::abs(cosine) < 1e-6f * length && std::abs(length - 1e5f) < 1.0f ? 1 : 0;
        none += world.vertices[v].neighbour == Vec3f(0.0f) ? 1 : 0;
    }
    EXPECT_EQ(corners, 4u) << "the western wall's edges";
    EXPECT_EQ(none, 2u) << "both sides of its diagonal";
}

TEST(Meshes, aPictureInAnOpeningIsNoWallBeyondAnEdge) {
    const auto sumOfNeighbours = [](const std::string& picture) {
        test::TestWorld source;
        source.solid("pane", 0xFF80A0C0u, dat::Surface::kTranslucent, 0.5f);
        const auto room = source.addBox({0, 0, 0}, {4, 3, 2}, "brown"),
                   next = source.addBox({4, 0, 0}, {8, 3, 2});
        test::TestWorld::LinkOptions options;
        options.surface = picture;
        source.link(room, test::rectangle({4, 1, 0}, {4, 2, 1.5}), next, options); // it touches the floor
        const World world = test::loadTestWorld(source);
        EXPECT_EQ(world.spaces[1].zone, world.spaces[2].zone);
        Vec3 sum(0.0);
        for (const MeshVertex& vertex : world.vertices)
            sum += Vec3(vertex.neighbour);
        return sum;
    };
    EXPECT_EQ(sumOfNeighbours("pane"), sumOfNeighbours(""));
}

TEST(Meshes, aShellThatIsAZoneOfItsOwnNeedsNoNeighbours) {
    test::TestWorld source;
    source.addBox({0, 0, 0}, {4, 3, 2}, "brown");
    const World world = test::loadTestWorld(source);
    ASSERT_FALSE(world.vertices.empty());
    for (const MeshVertex& v : world.vertices)
        ASSERT_EQ(v.neighbour, Vec3f(0.0f)) << "no other cell of the zone is behind its walls";
}

/// The distance from walls, in metres, within which surfaces of another cell may be, for a room with a corner
/// moved upwards.
double reachOfWalls(double uneven) {
    test::TestWorld source;
    test::Walls walls = test::boxWalls({0, 0, 0}, {4, 3, 2});
    for (test::Wall& wall : walls)
        for (Vec3& p : wall.points)
            p.z += p == Vec3(4, 3, 2) ? uneven : 0.0;
    const auto room = source.addCell(walls), next = source.addBox({-4, 0, 0}, {0, 3, 2});
    source.link(room, test::rectangle({0, 1, 0.5}, {0, 2, 1.5}), next);
    const World world = test::loadTestWorld(source);
    const Space& space = world.spaces[1];
    const Mesh& mesh = world.meshes[world.instances[world.spaceInstances[space.firstInstance]].mesh];
    double least = 1e300, most = 0.0;
    for (const MeshVertex& v : std::span(world.vertices).subspan(mesh.firstVertex, mesh.vertexCount)) {
        if (v.neighbour == Vec3f(0.0f))
            continue;
        least = std::min(least, 1.0 / glm::length(Vec3(v.neighbour)));
        most = std::max(most, 1.0 / glm::length(Vec3(v.neighbour)));
    }
    EXPECT_NEAR(least, most, 1e-9);
    return most;
}

TEST(Meshes, shellsKnowHowFarTheirWallsAreFromFlat) {
    EXPECT_NEAR(reachOfWalls(0.0), 1e-5, 1e-9);
    const double some = reachOfWalls(0.00003);
    EXPECT_GT(some, 4e-5);
    EXPECT_LT(some, 8e-5);
    EXPECT_NEAR(reachOfWalls(0.01), 1e-4, 1e-9) << "the upper bound";
}

} // namespace
} // namespace limen::world
