// The gates beside ownership (docs/gates.md). On worlds that satisfy their conditions they are right to the pixel.
// Elsewhere each has mistakes of its own.
#include "picture/MechanismScenes.h"
#include "picture/PictureWorld.h"

#include "support/TestWorld.h"

#include <gtest/gtest.h>

#include <random>

namespace limen::test {
namespace {

using frame::Gate;

/// An eye in a cell of a world.
struct Standpoint {
    Vec3 low{0.0}, high{0.0};            ///< the eye is in this box
    std::optional<TestWorld::Cell> cell; ///< none: outside
};

/// A world in which every gate is exact: convex cells that do not overlap each other or the ground, openings of at
/// most eight edges, and no way out of a house that the eye looks into from outside.
struct ExactWorld {
    TestWorld world;
    std::vector<Standpoint> standpoints;
};

/// Cells in a row and around a pillar, with openings of four, six and eight edges; sealed.
void addMaze(ExactWorld& exact) {
    TestWorld& world = exact.world;
    const auto room = [&](const Vec3& low, const Vec3& high, const char* surface) {
        const TestWorld::Cell cell = world.addBox(low, high, surface);
        exact.standpoints.push_back({low + Vec3(0.3), high - Vec3(0.3), cell});
        return cell;
    };
    const auto south = room({20, 20, 40}, {26, 24, 43}, "brown");
    const auto east = room({26, 20, 40}, {30, 24, 43}, "blue");
    const auto north = room({26, 24, 40}, {30, 30, 43}, "red");
    const auto west = room({20, 24, 40}, {26, 30, 43}, "green");
    const auto tower = room({20, 24, 43}, {26, 30, 49}, "grey");
    world.link(south, rectangle({26, 21, 40}, {26, 23, 42.2}), east);
    world.link(east, regularPolygon({28, 24, 41.4}, {0, 1, 0}, 1.1, 8), north);
    world.link(north, regularPolygon({26, 27, 41.4}, {1, 0, 0}, 1.1, 6), west);
    world.link(west, rectangle({22, 24, 40}, {23, 24, 42}), south);
    world.link(west, regularPolygon({23, 27, 43}, {0, 0, 1}, 1.3, 6), tower);
}

/// Two houses on flat ground, each with one opening to the outside, and a box in each and between them.
void addHouses(ExactWorld& exact) {
    TestWorld& world = exact.world;
    world.setFlatTerrain(world.home(), 0);
    const std::uint32_t table = world.addModel(insideOut(boxWalls({-0.2, -0.2, 0}, {0.2, 0.2, 0.8}, "red")));
    const auto house = [&](const Vec3& low, const Vec3& high, const std::vector<Vec3>& opening) {
        const TestWorld::Cell cell = world.addBox(low, high, "brown");
        const TestWorld::Cell behind =
            world.addBox({high.x, low.y, low.z}, {high.x + 4, high.y, high.z}, "blue");
        world.link(cell, rectangle({high.x, low.y + 1, low.z}, {high.x, low.y + 2.5, low.z + 2}), behind);
        const auto exit = world.openOutside(cell, opening);
        world.addBuilding(boxExterior({low.x, low.y, 0}, {high.x + 4, high.y, high.z}), {exit});
        world.addStatic(cell, table, frameAt({low.x + 1, low.y + 1, low.z}));
        exact.standpoints.push_back({low + Vec3(0.3), high - Vec3(0.3), cell});
    };
    house({90, 90, 0.2}, {96, 95, 3.2}, rectangle({92, 95, 0.2}, {94, 95, 2.4}));
    house({90, 110, 0.2}, {96, 115, 3.2}, regularPolygon({93, 110, 1.6}, {0, -1, 0}, 1.0, 8));
    world.addObject(table, frameAt({93, 102, 0}));
    exact.standpoints.push_back({{80, 97, 0.5}, {105, 108, 6}, std::nullopt});
}

/// The number of wrong pixels of random views. Each fails the test.
std::uint64_t judgeRandomViews(ExactWorld& exact, Gate gate, int views) {
    PictureWorld pictures(exact.world);
    pictures.width = 40;
    pictures.height = 24;
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return low +
               (high - low) * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()));
    };
    std::uint64_t all = 0;
    int several = 0;
    for (int i = 0; i < views; ++i) {
        const Standpoint& at = exact.standpoints[static_cast<std::size_t>(i) % exact.standpoints.size()];
        const Vec3 eye{between(at.low.x, at.high.x), between(at.low.y, at.high.y),
                       between(at.low.z, at.high.z)};
        const world::SpaceIndex root = at.cell ? pictures.space(exact.world.id(*at.cell)) : world::kOutside;
        const double yaw = between(0, 360), pitch = between(-40, 40);
        frame::FrameView view = pictures.look(eye, yaw, pitch, root);
        view.gate = gate;
        const Picture picture = pictures.shoot(view);
        const std::uint64_t wrong = pictures.judge(picture).findings();
        several += picture.visible.visits.size() > 1 ? 1 : 0;
        all += wrong;
        EXPECT_EQ(wrong, 0u) << "view " << i << ": eye " << eye.x << "," << eye.y << "," << eye.z << " yaw "
                             << yaw << " pitch " << pitch;
    }
    if (gate != Gate::Ownership) // in one zone, depth alone decides
        EXPECT_GT(several, views / 4) << "views that need a gate";
    return all;
}

