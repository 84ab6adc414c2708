#include "geometry/ConvexPolygon.h"
#include "worlds/pictures/Noise.h"
#include "worlds/records/Bsp.h"
#include "worlds/records/Seams.h"
#include "worlds/records/Sight.h"
#include "worlds/shapes/CellComplex.h"
#include "worlds/shapes/Panel.h"
#include "worlds/shapes/RoomPlan.h"

#include <gtest/gtest.h>
#include <set>

namespace limen::worlds {
namespace {

double area(const Rect& r) {
    return (r.u1 - r.u0) * (r.v1 - r.v0);
}

TEST(Panel, whatIsLeftAndTheHolesMakeTheWhole) {
    const Rect whole{0, 0, 10, 4};
    const std::vector<Rect> holes{{1, 1, 2, 3}, {4, 0, 5, 2}, {4.5, 2.5, 7, 4}};
    double left = 0.0;
    for (const Rect& r : withoutHoles(whole, holes)) {
        EXPECT_GT(area(r), 0.0);
        for (const Rect& h : holes)
            EXPECT_FALSE(r.u0 < h.u1 && r.u1 > h.u0 && r.v0 < h.v1 && r.v1 > h.v0) << "lies in a hole";
        left += area(r);
    }
    EXPECT_NEAR(left, 40.0 - 2.0 - 2.0 - 3.75, 1e-12);
}

TEST(Panel, aHoleAsLargeAsTheWallLeavesNothing) {
    EXPECT_TRUE(withoutHoles({0, 0, 1, 2}, {{0, 0, 1, 2}}).empty());
}

TEST(Panel, aHoleOverTheBorderIsCutThere) {
    const std::vector<Rect> left = withoutHoles({0, 0, 4, 4}, {{1, -1, 3, 1}});
    double sum = 0.0;
    for (const Rect& r : left)
        sum += area(r);
    EXPECT_NEAR(sum, 14.0, 1e-12);
}

double areaOf(const std::vector<Vec3>& polygon) {
    return 0.5 * glm::length(newellNormal(polygon));
}

TEST(Shells, stripsAroundAnArchAreTheWallWithoutIt) {
    const Face wall = planarFace({{0, 0, 0}, {6, 0, 0}, {6, 0, 4}, {0, 0, 4}}, Material::StoneWall);
    const std::vector<Outline> arches{archOutline({{1.5, 0, 0}, {1, 0, 0}, 1.0}, 1.5, 2.5),
                                      archOutline({{4.5, 0, 1}, {1, 0, 0}, 0.5}, 1.0, 1.5)};
    double left = areaOf(arches[0]) + areaOf(arches[1]);
    for (const Face& strip : faceWithout(wall, arches)) {
        EXPECT_NEAR(glm::dot(faceNormal(strip), faceNormal(wall)), 1.0, 1e-12);
        left += areaOf(strip.points);
    }
    EXPECT_NEAR(left, 24.0, 1e-9);
}

TEST(Shells, anOpeningAsLargeAsTheFaceLeavesNothingWhicheverWayItRuns) {
    const Outline section = archOutline({{0, 0, 0}, {1, -1, 0}, 0.75}, 1.5, 2.75);
    Outline back = section;
    std::reverse(back.begin(), back.end());
    const Face face = planarFace(section, Material::Brick);
    EXPECT_TRUE(faceWithout(face, {section}).empty());
    EXPECT_TRUE(faceWithout(face, {back}).empty());
}

TEST(Shells, cornersCutInAWallAt45DegreesLieExactlyInIt) {
    const Face wall = planarFace({{8, 3, 0}, {3, 8, 0}, {3, 8, 8}, {8, 3, 8}}, Material::StoneWall);
    for (Face& strip : faceWithout(wall, {archOutline({{5.5, 5.5, 0}, {1, -1, 0}, 0.75}, 1.5, 2.75)})) {
        std::vector<Face> one{strip};
        closeSeams(one);
        for (const Vec3& p : one[0].points)
            EXPECT_EQ(p.x + p.y, 11.0);
    }
}

TEST(Seams, theFinestGridIsOneThatFloatsHold) {
    std::vector<Face> faces{
        planarFace({{0, 0, 0}, {7.1, 0, 0}, {7.1, -15.3, 3.3}, {0, -15.3, 3.3}}, Material::Planks)};
    EXPECT_EQ(finestGrid(faces), std::ldexp(1.0, -20));
    const std::vector<Face> planned = faces;
    closeSeams(faces, finestGrid(faces));
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3& p = faces[0].points[k];
        EXPECT_EQ(Vec3(Vec3f(p)), p);
        EXPECT_LT(glm::length(p - planned[0].points[k]), 1e-6);
    }
    EXPECT_GT(finestGrid({planarFace({{0, 0, 0}, {100, 0, 0}, {100, 100, 0}}, Material::Planks)}),
              finestGrid(planned));
}

TEST(Seams, aVertexOnANeighboursEdgeIsGivenToIt) {
    std::vector<Face> faces{planarFace({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, Material::Planks),
                            planarFace({{0, -1, 0}, {1, -1, 0}, {1, 0, 0}, {0, 0, 0}}, Material::Planks)};
    closeSeams(faces);
    ASSERT_EQ(faces.size(), 2u);
    EXPECT_EQ(faces[0].points.size(), 5u);
    EXPECT_EQ(faces[0].uvs.size(), 5u);
    // The new vertex is the first one. With another corner of that edge, a triangle would have no area.
    for (std::size_t k = 1; k + 1 < faces[0].points.size(); ++k) {
        EXPECT_GT(glm::length(glm::cross(faces[0].points[k] - faces[0].points[0],
                                         faces[0].points[k + 1] - faces[0].points[0])),
                  0.1);
    }
}

TEST(Seams, aPolygonWithTwoNewVerticesOnEverySideIsSplitAroundItsMiddle) {
    std::vector<Face> faces{planarFace({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}, Material::Planks)};
    for (const double t : {1.0, 2.0}) {
        for (const auto& corner : {Vec3(t, 0, 0), Vec3(3, t, 0), Vec3(t, 3, 0), Vec3(0, t, 0)}) {
            faces.push_back(
                planarFace({corner, corner + Vec3(0.1, 0, 1), corner + Vec3(0, 0.1, 1)}, Material::Planks));
        }
    }
    closeSeams(faces);
    EXPECT_EQ(faces.size(), 12u + 8u);
}

/// True if the point's leaf of the solid tree is solid.
bool solidAt(const dat::BspTree& tree, const Vec3& p) {
    std::size_t node = 0;
    while (tree.nodes.at(node).tag != dat::BspTag::Leaf) {
        const dat::BspNode& n = tree.nodes[node];
        const bool front = glm::dot(Vec3(n.plane.n), p) + static_cast<double>(n.plane.d) >= 0.0;
        node = static_cast<std::size_t>(front ? n.positive : n.negative);
    }
    return tree.nodes[node].solid != 0;
}

TEST(Bsp, physicsTreeOfABoxIsSolidInside) {
    FaceMesh mesh;
    mesh.box({-1, -2, 0}, {1, 2, 3}, Material::StoneWall);
    const std::vector<std::uint16_t> ids{0, 1, 2, 3, 4, 5};
    const dat::BspTree tree = buildPhysicsBsp(mesh.faces(), ids);
    EXPECT_TRUE(solidAt(tree, {0, 0, 1}));
    EXPECT_TRUE(solidAt(tree, {0.9, -1.9, 2.9}));
    EXPECT_FALSE(solidAt(tree, {1.1, 0, 1}));
    EXPECT_FALSE(solidAt(tree, {0, 0, 3.1}));
}

TEST(Bsp, physicsTreeOfARoomIsEmptyInside) {
    const CellPlan room = roomWithOpenings({.name = "room", .min = {0, 0, 0}, .max = {4, 3, 2}}, {});
    std::vector<std::uint16_t> ids(room.faces.size());
    const dat::BspTree tree = buildPhysicsBsp(room.faces, ids);
    EXPECT_FALSE(solidAt(tree, {2, 1, 1}));
    EXPECT_TRUE(solidAt(tree, {2, 1, -0.1}));
    EXPECT_TRUE(solidAt(tree, {-0.1, 1, 1}));
}

/// A room with a door in its north wall, and a second room behind it. The only window is in the second room:
/// in its north wall, or in its south wall beside the first room, where no ray through the door reaches it.
SightMap twoRooms(Side windowSide, double windowFrom, double windowTo) {
    const auto cell = [](const CellPlan& plan, std::vector<std::size_t> leads) {
        SightMap::Cell out;
        std::size_t k = 0;
        for (const Face& face : plan.faces) {
            out.planes.push_back(planeOf(face.points));
            if (face.portal)
                out.portals.push_back({face.points, leads[k++]});
        }
        return out;
    };
    const Rect door{4, 0, 5, 2};
    const CellPlan first =
        roomWithOpenings({.name = "first", .min = {0, 0, 0}, .max = {5, 4, 2}}, {{Side::North, door}});
    const CellPlan second =
        roomWithOpenings({.name = "second", .min = {4, 4, 0}, .max = {9, 5, 2}},
                         {{Side::South, door}, {windowSide, {windowFrom, 1, windowTo, 2}}});
    return {{cell(first, {1}), cell(second, {0, SightMap::kOutside})}};
}

TEST(Sight, aWindowInLineWithTheDoorIsSeen) {
    EXPECT_TRUE(seesOutside(twoRooms(Side::North, 4.2, 4.8), 0));
}

TEST(Sight, aWindowBesideTheDoorIsSeenFromItsOwnRoomOnly) {
    EXPECT_FALSE(seesOutside(twoRooms(Side::South, 6.5, 8.0), 0));
    EXPECT_TRUE(seesOutside(twoRooms(Side::South, 6.5, 8.0), 1));
}

TEST(Sight, ofAllCellsIsTheSightOfEach) {
    for (const SightMap& map : {twoRooms(Side::North, 4.2, 4.8), twoRooms(Side::South, 6.5, 8.0)}) {
        const std::vector<bool> all = cellsThatSeeOutside(map);
        for (std::size_t c = 0; c < map.cells.size(); ++c)
            EXPECT_EQ(all[c], seesOutside(map, c));
    }
}

TEST(Noise, tiles) {
    for (int k = 0; k < 20; ++k) {
        const double t = k / 20.0;
        EXPECT_NEAR(fbm(0.0, t, 4, 6, 4, 7), fbm(1.0, t, 4, 6, 4, 7), 1e-9);
        EXPECT_NEAR(ridged(t, 0.0, 3, 3, 3, 7), ridged(t, 1.0, 3, 3, 3, 7), 1e-9);
        EXPECT_NEAR(cellular(t, 0.0, 5, 4, 0.9, 7).nearest, cellular(t, 1.0, 5, 4, 0.9, 7).nearest, 1e-9);
    }
}

// A bent face was cut by its own plane at every level.
TEST(Bsp, aBentFaceIsCutOnce) {
    std::vector<Face> faces;
    for (const double bend : {0.0, 0.02, 0.5}) {
        Face face;
        face.points = {{0, 0, bend}, {1, 0, 0}, {1, 1, bend}, {0, 1, 0}};
        faces.push_back(face);
    }
    const dat::BspTree drawing = buildDrawingBsp(faces);
    EXPECT_LT(drawing.nodes.size(), 64u);
    const std::uint16_t ids[] = {0, 1, 2};
    EXPECT_LT(buildPhysicsBsp(faces, ids).nodes.size(), 64u);
    std::set<std::uint16_t> listed;
    for (const dat::BspNode& node : drawing.nodes)
        listed.insert(node.polygonIds.begin(), node.polygonIds.end());
    EXPECT_EQ(listed.size(), 3u);
}

} // namespace
} // namespace limen::worlds
