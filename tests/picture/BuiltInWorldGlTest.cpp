// The built-in world, drawn and compared with the ray rule: its places, its tour, and random eyes.
#include "picture/PictureWorld.h"

#include "motion/Locate.h"
#include "world/Loader.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>

#include <unistd.h>

namespace limen::test {
namespace {

constexpr std::uint32_t kWidth = 56, kHeight = 32; // pixels

unsigned fromEnvironment(const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

/// The built-in world, written and loaded once for all tests of this file.
struct BuiltInWorld : ::testing::TestWithParam<bool> {
    static void SetUpTestSuite() {
        directory() =
            std::filesystem::temp_directory_path() / ("limen-built-in-" + std::to_string(::getpid()));
        const auto written = worlds::writeBuiltInWorld(directory());
        ASSERT_TRUE(written) << written.error().message();
        const auto file = world::loadWorldFile(directory());
        ASSERT_TRUE(file) << file.error().message();
        places() = *file;
        ASSERT_FALSE(places().places.empty());
    }
    static void TearDownTestSuite() {
        worlds()[0].reset();
        worlds()[1].reset();
        std::filesystem::remove_all(directory());
    }
    /// Loaded on first use, because each test has a process of its own.
    [[nodiscard]] static PictureWorld& pictures() {
        std::unique_ptr<PictureWorld>& world = worlds()[GetParam()];
        if (!world) {
            world = std::make_unique<PictureWorld>(directory(), world::blockAt(places().places[0].eye),
                                                   PictureOptions{GetParam(), 2, places().moving, {}});
            world->width = kWidth;
            world->height = kHeight;
            world->setDynamics(dynamics());
        }
        return *world;
    }
    [[nodiscard]] static motion::DynamicStateInput dynamics() {
        motion::DynamicStateInput dynamics;
        dynamics.seconds = 30.0;
        dynamics.eye = places().places[0].eye;
        return dynamics;
    }
    [[nodiscard]] frame::FrameView look(const Vec3& eye, double yaw, double pitch,
                                        world::SpaceIndex root) const {
        return pictures().look(eye - pictures().homeOrigin(), yaw, pitch, root);
    }

    static std::filesystem::path& directory() {
        static std::filesystem::path path;
        return path;
    }
    static world::WorldFile& places() {
        static world::WorldFile file;
        return file;
    }
    static std::unique_ptr<PictureWorld> (&worlds())[2] {
        static std::unique_ptr<PictureWorld> both[2];
        return both;
    }
};
// Suites of their own, so that `./test` can leave one to `--all`.
INSTANTIATE_TEST_SUITE_P(Merged, BuiltInWorld, ::testing::Values(true));
INSTANTIATE_TEST_SUITE_P(Apart, BuiltInWorld, ::testing::Values(false));

TEST_P(BuiltInWorld, everyPlaceIsClean) {
    for (const world::Place& place : places().places) {
        SCOPED_TRACE(place.name);
        // of a distant landblock: SealedDungeon
        if (place.cell != 0 && world::findCell(pictures().world(), place.cell) == world::kNone)
            continue;
        const auto located = motion::locate(pictures().world(), place.eye);
        EXPECT_FALSE(located.ambiguous);
        EXPECT_EQ(pictures().world().spaces[located.space].cellId, place.cell);
        for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
            SCOPED_TRACE(turn);
            pictures().expectClean(look(place.eye, place.yaw + turn, place.pitch, located.space));
        }
    }
}

TEST_P(BuiltInWorld, theTourIsCleanAllAlong) {
    const auto& tour = places().tour;
    ASSERT_GE(tour.size(), 2u);
    world::SpaceIndex space = motion::locate(pictures().world(), tour[0].eye).space;
    std::size_t indoors = 0;
    for (std::size_t i = 0; i < tour.size(); ++i) {
        space = motion::sweep(pictures().world(), space, tour[i == 0 ? 0 : i - 1].eye, tour[i].eye);
        indoors += space == world::kOutside ? 0 : 1;
        if (i % (GetParam() ? 5 : 23) == 0) { // `limen check` tests the rest
            SCOPED_TRACE(::testing::Message() << "way point " << i);
            pictures().expectClean(look(tour[i].eye, tour[i].yaw, tour[i].pitch, space));
        }
    }
    EXPECT_GT(indoors, 10u) << "the tour goes inside";
}

TEST_P(BuiltInWorld, case02_eyesOnBothSidesOfEveryPortalAreClean) {
    const world::World& world = pictures().world();
    for (world::PortalIndex p = 0; p < world.portals.size(); ++p) {
        const world::Portal& portal = world.portals[p];
        if (portal.reciprocal != world::kNone && portal.reciprocal < p)
            continue; // each opening once
        if (p % 4 != (GetParam() ? 0u : 1u))
            continue; // a sample: `limen check` sweeps all
        Vec3 middle(0.0);
        for (std::uint32_t v = 0; v < portal.vertexCount; ++v)
            middle += world.portalVertices[portal.firstVertex + v] / static_cast<double>(portal.vertexCount);
        const double yaw = std::atan2(-portal.plane.n.x, -portal.plane.n.y) * 57.29577951308232;
        const Vec3 start = middle + portal.plane.n * 0.0105;
        world::SpaceIndex space = portal.space;
        Vec3 last = start;
        std::size_t most = 0;
        for (int step = 0; step <= 21; ++step) {
            const Vec3 eye = start - portal.plane.n * (step * 0.001);
            space = motion::sweep(world, space, last, eye);
            last = eye;
            if (step % 3 == 1 && step != 10)
                continue;
            SCOPED_TRACE(::testing::Message() << "portal " << p << " step " << step);
            const Picture picture =
                pictures().expectClean(look(eye, yaw + 35.0 + step * 11.0, step % 3 * 20.0 - 20.0, space));
            most = std::max(most, picture.visible.visits.size());
        }
        EXPECT_EQ(space, portal.destination) << "portal " << p;
        EXPECT_LT(most, 80u) << "visits stay bounded"; // without zones, a dungeon's hub is dozens of spaces
    }
}

/// Whether the eye is in the cell and off its walls.
bool clearOfWalls(const world::World& world, world::SpaceIndex cell, const Vec3& eye) {
    constexpr double kClear = 0.05;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 offset(0.0);
        offset[axis] = kClear;
        if (!motion::cellContains(world, cell, eye + offset) ||
            !motion::cellContains(world, cell, eye - offset))
            return false;
    }
    return true;
}

/// Random eyes: three in cells, two in the open, and so on.
class RandomEyes {
public:
    struct Eye {
        Vec3 at{0.0};
        world::SpaceIndex root = world::kOutside;
        double yaw = 0.0, pitch = 0.0; // degrees
    };

