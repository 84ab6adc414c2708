// Pictures are traced tile by tile, and the rays of a tile share their candidates. Every answer must equal
// that of the single ray, to the bit: eyes in rooms, in doorways, in openings' planes and outside; shut
// doors, panes, rain; wide angles and telescopes.
#include "reference/Picture.h"

#include "motion/DynamicStateBuilder.h"
#include "reference/DynamicStateMaker.h"
#include "reference/TracedWorld.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <algorithm>
#include <random>

namespace limen::test {
namespace {

using reference::Answer;
using reference::Camera;

/// Counts of the cases that the pictures have shown, to prove that a test covers them.
struct Seen {
    std::size_t rays = 0, wrong = 0, deep = 0, layered = 0, moving = 0, sky = 0;
    std::string first;
};

/// Whether an id is of one of these instances.
bool isOf(const world::World& world, std::span<const world::Instance> instances, std::uint32_t id) {
    return std::any_of(instances.begin(), instances.end(), [&](const world::Instance& in) {
        return id >= in.idBase && id - in.idBase < world.meshes[in.mesh].polygonCount;
    });
}

void compare(const reference::Scene& scene, const world::World& world, const world::DynamicState& dynamics,
             const Camera& camera, Seen& seen) {
    reference::Picture picture;
    reference::tracePicture(scene, camera, 1, picture);
    for (int y = -1; y <= static_cast<int>(camera.height); ++y) {
        for (int x = -1; x <= static_cast<int>(camera.width); ++x) {
            const Answer alone = scene.trace(camera.root, reference::rayThrough(camera, x, y));
            const Answer& shared = picture.at(x, y);
            ++seen.rays;
            seen.deep += alone.spacesVisited > 2 ? 1 : 0;
            seen.layered += alone.layers.count > 0 ? 1 : 0;
            seen.moving += isOf(world, dynamics.instances, alone.id) ? 1 : 0;
            seen.sky += alone.id == 1 ? 1 : 0;
            if (same(alone, shared) || seen.wrong++ > 0)
                continue;
            seen.first = "pixel " + std::to_string(x) + " " + std::to_string(y) + " root " +
                         std::to_string(camera.root) + " alone " + std::to_string(alone.id) + " at " +
                         std::to_string(alone.t) + " in tile " + std::to_string(shared.id) + " at " +
                         std::to_string(shared.t);
        }
    }
}

double randomBetween(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Looking along `forward`, turned about it by `roll`.
Camera looking(const Vec3& eye, const Vec3& forward, double roll, double tanHalf, world::SpaceIndex root) {
    Camera camera;
    camera.eye = eye;
    camera.root = root;
    camera.forward = glm::normalize(forward);
    const Vec3 aside = std::abs(camera.forward.z) > 0.9 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    const Vec3 right = glm::normalize(glm::cross(camera.forward, aside));
    const Vec3 up = glm::cross(right, camera.forward);
    camera.right = right * std::cos(roll) + up * std::sin(roll);
    camera.up = up * std::cos(roll) - right * std::sin(roll);
    camera.tanHalfX = tanHalf;
    camera.tanHalfY = tanHalf * 0.5625;
    camera.width = 42; // tiles at the edges are cut
    camera.height = 21;
    return camera;
}

/// Straight along an axis, where many a box is seen edge-on, or anywhere.
Vec3 directionOf(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    if (random() % 4 == 0)
        return axes[random() % 6];
    return {normal(random), normal(random), normal(random)};
}

Camera randomCamera(const world::World& world, std::mt19937& random) {
    const auto root = static_cast<world::SpaceIndex>(random() % 3 == 0 ? 0 : random() % world.spaces.size());
    const world::Space& space = world.spaces[root];
    Vec3 eye, forward = directionOf(random);
    const bool isCell = root != world::kOutside && !space.bounds.empty();
    if (isCell) {
        for (int axis = 0; axis < 3; ++axis)
            eye[axis] = randomBetween(random, space.bounds.min[axis], space.bounds.max[axis]);
    } else {
        const Vec3 corner = world.blocks[random() % world.blocks.size()].origin();
        eye = corner + Vec3(randomBetween(random, 0, 192), randomBetween(random, 0, 192),
                            randomBetween(random, 0, 40));
    }
    if (space.portalCount > 0 && random() % 2 == 0) {
        // Before, in or just behind an opening of the space, looking through it or anywhere.
        const world::Portal& portal = world.portals[space.firstPortal + random() % space.portalCount];
        const auto corners = world::cornersOf(world, portal);
        if (corners.size() >= 3) {
            const Vec3 inner = glm::mix(glm::mix(corners[0], corners[1], randomBetween(random, 0, 1)),
                                        corners[2], randomBetween(random, 0, 1));
            const double steps[] = {0.0, 1e-6, 1e-4, -1e-4, 0.005, 0.3, 4.0};
            eye = inner + portal.plane.n * steps[random() % 7];
            if (random() % 2 == 0)
                forward = -portal.plane.n + directionOf(random) * 0.1;
        }
    }
    const double fields[] = {0.01, 0.4, 1.0, 1.0, 1.0, 3.0};
    Camera camera =
        looking(eye, forward, random() % 2 ? 0.0 : randomBetween(random, 0, 6), fields[random() % 6], root);
    if (random() % 8 == 0)
        camera.right = -camera.right; // in a mirror
    return camera;
}

Vec2 randomPlace(std::mt19937& random) {
    return random() % 2 ? Vec2(0.0)
                        : Vec2(randomBetween(random, -0.5, 0.5), randomBetween(random, -0.5, 0.5));
}

Seen compareAllOver(const world::World& world, int views, unsigned seed, bool withDynamics) {
    reference::Scene scene(world);
    motion::DynamicStateBuilder dynamicsBuilder(world);
    std::mt19937 random(seed);
    Seen seen;
    for (int i = 0; i < views; ++i) {
        Camera camera = randomCamera(world, random);
        world::DynamicState dynamics;
        if (withDynamics) {
            motion::DynamicStateInput input;
            input.seconds = randomBetween(random, 0, 100);
            input.allDoors = random() % 2 ? 0.0 : randomBetween(random, 0, 1);
            input.rain = random() % 2 == 0;
            input.eye = camera.eye;
            dynamicsBuilder.build(input, dynamics);
            scene.setDynamics(dynamics);
        }
        camera.place = randomPlace(random);
        compare(scene, world, dynamics, camera, seen);
    }
    return seen;
}

TEST(Tile, everyAnswerIsThatOfItsRayAllOverTheBuiltInWorld) {
    const TempDir directory;
    const auto written = worlds::writeBuiltInWorld(directory.path());
    ASSERT_TRUE(written) << written.error().message();
    const auto file = world::loadWorldFile(directory.path());
    ASSERT_TRUE(file && !file->places.empty());
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    const auto world =
        world::loadWorld(*archive, world::blockAt(file->places[0].eye), {.radius = 1}, file->moving);
    ASSERT_TRUE(world);
    const Seen seen = compareAllOver(*world, 400, 1, true);
    EXPECT_EQ(seen.wrong, 0u) << seen.first;
    EXPECT_GT(seen.rays, 400'000u);
    EXPECT_GT(seen.deep, seen.rays / 500);
    EXPECT_GT(seen.layered, seen.rays / 500);
    EXPECT_GT(seen.moving, seen.rays / 500);
    EXPECT_GT(seen.sky, seen.rays / 500);
}

TEST(Tile, everyAnswerIsThatOfItsRayInTheTourOfTheBuiltInWorld) {
    const TempDir directory;
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory.path()));
    const auto file = world::loadWorldFile(directory.path());
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(file && archive);
    const world::Place& first = file->places[0];
    const auto world = world::loadWorld(*archive, world::blockAt(first.eye), {}, file->moving);
    ASSERT_TRUE(world);
    const reference::Scene scene(*world);
    Seen seen;
    std::size_t views = 0;
    for (const world::Place& place : file->places) {
        const auto root = place.cell == 0 ? world::kOutside : world::findCell(*world, place.cell);
        if (root == world::kNone)
            continue; // not loaded around the first place
        const double yaw = glm::radians(place.yaw), pitch = glm::radians(place.pitch);
        const Vec3 forward(std::sin(yaw) * std::cos(pitch), std::cos(yaw) * std::cos(pitch), std::sin(pitch));
        Camera camera = looking(place.eye, forward, 0.0, 1.026, root);
        camera.width = 160;
        camera.height = 90;
        compare(scene, *world, {}, camera, seen);
        ++views;
    }
    EXPECT_GT(views, 3u);
    EXPECT_EQ(seen.wrong, 0u) << seen.first;
}

TEST(Tile, aPaneInAShutOpeningCountsThoughABoardLiesATenthOfAMillimetreBeforeIt) {
    TwoRooms rooms;
    rooms.world.solid("glass", 0x80FFFFFFu, dat::Surface::kTranslucent, 0.5f);
    const auto store = rooms.world.addBox({100, 100, 10}, {110, 110, 14});
    const std::uint32_t pane = rooms.world.addModel({panel(0.4, "glass", false)});
    const std::uint32_t board = rooms.world.addModel({panel(0.25, "pink", false)});
    rooms.world.addStatic(store, pane, frameAt({103, 102, 12}));
    rooms.world.addStatic(rooms.west, board, frameAt({3.9999, 2, 11}));
    TracedWorld traced(rooms.world);
    const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                            east = traced.space(rooms.world.id(rooms.east));
    DynamicStateMaker dynamics(traced.world());
    dynamics.add(staticOf(traced.world(), pane), {4, 2, 11}, {west, east}, world::InstanceKind::Filling);
    dynamics.shut(traced.world().spaces[west].firstPortal);
    const world::DynamicState shut = dynamics.build();
    traced.scene().setDynamics(shut);
    Seen seen;
    const Camera camera = looking(traced.origin() + Vec3(1, 2, 11), {1, 0, 0}, 0.0, 0.1, west);
    compare(traced.scene(), traced.world(), shut, camera, seen);
    EXPECT_EQ(seen.wrong, 0u) << seen.first;
    reference::Picture picture;
    reference::tracePicture(traced.scene(), camera, 1, picture);
    EXPECT_EQ(picture.at(21, 10).layers.count, 1u) << "where the board is";
}

TEST(Tile, everyAnswerIsThatOfItsRayInGeneratedComplexes) {
    Seen seen;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        std::mt19937 random(seed);
        TestWorld source;
        source.setFlatTerrain(source.home(), 0);
        std::vector<TestWorld::Cell> cells;
        for (int x = 0; x < 3; ++x)
            for (int y = 0; y < 3; ++y)
                cells.push_back(source.addBox({80 + x * 4.0, 80 + y * 4.0, 0.5},
                                              {84 + x * 4.0, 84 + y * 4.0, 3.5},
                                              random() % 2 ? "brown" : "blue"));
        std::vector<TestWorld::Portal> exits;
        for (std::size_t x = 0; x < 3; ++x) {
            for (std::size_t y = 0; y < 3; ++y) {
                const Vec3 corner(80 + static_cast<double>(x) * 4, 80 + static_cast<double>(y) * 4, 0.5);
                const double aside = randomBetween(random, 0.2, 2.2);
                if (x < 2)
                    source.link(cells[x * 3 + y],
                                regularPolygon(corner + Vec3(4, 2, 1.5), {1, 0, 0}, 1.2,
                                               5 + static_cast<int>(random() % 7)),
                                cells[x * 3 + y + 3]);
                if (y < 2)
                    source.link(cells[x * 3 + y],
                                rectangle(corner + Vec3(aside, 4, 0), corner + Vec3(aside + 1.5, 4, 2.5)),
                                cells[x * 3 + y + 1]);
                if (y == 0)
                    exits.push_back(
                        source.openOutside(cells[x * 3], rectangle(corner + Vec3(aside, 0, 0.5),
                                                                   corner + Vec3(aside + 1.2, 0, 2))));
            }
        }
        source.addBuilding(boxExterior({80, 80, -1}, {92, 92, 4}), exits);
        const std::uint32_t post =
            source.addModel(insideOut(boxWalls({-0.3, -0.3, 0}, {0.3, 0.3, 1.8}, "pink")));
        for (int i = 0; i < 5; ++i)
            source.addObject(
                post, frameAt({randomBetween(random, 79, 93), randomBetween(random, 79, 93), 0.5}, 30.0 * i));
        const world::World world = loadTestWorld(source, {.radius = 0, .mergeZones = seed % 2 == 0});
        const Seen here = compareAllOver(world, 60, seed, false);
        EXPECT_EQ(here.wrong, 0u) << "seed " << seed << ": " << here.first;
        seen.rays += here.rays;
        seen.deep += here.deep;
    }
    EXPECT_GT(seen.deep, seen.rays / 50) << "too few rays change space for the test to mean anything";
}

} // namespace
} // namespace limen::test