constexpr int kExactViews = 2000; // of each of the two worlds

struct EachGate : ::testing::TestWithParam<Gate> {};
INSTANTIATE_TEST_SUITE_P(Gates, EachGate, ::testing::ValuesIn(frame::kGates),
                         [](const auto& gate) { return std::string(nameOf(gate.param)); });

TEST_P(EachGate, areExactInAMazeOfConvexCells) {
    ExactWorld maze;
    addMaze(maze);
    EXPECT_EQ(judgeRandomViews(maze, GetParam(), kExactViews), 0u);
}

TEST_P(EachGate, areExactForHousesWithOneOpening) {
    ExactWorld houses;
    addHouses(houses);
    EXPECT_EQ(judgeRandomViews(houses, GetParam(), kExactViews), 0u);
}

/// Views of the houses: into one from outside, out of one, and one wall alone.
std::vector<frame::FrameView> viewsOf(PictureWorld& pictures, ExactWorld& houses) {
    const world::SpaceIndex room = pictures.space(houses.world.id(*houses.standpoints[0].cell));
    return {pictures.look({93, 105, 1.5}, 180, 0, world::kOutside), pictures.look({93, 92, 1.5}, 0, 0, room),
            pictures.look({93, 92, 1.5}, 180, 0, room)};
}

TEST(Gates, whereOnlyTheRootIsSeenAllPicturesAreEqual) {
    ExactWorld houses;
    addHouses(houses);
    PictureWorld pictures(houses.world);
    frame::FrameView wall = viewsOf(pictures, houses)[2];
    frame::FrameView land = pictures.look({93, 105, 1.5}, 90, 0, world::kOutside);
    for (frame::FrameView* view : {&wall, &land}) {
        const Picture owned = pictures.shoot(*view);
        ASSERT_EQ(owned.visible.visits.size(), 1u);
        for (const Gate gate : {Gate::Planes, Gate::Depth}) {
            view->gate = gate;
            const Picture picture = pictures.shoot(*view);
            EXPECT_EQ(picture.ids, owned.ids) << nameOf(gate);
            EXPECT_EQ(picture.colour, owned.colour) << nameOf(gate);
            if (gate == Gate::Planes)
                EXPECT_EQ(picture.depth, owned.depth);
        }
    }
}

// Clip distances, depth tests and cleared depth of one gate must not reach another.
TEST(Gates, leaveNoStateForTheNextFrame) {
    ExactWorld houses;
    addHouses(houses);
    PictureWorld pictures(houses.world);
    for (frame::FrameView view : viewsOf(pictures, houses)) {
        std::vector<Picture> alone;
        for (const Gate gate : frame::kGates) {
            view.gate = gate;
            alone.push_back(pictures.shoot(view));
        }
        for (const Gate before : frame::kGates) {
            for (std::size_t g = 0; g < frame::kGates.size(); ++g) {
                view.gate = before;
                static_cast<void>(pictures.shoot(view));
                view.gate = frame::kGates[g];
                const Picture after = pictures.shoot(view);
                EXPECT_EQ(after.ids, alone[g].ids);
                EXPECT_EQ(after.colour, alone[g].colour);
                EXPECT_EQ(after.depth, alone[g].depth);
                EXPECT_EQ(after.glCalls, alone[g].glCalls);
            }
        }
    }
}

std::uint64_t wrongPixels(NamedView named, Gate gate) {
    PictureOptions options;
    options.moving = named.moving;
    PictureWorld pictures(named.world, options);
    pictures.width = named.width;
    pictures.height = named.height;
    pictures.fov = named.fov;
    if (named.doors) {
        motion::DynamicStateInput input;
        input.allDoors = named.doors;
        pictures.setDynamics(input);
    }
    const world::SpaceIndex root = named.root ? pictures.space(named.world.id(*named.root)) : world::kOutside;
    frame::FrameView view = pictures.look(named.eye, named.yaw, named.pitch, root);
    view.gate = gate;
    return pictures.judge(pictures.shoot(view)).findings();
}

// A hill stands before a tunnel's mouth, and the ground runs through the tunnel.
TEST(Gates, showTheirMistakeWhereTheGroundOverlapsACell) {
    EXPECT_EQ(wrongPixels(hillBeforeTheTunnel(), Gate::Ownership), 0u);
    EXPECT_GT(wrongPixels(hillBeforeTheTunnel(), Gate::Planes), 0u);
    EXPECT_GT(wrongPixels(hillBeforeTheTunnel(), Gate::Depth), 0u);
}

} // namespace
} // namespace limen::test