    RandomEyes(const world::World& world, unsigned seed) : world_(world), random_(seed) {}

    Eye next() {
        Eye eye;
        do {
            eye = number_ % 5 < 3 ? anywhereInACell() : anywhereOutside();
        } while (!isClear(eye));
        ++number_;
        eye.yaw = unit() * 360.0;
        eye.pitch = unit() * 120.0 - 60.0;
        return eye;
    }

private:
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    template <class T>
    const T& anyOf(const std::vector<T>& values, std::size_t from) {
        return values[from + static_cast<std::size_t>(unit() * static_cast<double>(values.size() - from))];
    }
    Eye anywhereInACell() {
        const world::Space& cell = anyOf(world_.spaces, 1);
        const Aabb& box = cell.bounds;
        return {box.min + (box.max - box.min) * Vec3{unit(), unit(), unit()},
                static_cast<world::SpaceIndex>(&cell - world_.spaces.data())};
    }
    Eye anywhereOutside() {
        const Vec3 corner = anyOf(world_.blocks, 0).origin();
        Vec3 at = corner + Vec3{unit(), unit(), 0.0} * world::kBlockSize;
        at.z = world::terrainHeight(world_, at.x, at.y) + 0.3 + unit() * 12.0;
        return {at};
    }
    bool isClear(const Eye& eye) const {
        return eye.root == world::kOutside ? motion::locate(world_, eye.at).space == world::kOutside
                                           : clearOfWalls(world_, eye.root, eye.at);
    }

