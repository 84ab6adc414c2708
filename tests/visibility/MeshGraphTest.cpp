#include "visibility/MeshGraph.h"
#include "visibility/BoxRoom.h"
#include "visibility/Movement.h"
#include "visibility/SpaceLocator.h"
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

namespace limen::visibility {
namespace {

/// Two rooms of 4 m in a row along x, with a door between them and a front door to the west.
struct TwoRooms {
    BoxRoom hall{{0, 0, 0}, {4, 4, 3}}, parlour{{4, 0, 0}, {8, 4, 3}};
    TwoRooms() {
        hall.open({.axis = 0, .isHigh = true, .number = 7});
        hall.open({.axis = 0, .isHigh = false, .number = 3, .asTriangles = true});
        parlour.open({.axis = 0, .isHigh = false, .number = 1, .asTriangles = true});
    }
    [[nodiscard]] std::vector<SpaceMesh> meshes() { return {hall.mesh(), parlour.mesh()}; }
};

TEST(MeshGraph, joinsOpeningsInOnePlace) {
    TwoRooms rooms;
    const auto made = graphFromMeshes(rooms.meshes());
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_EQ(made->outside, kNone);
    ASSERT_EQ(made->openings.size(), 3u);
    const MeshOpening &front = made->openings[0], &inner = made->openings[1], &back = made->openings[2];
    EXPECT_EQ(front.opening, 3u);
    EXPECT_EQ(front.destination, kNone);
    EXPECT_EQ(inner.opening, 7u);
    EXPECT_EQ(inner.destination, 1u);
    EXPECT_EQ(back.mesh, 1u);
    EXPECT_EQ(back.destination, 0u);
    EXPECT_TRUE(inner.exact && back.exact);
    EXPECT_EQ(made->graph.portals()[inner.portal].reciprocal, back.portal);
    EXPECT_EQ(made->graph.portals()[back.portal].space, 1u);
    EXPECT_EQ(made->graph.polygon(made->graph.portals()[front.portal]).size(), 4u)
        << "two triangles, one opening";
    EXPECT_EQ(floodOnce(made->graph, viewFrom({1, 2, 1.5}, 90, 0, 0)).visits.size(), 2u);
}

TEST(MeshGraph, leadsOtherOpeningsOutside) {
    TwoRooms rooms;
    const auto made = graphFromMeshes(rooms.meshes(), {.hasOutside = true});
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_EQ(made->outside, 2u);
    EXPECT_EQ(made->openings[0].destination, 2u);
    const auto set = floodOnce(made->graph, viewFrom({-3, 2, 1.5}, 90, 0, made->outside));
    ASSERT_EQ(set.visits.size(), 3u);
    EXPECT_EQ(chainOf(set, 2), (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(MeshGraph, callsOpeningsOfOtherSizesInexact) {
    BoxRoom a({0, 0, 0}, {4, 4, 3}), b({4, 0, 0}, {8, 4, 3});
    a.open({.axis = 0, .isHigh = true});
    b.open({.axis = 0, .isHigh = false, .from = {0.1, 0.25}, .to = {0.6, 0.75}});
    const auto made = graphFromMeshes(std::vector<SpaceMesh>{a.mesh(), b.mesh()});
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_FALSE(made->openings[0].exact || made->openings[1].exact);
    EXPECT_EQ(made->openings[0].destination, 1u);
    EXPECT_EQ(made->graph.portals()[made->openings[0].portal].reciprocal, made->openings[1].portal);
}

std::string faultOf(const SpaceMesh& mesh) {
    const auto made = graphFromMeshes(std::vector<SpaceMesh>{mesh});
    EXPECT_FALSE(made);
    return made ? "" : made.error().message();
}

TEST(MeshGraph, namesTheFaultOfAMesh) {
    TwoRooms rooms;
    const SpaceMesh whole = rooms.hall.mesh();
    SpaceMesh open = whole;
    open.faces = open.faces.subspan(1);
    EXPECT_EQ(faultOf(open).substr(0, 49), "space 0: the mesh is not closed: the edge from (0");
    SpaceMesh empty = whole;
    empty.faces = {};
    EXPECT_EQ(faultOf(empty), "space 0: the mesh has no faces");
    std::reverse(rooms.hall.corners.begin(), rooms.hall.corners.end());
    for (MeshFace& face : rooms.hall.faces)
        face.firstCorner =
            static_cast<std::uint32_t>(rooms.hall.corners.size()) - face.firstCorner - face.cornerCount;
    EXPECT_EQ(faultOf({rooms.hall.vertices, rooms.hall.corners, rooms.hall.faces}).substr(0, 31),
              "space 0: the mesh is inside out");
    rooms.hall.corners[4] = 5000;
    EXPECT_EQ(faultOf({rooms.hall.vertices, rooms.hall.corners, rooms.hall.faces}).substr(0, 35),
              "space 0: a corner names vertex 5000");
    rooms.hall.faces[1].cornerCount = 2;
    EXPECT_EQ(faultOf({rooms.hall.vertices, rooms.hall.corners, rooms.hall.faces}),
              "space 0: face 1 has fewer than three corners");
}

TEST(MeshGraph, namesTheFaultOfAnOpening) {
    BoxRoom room({0, 0, 0}, {4, 4, 3});
    static_cast<void>(room.mesh());
    room.faces[0].opening = room.faces[1].opening = 9; // two walls that do not touch
    EXPECT_EQ(faultOf({room.vertices, room.corners, room.faces}),
              "opening 9 of space 0: its faces have no single outline");
    room.faces[1].opening = kNone;
    room.faces[2].opening = 9; // two walls around a corner
    EXPECT_EQ(faultOf({room.vertices, room.corners, room.faces}),
              "opening 9 of space 0: its outline is not flat");
    EXPECT_FALSE(graphFromMeshes({}, {.tolerance = -1}));
}

/// Rooms in a lattice, with random openings between neighbours.
struct Lattice {
    static constexpr int kSize = 3;
    static constexpr double kRoom = 4.0;
    std::vector<BoxRoom> rooms;
    TestGraph expected;

    explicit Lattice(std::mt19937& random) {
        for (int i = 0; i < kSize * kSize * kSize; ++i) {
            const Vec3 low = Vec3(i % kSize, i / kSize % kSize, i / kSize / kSize) * kRoom;
            rooms.emplace_back(low, low + kRoom);
            expected.addSpace();
        }
        expected.addSpace(); // outside
        std::uniform_real_distribution<double> share(0.1, 0.9);
        const int steps[3] = {1, kSize, kSize * kSize};
        for (int i = 0; i < kSize * kSize * kSize; ++i) {
            const int at[3] = {i % kSize, i / kSize % kSize, i / kSize / kSize};
            for (int axis = 0; axis < 3; ++axis) {
                if (random() % 3 == 0)
                    continue;
                const std::pair<double, double> u = std::minmax({share(random), share(random)}),
                                                v = std::minmax({share(random), share(random)});
                BoxRoom::Hole hole{axis,
                                   true,
                                   {u.first, v.first},
                                   {u.second, v.second},
                                   static_cast<std::uint32_t>(axis),
                                   random() % 2 == 0};
                if (u.second - u.first < 0.05 || v.second - v.first < 0.05)
                    continue;
                const bool isLast = at[axis] == kSize - 1;
                const auto here = static_cast<std::uint32_t>(i);
                const auto there =
                    static_cast<std::uint32_t>(isLast ? kSize * kSize * kSize : i + steps[axis]);
                rooms[here].open(hole);
                expected.link(here, there, rooms[here].polygonOf(hole));
                if (!isLast) {
                    hole.isHigh = false;
                    hole.number = static_cast<std::uint32_t>(axis) + 3;
                    hole.asTriangles = random() % 2 == 0;
                    rooms[there].open(hole);
                }
            }
        }
    }
    [[nodiscard]] std::vector<SpaceMesh> meshes() {
        std::vector<SpaceMesh> all;
        for (BoxRoom& room : rooms)
            all.push_back(room.mesh());
        return all;
    }
    static Vec3 randomPoint(std::mt19937& random) {
        std::uniform_real_distribution<double> along(-0.5, kSize * kRoom + 0.5);
        return {along(random), along(random), along(random)};
    }
    static std::uint32_t spaceOf(const Vec3& point) {
        const Vec3 cell = glm::floor(point / kRoom);
        for (int axis = 0; axis < 3; ++axis)
            if (cell[axis] < 0 || cell[axis] >= kSize)
                return kNone;
        return static_cast<std::uint32_t>(cell.x + kSize * (cell.y + kSize * cell.z));
    }
};

/// The regions of each chain of spaces, painted: the visit of each of 16 × 16 pixels as its chain.
std::vector<std::vector<std::uint32_t>> chainsOnScreen(const VisibleSet& set) {
    std::vector<std::vector<std::uint32_t>> chains;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            chains.push_back(
                chainOf(set, ownerOf(set, Vec3((2 * x + 1) / 16.0 - 1, (2 * y + 1) / 16.0 - 1, 1))));
    return chains;
}

RC_GTEST_PROP(MeshGraphProperty, seesAsTheGraphMadeByHandDoes, (unsigned seed)) {
    std::mt19937 random(seed);
    Lattice lattice(random);
    const auto made = graphFromMeshes(lattice.meshes(), {.hasOutside = true});
    RC_ASSERT(made.has_value());
    const Graph expected = lattice.expected.build();
    RC_ASSERT(made->graph.portals().size() == expected.portals().size());
    for (int i = 0; i < 4; ++i) {
        const Vec3 eye =
            Vec3(2.0) + glm::floor(Lattice::randomPoint(random) / 4.0) * 4.0 + Vec3(0.1, 0.2, 0.3);
        const std::uint32_t found = Lattice::spaceOf(eye);
        const View view =
            viewFrom(eye, static_cast<double>(random() % 360), static_cast<double>(random() % 160) - 80.0,
                     found == kNone ? made->outside : found);
        RC_ASSERT(chainsOnScreen(floodOnce(made->graph, view)) == chainsOnScreen(floodOnce(expected, view)));
    }
}

RC_GTEST_PROP(SpaceLocatorProperty, findsTheRoomOfAnyPoint, (unsigned seed)) {
    std::mt19937 random(seed);
    Lattice lattice(random);
    const auto locator = SpaceLocator::build(lattice.meshes(), kPairTolerance);
    RC_ASSERT(locator.has_value());
    for (int i = 0; i < 20; ++i) {
        const Vec3 point = Lattice::randomPoint(random);
        RC_ASSERT(locator->spaceAt(point) == Lattice::spaceOf(point));
    }
}

TEST(SpaceLocator, countsFacesEdgesAndCornersAsInside) {
    TwoRooms rooms;
    const auto locator = SpaceLocator::build(rooms.meshes(), kPairTolerance);
    ASSERT_TRUE(locator);
    std::vector<std::uint32_t> all;
    locator->spacesAt({4, 2, 1.5}, all); // in the opening between the rooms
    EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(locator->spaceAt({4, 2, 1.5}), 0u);
    EXPECT_EQ(locator->spaceAt({8, 2, 1.5}), 1u);
    EXPECT_EQ(locator->spaceAt({8.001, 2, 1.5}), kNone);
    EXPECT_EQ(locator->spaceAt({NAN, 2, 1.5}), kNone);
}

TEST(SpaceLocator, knowsRoomsThatAreNotConvexAndRoomsThatOverlap) {
    // An L: the square from 0 to 4 without its north-east quarter; floor and ceiling are non-convex faces.
    const std::vector<Vec3> plan{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}};
    std::vector<Vec3> vertices = plan;
    for (const Vec3& corner : plan)
        vertices.push_back(corner + Vec3(0, 0, 3));
    std::vector<std::uint32_t> corners;
    std::vector<MeshFace> faces;
    const auto add = [&](const std::vector<std::uint32_t>& face) {
        faces.push_back(
            {static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(face.size()), kNone});
        corners.insert(corners.end(), face.begin(), face.end());
    };
    add({0, 1, 2, 3, 4, 5});
    add({11, 10, 9, 8, 7, 6});
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        add({i, i + 6, next + 6, next});
    }
    BoxRoom cellar({0, 0, -1}, {1, 1, 1});
    const auto locator = SpaceLocator::build(
        std::vector<SpaceMesh>{{vertices, corners, faces}, cellar.mesh()}, kPairTolerance);
    ASSERT_TRUE(locator) << locator.error().message();
    EXPECT_EQ(locator->spaceAt({3, 1, 1}), 0u);
    EXPECT_EQ(locator->spaceAt({1, 3, 1}), 0u);
    EXPECT_EQ(locator->spaceAt({3, 3, 1}), kNone);
    std::vector<std::uint32_t> all;
    locator->spacesAt({0.5, 0.5, 0.5}, all);
    EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1}));
}

