// The rule implemented twice: this room's answers compared with tests/picture/NaiveTracer, which tests every
// triangle of every space on the ray.
//
// Ids and depths must be equal. The exceptions, each counted only after a proof for that ray:
// - Rounding: a ray within 1e-7 of a polygon's edge. The naive tracer must find our answer for a ray that near.
// - Touching: a ray aimed exactly at the rim of an opening, where polygons of both spaces touch. Both tracers must end
//   in the same point; the id may be that of any polygon there.
// - Gaps: the naive tracer falls through gaps that are narrower than the data's own rounding and finds a hole. It must
//   find our answer for a ray 0.3 mm aside.

#include "picture/NaiveTracer.h"
#include "reference/TracedWorld.h"

#include "motion/Locate.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <random>

namespace limen::test {
namespace {

struct Tally {
    std::size_t rays = 0, rounded = 0, touching = 0, gaps = 0, wrong = 0, deep = 0;
    std::size_t atRims = 0; ///< rays aimed at rims; their rounding does not count
    std::string first;
};

class Comparer {
public:
    explicit Comparer(const world::World& world) : scene_(world), naive_(world) {}

    void compare(world::SpaceIndex root, const Vec3& eye, const Vec3& direction, bool atRim,
                 Tally& tally) const {
        const auto ours = scene_.trace(root, {eye, direction, 0.02});
        const auto theirs = naive_.trace(root, {eye, direction, 0.02});
        ++tally.rays;
        tally.atRims += atRim ? 1 : 0;
        tally.deep += ours.spacesVisited > 1 ? 1 : 0;
        const bool sameDepth = ours.id <= 1 || std::abs(ours.t - theirs.t) <= 1e-7 * (1.0 + ours.t);
        if (ours.id == theirs.id && sameDepth && ours.reachedOutside == theirs.reachedOutside)
            return;
        if (isNear(root, eye, direction, ours.id, 0.0, 1e-7))
            tally.rounded += atRim ? 0 : 1;
        else if (atRim && sameDepth && std::isfinite(ours.t))
            ++tally.touching;
        else if (theirs.id == 0 && isNear(root, eye, direction, ours.id, 0.0003, 0.0))
            ++tally.gaps;
        else if (tally.wrong++ == 0)
            tally.first = "eye " + text(eye) + " direction " + text(direction) + " root " +
                          std::to_string(root) + ": ours " + std::to_string(ours.id) + " at " +
                          std::to_string(ours.t) + ", naive " + std::to_string(theirs.id) + " at " +
                          std::to_string(theirs.t);
    }

private:
    static std::string text(const Vec3& v) {
        char buffer[128];
        std::snprintf(buffer, sizeof buffer, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
        return buffer;
    }
    /// True if the naive tracer finds `id` for a ray that begins up to `aside` metres from this one, or turns
    /// by `turn`.
    bool isNear(world::SpaceIndex root, const Vec3& eye, const Vec3& direction, std::uint32_t id,
                double aside, double turn) const {
        for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                for (int z = -1; z <= 1; ++z) {
                    const Vec3 off(x, y, z);
                    if (naive_.trace(root, {eye + off * aside, direction + off * turn, 0.02}).id == id)
                        return true;
                }
            }
        }
        return false;
    }