    const world::World& world_;
    std::mt19937 random_;
    unsigned number_ = 0;
};

TEST_P(BuiltInWorld, randomEyesInCellsAndInFreeAirAreClean) {
    // LIMEN_TEST_VIEWS, LIMEN_TEST_SEED and LIMEN_TEST_WIDTH extend the search.
    const unsigned views = fromEnvironment("LIMEN_TEST_VIEWS", 250);
    pictures().width = fromEnvironment("LIMEN_TEST_WIDTH", kWidth);
    pictures().height = pictures().width * kHeight / kWidth;
    RandomEyes eyes(pictures().world(), fromEnvironment("LIMEN_TEST_SEED", 11) + (GetParam() ? 0 : 1));
    for (unsigned view = 0; view < views; ++view) {
        SCOPED_TRACE(::testing::Message() << "view " << view);
        const RandomEyes::Eye eye = eyes.next();
        pictures().expectClean(look(eye.at, eye.yaw, eye.pitch, eye.root));
    }
    pictures().width = kWidth;
    pictures().height = kHeight;
}

/// Eyes at which `limen check` once found wrong pixels.
struct OnceWrong {
    const char* what;
    Vec3 eye;
    double yaw, pitch;  // degrees
    dat::RecordId cell; // 0: outside
    double seconds;
    std::uint32_t width = 160, height = 90;
    double fov = 75.0;
};
const OnceWrong kOnceWrong[] = {
    {"hidden landings of the tower, along edges over one another",
     {32555.008412630283, 34861.50841263028, 68.510625},
     0.0,
     -90.0,
     0xA9B50104,
     333.27},
    {"the same, a storey below", {32554.25, 34860.75, 63.870625}, 0.0, -90.0, 0xA9B50102, 523.39},
    {"a roof seen edge-on, metres beyond the window by which the ray left",
     {32562.9535, 34643.61678490541, 33.53147169765033},
     179.8956931540755,
     -3.946814869745165,
     0,
     493.7},
    {"the riser under two boards of a stair, where the edge of one is part of the other's",
     {32531.806345451485, 34645.44755288002, 30.59224714374234},
     101.31548890412202,
     6.460317623221105,
     0xA9B40106,
     306.46,
     640,
     360},
    {"a riser a third of a pixel wide, where interpolation overflows",
     {32556.007471758025, 34859.98448639413, 63.651625},
     0.0,
     -90.0,
     0xA9B50102,
     93.38},
    {"the edges of a near step and of a far one, in line",
     {32669.908661098958, 34850.5, 24.005737219569504},
     146.61935708793493,
     61.847715566146846,
     0xAAB5014F,
     191.41,
     640,
     360},
    {"an edge of a passage and of its floor, in line",
     {32717.79242640687, 34860.20757359313, 22.293210128461574},
     296.80134663762743,
     -29.81738170297967,
     0xAAB50107,
     343.96},
    {"the edges of a vault's reveal, near and far, in line",
     {32702.491262320338, 34834.90974273029, 23.77559524178208},
     45.0,
     0.0,
     0xAAB5010F,
     502.09},
    {"a wall 0.2 mm behind the eye, hit only by the backward half of the ray's line",
     {32551.75021, 34860.25, 70.890625},
     232.20417010960466,
     -26.511374549708997,
     0xA9B50104,
     574.81},
    {"the tops of a door's planks at eye level: one was placed behind the side of the next",
     {32535.509243479726, 34668.79584760852, 32.397399054858624},
     237.046875,
     -0.19374999999999967,
     0xA9B40100,
     12.96000000000001,
     320,
     180,
     60.0},
    {"the edge between a triangle computed in double and one in floats, 20 cm away",
     {32555.233285655613, 34674.621810177821, 32.181079635096808},
     96.856365230246638,
     -34.069199837287002,
     0xA9B4010B,
     30.0,
     56,
     32},
};

TEST_P(BuiltInWorld, viewsThatWereWrongAreClean) {
    for (const OnceWrong& view : kOnceWrong) {
        SCOPED_TRACE(view.what);
        PictureWorld pictures(directory(), world::blockAt(view.eye), {GetParam(), 2, places().moving, {}});
        pictures.width = view.width;
        pictures.height = view.height;
        pictures.fov = view.fov;
        motion::DynamicStateInput dynamics;
        dynamics.seconds = view.seconds;
        dynamics.eye = view.eye;
        pictures.setDynamics(dynamics);
        const world::SpaceIndex root =
            view.cell == 0 ? world::kOutside : world::findCell(pictures.world(), view.cell);
        pictures.expectClean(pictures.look(view.eye - pictures.homeOrigin(), view.yaw, view.pitch, root));
    }
}

TEST_P(BuiltInWorld, cullingTrianglesChangesNoPicture) {
    PictureOptions options{GetParam(), 2, places().moving, {}};
    options.culling = gpu::Culling::None;
    PictureWorld whole(directory(), world::blockAt(places().places[0].eye), options);
    whole.width = kWidth;
    whole.height = kHeight;
    whole.setDynamics(dynamics());
    RandomEyes eyes(pictures().world(), fromEnvironment("LIMEN_TEST_SEED", 11) + 2);
    for (unsigned view = 0; view < fromEnvironment("LIMEN_TEST_VIEWS", 60); ++view) {
        SCOPED_TRACE(::testing::Message() << "view " << view);
        const RandomEyes::Eye eye = eyes.next();
        for (const bool layers : {false, true}) {
            const Picture less =
                pictures().shoot(look(eye.at, eye.yaw, eye.pitch, eye.root), {.wantLayers = layers});
            const Picture all =
                whole.shoot(look(eye.at, eye.yaw, eye.pitch, eye.root), {.wantLayers = layers});
            ASSERT_EQ(less.ids, all.ids);
            ASSERT_EQ(less.depth, all.depth);
            ASSERT_EQ(less.colour, all.colour);
            ASSERT_EQ(less.layers, all.layers);
        }
    }
}

TEST_P(BuiltInWorld, everyViewTakesFewCallsAndTheSameForTheSameStages) {
    std::map<std::vector<std::uint32_t>, std::uint32_t> calls;
    for (const world::Place& place : places().places) {
        for (double yaw = 0; yaw < 360; yaw += 60) {
            const Picture picture = pictures().shoot(
                look(place.eye, yaw, 0, motion::locate(pictures().world(), place.eye).space));
            EXPECT_LE(picture.glCalls, 40u);
            const auto known = calls.try_emplace(picture.stages, picture.glCalls);
            EXPECT_EQ(known.first->second, picture.glCalls) << place.name;
        }
    }
}

/// Far from all others, with a world and a renderer of its own.
TEST(SealedDungeon, case22_isCleanAndNothingElseIsVisited) {
    const auto directory =
        std::filesystem::temp_directory_path() / ("limen-sealed-" + std::to_string(::getpid()));
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory));
    const auto file = world::loadWorldFile(directory);
    ASSERT_TRUE(file);
    const auto place = std::find_if(file->places.begin(), file->places.end(),
                                    [](const world::Place& p) { return p.name == "dungeon.sealed"; });
    ASSERT_NE(place, file->places.end());
    for (const bool merge : {true, false}) {
        PictureWorld pictures(directory, world::blockAt(place->eye), PictureOptions{merge, 2});
        pictures.width = kWidth;
        pictures.height = kHeight;
        const world::SpaceIndex root = pictures.space(place->cell);
        ASSERT_NE(root, world::kNone);
        for (double turn = 0.0; turn < 360.0; turn += 30.0) {
            SCOPED_TRACE(turn);
            const Picture picture = pictures.expectClean(
                pictures.look(place->eye - pictures.homeOrigin(), place->yaw + turn, place->pitch, root));
            for (const visibility::Visit& visit : picture.visible.visits)
                EXPECT_NE(visit.space, world::kOutside);
        }
    }
    std::filesystem::remove_all(directory);
}