TEST(Movement, passesOpeningsAndStopsAtClosedOnes) {
    TwoRooms rooms;
    const auto made = graphFromMeshes(rooms.meshes(), {.hasOutside = true});
    ASSERT_TRUE(made);
    const Vec3 outside(-2, 2, 1.5), inHall(2, 2, 1.5), inParlour(6, 2, 1.5);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, made->outside, outside, inParlour).space, 1u);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 1, inParlour, outside).space, made->outside);
    std::vector<std::uint8_t> closed(made->graph.portals().size(), 0);
    closed[made->openings[1].portal] = 1;
    const Movement stopped = spaceAfterMove(made->graph, closed, made->outside, outside, inParlour);
    EXPECT_EQ(stopped.space, 0u);
    EXPECT_EQ(stopped.stoppedBy, made->openings[1].portal);
    EXPECT_NEAR(stopped.fraction, 0.75, 1e-12);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 0, inHall, {2, 9, 1.5}).space, 0u) << "walls are not known";
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 99, inHall, inParlour).space, kNone);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 0, {NAN, 0, 0}, inParlour).space, kNone);
}

TEST(Movement, passesAPlaneOnceFromOneStepToTheNext) {
    TwoRooms rooms;
    const auto made = graphFromMeshes(rooms.meshes());
    ASSERT_TRUE(made);
    const Vec3 before(3, 2, 1.5), inPlane(4, 2, 1.5), beyond(5, 2, 1.5);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 0, before, inPlane).space, 0u);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 0, inPlane, beyond).space, 1u);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 1, beyond, inPlane).space, 1u);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 1, inPlane, before).space, 0u);
    EXPECT_EQ(spaceAfterMove(made->graph, {}, 0, inPlane, inPlane).space, 0u);
}

/// In a lattice a straight way passes openings only, or stays in the last space before a wall.
RC_GTEST_PROP(MovementProperty, endsInTheSameSpaceInOneStepAndInMany, (unsigned seed)) {
    std::mt19937 random(seed);
    Lattice lattice(random);
    const Graph graph = lattice.expected.build();
    for (int i = 0; i < 20; ++i) {
        const Vec3 from = Lattice::randomPoint(random), to = Lattice::randomPoint(random);
        const std::uint32_t start = Lattice::spaceOf(from);
        if (start == kNone)
            continue;
        const std::uint32_t end = spaceAfterMove(graph, {}, start, from, to).space;
        std::uint32_t space = start;
        Vec3 at = from;
        for (int step = 1; step <= 7; ++step) {
            const Vec3 next = step == 7 ? to : from + (to - from) * (step / 7.0);
            space = spaceAfterMove(graph, {}, space, at, next).space;
            at = next;
        }
        RC_ASSERT(space == end);
        RC_ASSERT(spaceAfterMove(graph, {}, end, to, from).space == start);
    }
}

} // namespace
} // namespace limen::visibility