    reference::Scene scene_;
    NaiveTracer naive_;
};

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Eyes all over a world: in its cells (which may be roots from just outside their walls, too), before its
/// portals, towards rims of portals, and in the open.
Tally compareAllOver(const world::World& world, int eyes, unsigned seed) {
    const Comparer comparer(world);
    std::mt19937 random(seed);
    Tally tally;
    for (int i = 0; i < eyes; ++i) {
        const auto root = static_cast<world::SpaceIndex>(random() % world.spaces.size());
        const world::Space& space = world.spaces[root];
        Vec3 eye;
        if (root != world::kOutside && !space.bounds.empty()) {
            for (int axis = 0; axis < 3; ++axis)
                eye[axis] = between(random, space.bounds.min[axis], space.bounds.max[axis]);
        } else {
            const Vec3 corner = world.blocks[random() % world.blocks.size()].origin();
            eye = corner + Vec3(between(random, 0, 192), between(random, 0, 192), between(random, -5, 60));
        }
        for (int ray = 0; ray < 12; ++ray)
            comparer.compare(root, eye, randomDirection(random), false, tally);
        if (space.portalCount == 0)
            continue;
        // From an eye of this space through its portals, and at their rims.
        const world::Portal& portal = world.portals[space.firstPortal + random() % space.portalCount];
        const auto outline = world::cornersOf(world, portal);
        if (outline.size() < 3)
            continue;
        const Vec3 rim = glm::mix(outline[0], outline[1], between(random, 0, 1));
        const Vec3 inner = glm::mix(rim, outline[2], between(random, 0, 1));
        const Vec3 near = inner + portal.plane.n * between(random, 0.001, 4.0) +
                          randomDirection(random) * between(random, 0, 0.3);
        for (const Vec3& target : {rim, outline[0]})
            comparer.compare(root, near, target - near, true, tally);
        comparer.compare(root, near, inner - near, false, tally);
        comparer.compare(root, near, randomDirection(random), false, tally);
    }
    return tally;
}

void expectAgreement(const Tally& tally) {
    EXPECT_EQ(tally.wrong, 0u) << tally.first;
    // Seven in a million of an eye's rays come within 1e-7 of a given edge; a world shows some dozens of
    // them.
    EXPECT_LE(tally.rounded, tally.rays / 5000);
    EXPECT_LE(tally.touching, tally.atRims / 50);
    EXPECT_LE(tally.gaps, tally.rays / 5000);
    EXPECT_GT(tally.deep, tally.rays / 50) << "too few rays change space for the test to mean anything";
}

TEST(AgainstNaive, theBuiltInWorld) {
    const TempDir directory;
    const auto written = worlds::writeBuiltInWorld(directory.path());
    ASSERT_TRUE(written) << written.error().message();
    const auto file = world::loadWorldFile(directory.path());
    ASSERT_TRUE(file && !file->places.empty());
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    const auto world = world::loadWorld(*archive, world::blockAt(file->places[0].eye), {.radius = 1});
    ASSERT_TRUE(world);
    const Tally tally = compareAllOver(*world, 2500, 1);
    EXPECT_GT(tally.rays, 30000u);
    expectAgreement(tally);
}

TEST(AgainstNaive, twoHousesThroughDoorsAndWindows) {
    House house;
    const auto second = house.world.addBox({90, 100, 0.1}, {96, 106, 3.1}, "blue");
    const auto door = house.world.openOutside(second, rectangle({92, 100, 0.1}, {94, 100, 2.1}));
    house.world.addBuilding(boxExterior({90, 100, -1}, {96, 106, 3.2}), {door});
    house.world.addObject(house.world.addModel(insideOut(boxWalls({-0.3, -0.3, 0}, {0.3, 0.3, 1.8}, "pink"))),
                          frameAt({93, 86, 0.1})); // half in the door
    expectAgreement(compareAllOver(loadTestWorld(house.world, {.radius = 1}), 1500, 2));
}

TEST(AgainstNaive, overlappingRoomsOnSeveralFloors) {
    TestWorld source;
    const auto hall = source.addBox({0, 0, 10}, {6, 6, 13}, "brown");
    const auto attic = source.addBox({0, 0, 13}, {6, 6, 16}, "blue");
    const auto other = source.addBox({5, 1, 10}, {11, 5, 13}, "red"); // reaches into the hall
    const auto well = source.addBox({1, 1, 4}, {3, 3, 10}, "green");
    source.link(hall, rectangle({2, 2, 13}, {4, 4, 13}), attic);
    source.link(hall, regularPolygon({2, 2, 10}, {0, 0, 1}, 0.9, 9), well);
    TestWorld::LinkOptions inexact;
    inexact.exact = false;
    inexact.polygonInB = rectangle({5, 2, 10}, {5, 4, 12.5});
    source.link(hall, rectangle({6, 2.5, 10}, {6, 4.5, 12}), other, inexact);
    expectAgreement(compareAllOver(loadTestWorld(source, {.radius = 0}), 2000, 3));
}

TEST(AgainstNaive, aGridOfRoomsWithRoundOpenings) {
    TestWorld source;
    std::vector<TestWorld::Cell> cells;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            cells.push_back(source.addBox({x * 4.0, y * 4.0, 10}, {x * 4.0 + 4, y * 4.0 + 4, 13}));
    for (std::size_t x = 0; x < 4; ++x) {
        for (std::size_t y = 0; y < 4; ++y) {
            const Vec3 corner(static_cast<double>(x) * 4, static_cast<double>(y) * 4, 10);
            if (x < 3)
                source.link(cells[x * 4 + y], regularPolygon(corner + Vec3(4, 2, 1.5), {1, 0, 0}, 1.2, 11),
                            cells[x * 4 + y + 4]);
            if (y < 3)
                source.link(cells[x * 4 + y], rectangle(corner + Vec3(1, 4, 0), corner + Vec3(3, 4, 2.5)),
                            cells[x * 4 + y + 1]);
        }
    }
    for (const bool merge : {false, true})
        expectAgreement(compareAllOver(loadTestWorld(source, {.radius = 0, .mergeZones = merge}), 2000, 4));
}

} // namespace
} // namespace limen::test
