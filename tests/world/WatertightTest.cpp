#include "support/LoadTestWorld.h"

#include <random>

// Watertightness: shells and portals of a block share corners bit for bit.
namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;
using Bits = std::array<float, 6>;

Bits bitsOf(const Vec3f& p, const Vec3f& rest) {
    return {p.x, p.y, p.z, rest.x, rest.y, rest.z};
}

/// For each edge, compared bit for bit: the number of times it runs one way minus the other way.
using Balance = std::map<std::pair<Bits, Bits>, int>;

void addEdge(Balance& balance, const Bits& a, const Bits& b) {
    if (a < b)
        ++balance[{a, b}];
    else
        --balance[{b, a}];
}

void addMesh(Balance& balance, const World& world, const Mesh& mesh) {
    const auto corner = [&](std::uint32_t index) {
        const MeshVertex& vertex = world.vertices[mesh.firstVertex + world.indices[index]];
        return bitsOf(vertex.position, vertex.rest);
    };
    for (const Mesh::Range& range : mesh.ranges) {
        for (std::uint32_t i = 0; i < range.indexCount; ++i) {
            const std::uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
            addEdge(balance, corner(range.firstIndex + i), corner(range.firstIndex + next));
        }
    }
}

int unbalanced(const Balance& balance) {
    return static_cast<int>(
        std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

/// The number of edges of a cell's triangles and portals that do not run as often one way as the other.
int openEdges(const World& world, SpaceIndex index) {
    Balance balance;
    const auto ofPortal = [](const Vec3& local) {
        const TwoFloats parts = inTwoFloats(local);
        return bitsOf(parts.nearest, parts.rest);
    };
    const Space& space = world.spaces[index];
    addMesh(balance, world, world.meshes[world.instances[space.shell].mesh]);
    for (PortalIndex p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
        const auto polygon = polygonOf(world, world.portals[p]);
        const Vec3 origin = world.blocks[world.portals[p].block].origin();
        for (std::size_t i = 0; i < polygon.size(); ++i)
            addEdge(balance, ofPortal(polygon[i] - origin),
                    ofPortal(polygon[(i + 1) % polygon.size()] - origin));
    }
    return unbalanced(balance);
}

/// The number of triangles without area.
int degenerateTriangles(const World& world) {
    int degenerate = 0;
    for (const Mesh& mesh : world.meshes) {
        for (const Mesh::Range& range : mesh.ranges) {
            for (std::uint32_t i = 0; i < range.indexCount; i += 3) {
                Vec3 p[3];
                for (std::uint32_t k = 0; k < 3; ++k)
                    p[k] =
                        world.vertices[mesh.firstVertex + world.indices[range.firstIndex + i + k]].corner();
                degenerate += glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) > 0.0 ? 0 : 1;
            }
        }
    }
    return degenerate;
}

TEST(Watertight, roomsWithOpeningsCloseInEveryBit) {
    TestWorld source;
    const auto a = source.addBox({10, 10, 1}, {20, 20, 6}), b = source.addBox({20, 10, 1}, {30, 20, 6});
    source.link(a, rectangle({20, 12, 1}, {20, 13, 3}), b);
    source.link(a, test::regularPolygon({20, 16, 4}, {1, 0, 0}, 1.2, 11), b);
    source.openOutside(a, test::regularPolygon({10, 15, 3}, {1, 0, 0}, 1.0, 7));
    const World world = test::loadTestWorld(source);
    EXPECT_EQ(openEdges(world, 1), 0);
    EXPECT_EQ(openEdges(world, 2), 0);
    EXPECT_EQ(degenerateTriangles(world), 0);
    EXPECT_EQ(world.spaces[1].zone, world.spaces[2].zone);
}

TEST(Watertight, misalignedNeighboursShareTheirBits) {
    TestWorld source;
    const double off = 0.0001;
    const auto a = source.addBox({10, 10, 1}, {20, 20, 6}),
               b = source.addBox({20 + off, 10 - off, 1 + off}, {30, 20 + off, 6});
    source.link(a, rectangle({20, 12, 1}, {20, 13, 3}), b);
    const World world = test::loadTestWorld(source);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    EXPECT_EQ(openEdges(world, 1), 0);
    EXPECT_EQ(openEdges(world, 2), 0);
    const auto there = polygonOf(world, world.portals[world.spaces[1].firstPortal]);
    const auto back = polygonOf(world, world.portals[world.spaces[2].firstPortal]);
    ASSERT_EQ(there.size(), back.size());
    const std::set<std::array<double, 3>> corners = [&] {
        std::set<std::array<double, 3>> set;
        for (const Vec3& p : there)
            set.insert({p.x, p.y, p.z});
        return set;
    }();
    for (const Vec3& p : back)
        EXPECT_TRUE(corners.contains({p.x, p.y, p.z}));
}

TEST(Watertight, aCornerOfTheNextRoomIsStitchedIntoTheWall) {
    // The rooms are unequally wide, so that corners of b lie in the middle of a's edges.
    TestWorld source;
    const auto a = source.addBox({10, 10, 1}, {20, 20, 6}), b = source.addBox({20, 13, 1}, {30, 17, 6});
    source.link(a, rectangle({20, 13, 1}, {20, 17, 6}), b);
    const World world = test::loadTestWorld(source);
    EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
    EXPECT_EQ(openEdges(world, 1), 0);
    EXPECT_EQ(openEdges(world, 2), 0);
    EXPECT_EQ(world.zones.size(), 2u);
}

TEST(Watertight, polygonsOfAModelMeetEdgeByEdge) {
    // The walls of the box consist of pieces that meet at T-junctions, and a pane fills the opening.
    test::Walls walls = test::boxExterior({-1.1, -0.7, 0}, {1.3, 0.9, 2.3});
    std::vector<Vec3> pane = test::regularPolygon({-1.1, 0.1, 1.2}, {-1, 0, 0}, 0.6, 7);
    const Vec3 outwards = test::cutOpening(walls, pane);
    ASSERT_NE(outwards, Vec3(0.0));
    if (glm::dot(planeOf(pane).n, outwards) < 0.0)
        std::reverse(pane.begin(), pane.end());
    walls.push_back({pane});
    TestWorld source;
    source.addObject(source.addModel(walls), {});
    const World world = test::loadTestWorld(source);
    const auto mesh = std::find_if(world.meshes.begin(), world.meshes.end(),
                                   [&](const Mesh& m) { return m.polygonCount == walls.size(); });
    ASSERT_NE(mesh, world.meshes.end());
    Balance balance;
    addMesh(balance, world, *mesh);
    EXPECT_EQ(unbalanced(balance), 0);
}

/// Four rooms in a row in a random pose, their corners some hundredths of a millimetre apart, with
/// openings of every kind. The result depends on the seed alone.
TestWorld misalignedComplex(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto roll = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    const double turn = roll(0.0, 6.28);
    const Vec3 at(roll(-400.0, 400.0), roll(-400.0, 400.0), roll(-50.0, 300.0));
    const auto turned = [&](std::vector<Vec3> points) {
        for (Vec3& p : points) {
            const Vec3 jitter(roll(-2e-5, 2e-5), roll(-2e-5, 2e-5), roll(-2e-5, 2e-5));
            p = at +
                Vec3(p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn),
                     p.z) +
                jitter;
        }
        return points;
    };
    TestWorld source;
    std::vector<TestWorld::Cell> cells;
    for (int i = 0; i < 4; ++i) {
        TestWorld::CellOptions options;
        options.frame = test::frameAt({roll(-100, 100), roll(-100, 100), roll(-10, 10)}, roll(0, 360));
        const double south = roll(-4.0, -2.5), north = roll(2.5, 4.0);
        test::Walls walls = test::boxWalls({i * 6.0, south, 0.0}, {i * 6.0 + 6.0, north, 4.0});
        for (test::Wall& wall : walls)
            wall.points = turned(wall.points);
        cells.push_back(source.addCell(walls, options));
    }
    for (std::size_t i = 1; i < 4; ++i) {
        const double x = 6.0 * static_cast<double>(i);
        TestWorld::LinkOptions options;
        options.insideIsPositive = roll(0, 1) < 0.5;
        const int corners = static_cast<int>(roll(3, 13));
        const auto opening = roll(0, 1) < 0.5 ? rectangle({x, -1, 0}, {x, 1, 2})
                                              : test::regularPolygon({x, 0.3, 2}, {1, 0, 0}, 1.1, corners);
        source.link(cells[i - 1], turned(opening), cells[i], options);
    }
    return source;
}

TEST(Watertight, misalignedTurnedComplexesClose) {
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        TestWorld source = misalignedComplex(seed);
        const World world = test::loadTestWorld(source);
        ASSERT_EQ(test::findingsOf(world), "") << "seed " << seed;
        ASSERT_EQ(degenerateTriangles(world), 0) << "seed " << seed;
        for (SpaceIndex i = 1; i < world.spaces.size(); ++i)
            ASSERT_EQ(openEdges(world, i), 0) << "seed " << seed;
        ASSERT_EQ(world.zones.size(), 2u) << "seed " << seed;
    }
}

} // namespace
} // namespace limen::world
