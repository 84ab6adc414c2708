// Zones are disjoint and closed: compared with a count of crossings that is independent of the code that
// makes zones.
#include "frame/WorldGraph.h"
#include "visibility/ZoneCheck.h"
#include "worlds/GeneratedWorlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>

namespace limen::test {
namespace {

struct Face {
    Vec3 a{0.0}, b{0.0}, c{0.0};
};

/// Whether a face is part of a portal's polygon: its picture.
bool isPictureOf(std::span<const Vec3> outline, const Face& face) {
    const auto isCorner = [&](const Vec3& at) {
        return std::any_of(outline.begin(), outline.end(),
                           [&](const Vec3& corner) { return glm::length(corner - at) < 0.001; });
    };
    return isCorner(face.a) && isCorner(face.b) && isCorner(face.c);
}

/// The triangles that bound a cell, seen from inside: its shell without pictures in openings, and its portals.
std::vector<Face> facesOf(const world::World& world, const world::Space& space) {
    std::vector<Face> faces;
    const world::Instance& shell = world.instances[space.shell];
    const world::Mesh& mesh = world.meshes[shell.mesh];
    const Vec3 origin = world.blocks[shell.block].origin();
    for (const world::Mesh::Range& range : mesh.ranges) {
        for (std::uint32_t i = 0; i + 2 < range.indexCount; i += 3) {
            const auto corner = [&](std::uint32_t k) {
                const std::uint32_t index = world.indices[range.firstIndex + i + k];
                return world.vertices[mesh.firstVertex + index].corner() + origin;
            };
            faces.push_back({corner(0), corner(1), corner(2)});
        }
    }
    for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
        const auto outline = polygonOf(world, world.portals[p]);
        std::erase_if(faces, [&](const Face& face) { return isPictureOf(outline, face); });
        for (std::size_t i = 1; i + 1 < outline.size(); ++i)
            faces.push_back({outline[0], outline[i], outline[i + 1]});
    }
    return faces;
}

/// Number of times the ray leaves through the faces minus the number of times it enters.
int crossings(const std::vector<Face>& faces, const Vec3& from, const Vec3& direction) {
    int sum = 0;
    for (const Face& f : faces) {
        const Vec3 a = f.a - from, b = f.b - from, c = f.c - from;
        // Signs of the ray relative to the edges. If all are equal, it meets the triangle.
        const double ab = glm::dot(direction, glm::cross(a, b)), bc = glm::dot(direction, glm::cross(b, c)),
                     ca = glm::dot(direction, glm::cross(c, a));
        const bool front = ab < 0 && bc < 0 && ca<0, back = ab> 0 && bc > 0 && ca > 0;
        const Vec3 normal = glm::cross(b - a, c - a);
        const double speed = glm::dot(normal, direction);
        if ((front || back) && glm::dot(normal, a) / speed > 0.0)
            sum += speed < 0 ? 1 : -1;
    }
    return sum;
}

/// Numbers of points where a zone is open or its cells overlap, and of points inside one cell.
struct Faults {
    std::size_t open = 0, shared = 0, inside = 0;
};

Faults faultsOf(const world::World& world, const world::Zone& zone, std::mt19937& random) {
    const auto spaces = std::span(world.zoneSpaces).subspan(zone.firstSpace, zone.spaceCount);
    std::vector<std::vector<Face>> faces;
    Aabb box;
    for (const world::SpaceIndex s : spaces) {
        faces.push_back(facesOf(world, world.spaces[s]));
        box.include(world.spaces[s].bounds.min);
        box.include(world.spaces[s].bounds.max);
    }
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto anywhere = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    Faults faults;
    for (int i = 0; i < 60; ++i) {
        const Vec3 point = box.min + (box.max - box.min) * anywhere();
        const Vec3 one = anywhere() - 0.5, other = anywhere() - 0.5;
        int holders = 0;
        for (const auto& cell : faces) {
            const int inside = crossings(cell, point, one);
            faults.open += inside != crossings(cell, point, other) || inside < 0 || inside > 1 ? 1 : 0;
            holders += inside;
        }
        faults.shared += holders > 1 ? 1 : 0;
        faults.inside += holders == 1 ? 1 : 0;
    }
    return faults;
}

TEST(ZoneProperty, cellsOfOneZoneAreClosedAndDisjoint) {
    std::size_t inside = 0;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        for (const auto kind : {worlds::GeneratedKind::Complex, worlds::GeneratedKind::Dungeon}) {
            const worlds::test::GeneratedWorld files({kind, 30, seed, 0.05});
            const world::World world = files.load(files.blocks().front());
            std::mt19937 random(seed);
            for (const world::Zone& zone : world.zones) {
                if (zone.spaceCount < 2)
                    continue; // alone it need be neither
                const Faults faults = faultsOf(world, zone, random);
                EXPECT_EQ(faults.open, 0u) << worlds::test::nameOf(files.spec());
                EXPECT_EQ(faults.shared, 0u) << worlds::test::nameOf(files.spec());
                inside += faults.inside;
            }
        }
    }
    EXPECT_GT(inside, 1000u) << "too few points were in a cell for a meaningful test";
}

/// The faces of all cells as walls.
void addWalls(const world::World& world, std::vector<visibility::WallDesc>& walls,
              std::vector<Vec3>& vertices) {
    for (std::uint32_t i = 0; i < world.spaces.size(); ++i) {
        if (world.spaces[i].shell == world::kNone)
            continue; // the outside
        for (const Face& face : facesOf(world, world.spaces[i])) {
            walls.push_back({i, static_cast<std::uint32_t>(vertices.size()), 3});
            vertices.insert(vertices.end(), {face.a, face.b, face.c});
        }
    }
}

TEST(ZoneProperty, zonesOfWorldsPassTheCheckOfCallersGraphs) {
    std::size_t compared = 0, faults = 0;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        for (const auto kind : {worlds::GeneratedKind::Complex, worlds::GeneratedKind::Dungeon,
                                worlds::GeneratedKind::Nested}) {
            const worlds::test::GeneratedWorld files({kind, 30, seed, 0.05});
            world::World world = files.load(files.blocks().front());
            std::vector<visibility::WallDesc> walls;
            std::vector<Vec3> vertices;
            addWalls(world, walls, vertices);
            const auto graph = frame::visibilityGraph(world);
            ASSERT_TRUE(graph);
            const Result<void> checked = visibility::checkZones(*graph, walls, vertices);
            EXPECT_TRUE(checked) << worlds::test::nameOf(files.spec()) << ": " << checked.error().message();
            compared += walls.size();
            for (std::uint32_t i = 1; i < world.spaces.size(); ++i)
                world.spaces[i].zone = world.spaces[1].zone; // all cells in one zone
            const auto merged = frame::visibilityGraph(world);
            ASSERT_TRUE(merged);
            faults +=
                kind == worlds::GeneratedKind::Nested && !visibility::checkZones(*merged, walls, vertices)
                    ? 1
                    : 0;
        }
    }
    EXPECT_GT(compared, 10000u) << "too few walls for a meaningful test";
    EXPECT_GT(faults, 0u) << "nested rooms in one zone are no fault";
}

} // namespace
} // namespace limen::test