/// A door leaf hundreds of metres away, so nearly edge-on that floats cannot resolve its depth. It is behind
/// another leaf and must not show before it. Both were found along the tour, with as much of the world loaded
/// as `limen check` loads.
TEST(FarAway, aLeafSeenEdgeOnStaysBehindTheOneBeforeIt) {
    const auto directory =
        std::filesystem::temp_directory_path() / ("limen-far-" + std::to_string(::getpid()));
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory));
    const auto file = world::loadWorldFile(directory);
    ASSERT_TRUE(file);
    struct View {
        Vec3 eye;
        double yaw, pitch, seconds;
    };
    const View views[] = {{{32347.927798257806, 34736.144227382574, 58.309106210809865},
                           132.56173138901855,
                           -17.18493845243652,
                           489.21},
                          {{32341.03880938931, 34749.92238122138, 65.73648189768339},
                           122.6669264846346,
                           -12.961732204056677,
                           50.06}};
    PictureWorld pictures(directory, world::blockAt(views[0].eye), PictureOptions{true, 4, file->moving});
    pictures.width = 160;
    pictures.height = 90;
    pictures.fov = 75.0;
    for (const View& view : views) {
        motion::DynamicStateInput input;
        input.seconds = view.seconds;
        input.eye = view.eye;
        pictures.setDynamics(input);
        pictures.expectClean(
            pictures.look(view.eye - pictures.homeOrigin(), view.yaw, view.pitch, world::kOutside));
    }
    std::filesystem::remove_all(directory);
}

/// A cell's wall seen nearly edge-on, and directly behind it the corner of another cell of its zone, which
/// must not show. Found in a sweep through the tower's openings.
TEST(FlatWall, hidesTheCellBehindIt) {
    const auto directory =
        std::filesystem::temp_directory_path() / ("limen-flat-" + std::to_string(::getpid()));
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory));
    const auto file = world::loadWorldFile(directory);
    ASSERT_TRUE(file);
    const Vec3 eye(32677.017, 34849.88199995707, 11.321882788676314);
    PictureWorld pictures(directory, world::blockAt(eye), PictureOptions{true, 0, file->moving});
    pictures.width = 160;
    pictures.height = 90;
    pictures.fov = 75.0;
    pictures.expectClean(pictures.look(eye - pictures.homeOrigin(), 2.7911669359890325, 36.260889388795974,
                                       pictures.space(0xAAB5015F)));
    std::filesystem::remove_all(directory);
}

} // namespace
} // namespace limen::test
