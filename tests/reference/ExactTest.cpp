// The hardest rays, decided by this room in double and by tests/reference/ExactTracer in floats of 512 bits: eyes at planes,
// edges and corners of openings, rays at edges and corners of walls, a ten-thousandth of a millimetre aside and less.
//
// Answers must be equal. Exceptions, each counted only after a proof for that ray:
// - Touching: both meet a surface at one point, where polygons touch.
// - Borders: a ray that the corners' rounding in the records decides. One of the tracers gives the other's answer for an eye
//   or a direction that much aside: a micrometre in a complex, whose polygons are bent by as much, else a nanometre.
// - Gaps: in exact numbers the ray falls through a gap of the data's rounding. Our polygon is within 0.2 mm of the ray, as
//   the rule asks, or an eye that much aside meets it.

#include "reference/ExactTracer.h"

#include "geometry/Tolerances.h"
#include "reference/Scene.h"
#include "support/LoadTestWorld.h"
#include "world/Places.h"
#include "world/PolygonDistance.h"
#include "worlds/Generated.h"

#include <gtest/gtest.h>

#include <random>

namespace limen::test {
namespace {

struct Tally {
    std::size_t rays = 0, touching = 0, borders = 0, gaps = 0, wrong = 0, deep = 0;
    std::string first;
};

double magnitude(std::mt19937& random, double least, double most) {
    return least * std::pow(most / least, std::uniform_real_distribution<double>(0, 1)(random));
}

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Vec3 direction(0.0);
    for (int axis = 0; axis < 3; ++axis)
        direction[axis] = normal(random);
    return glm::normalize(direction);
}

/// A corner of a polygon, or a point of its edge.
Vec3 onBorder(std::span<const Vec3> polygon, std::mt19937& random) {
    const std::size_t i = random() % polygon.size();
    const double share = random() % 3 == 0 ? 0.0 : std::uniform_real_distribution<double>(0, 1)(random);
    return glm::mix(polygon[i], polygon[(i + 1) % polygon.size()], share);
}

class HardRays {
public:
    /// `bend`: metres by which the corners of polygons are off their planes.
    HardRays(const world::World& world, unsigned seed, double bend)
        : world_(world), scene_(world), exact_(world), random_(seed), bend_(bend) {}

    /// A ray from near an opening to near a border of a wall or an opening, of the space or of the next one.
    void shoot(Tally& tally) {
        const world::Portal& portal = world_.portals[random_() % world_.portals.size()];
        if (portal.cornerCount < 3 || portal.destination == world::kNone)
            return;
        const auto corners = world::cornersOf(world_, portal);
        // One random number a statement: the order within an expression is the compiler's.
        const double side = random_() % 3 == 0 ? -1.0 : 1.0;
        const double before = side * magnitude(random_, 10.0 * bend_, 1.0);
        const bool isWithin = random_() % 2 == 0;
        const double inwards = isWithin ? 0.5 : magnitude(random_, 1e-9, 1.0);
        const Vec3 inner =
            glm::mix(onBorder(corners, random_), (corners[0] + corners[1] + corners[2]) / 3.0, inwards);
        const Vec3 eye = inner + portal.plane.n * before;
        // Past an edge of the opening an eye would be behind the wall of its own space: such views are not judged.
        const bool isSaidToBeBefore = isWithin && random_() % 4 == 0;
        const world::SpaceIndex root = before > 0.0 || isSaidToBeBefore ? portal.space : portal.destination;
        const world::SpaceIndex aimed = random_() % 2 == 0 ? root : portal.destination;
        const Vec3 border = borderIn(aimed), aside = randomDirection(random_);
        const Vec3 target = border + aside * magnitude(random_, 1e-9, 1e-4);
        if (glm::length(target - eye) > 1e-3)
            compare(root, eye, glm::normalize(target - eye), tally);
    }

private:
    Vec3 borderIn(world::SpaceIndex index) {
        const world::Space& space = world_.spaces[index];
        if (space.portalCount > 0 && (random_() % 3 == 0 || space.shell == world::kNone)) {
            const world::Portal& portal = world_.portals[space.firstPortal + random_() % space.portalCount];
            if (portal.cornerCount >= 3)
                return onBorder(world::cornersOf(world_, portal), random_);
        }
        const std::uint32_t number =
            space.shell != world::kNone
                ? space.shell
                : world_.spaceInstances[space.firstInstance + random_() % space.instanceCount];
        const world::Instance& instance = world_.instances[number];
        const world::Mesh& mesh = world_.meshes[instance.mesh];
        const std::size_t first = mesh.firstVertex + 3 * (random_() % (mesh.vertexCount / 3));
        return onBorder(cornersOf(instance, first), random_);
    }

    void compare(world::SpaceIndex root, const Vec3& eye, const Vec3& direction, Tally& tally) {
        const reference::Answer ours = scene_.trace(root, {eye, direction, kDefaultNearPlane});
        const ExactTracer::Answer exact = exact_.trace(root, eye, direction, kDefaultNearPlane);
        ++tally.rays;
        tally.deep += ours.spacesVisited > 1 ? 1 : 0;
        if (ours.id == exact.id)
            return;
        if (ours.id > 1 && exact.id > 1 && std::abs(ours.t - exact.t) <= 1e-9 * (1.0 + ours.t))
            ++tally.touching;
        else if (isOnBorder(root, eye, direction, ours.id, exact.id))
            ++tally.borders;
        else if (exact.id == 0 && ours.id > 1 &&
                 (isClose(ours.id, eye + direction * ours.t) || isMetAside(root, eye, direction, ours.id)))
            ++tally.gaps;
        else if (tally.wrong++ == 0)
            tally.first = describe(root, eye, direction) + ": ours " + std::to_string(ours.id) + " at " +
                          std::to_string(ours.t) + ", exact " + std::to_string(exact.id) + " at " +
                          std::to_string(exact.t);
    }

    /// True if the test holds for one of the neighbours of a grid point.
    template <class Test>
    static bool anyAround(Test test) {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (test(Vec3(x, y, z)))
                        return true;
        return false;
    }

    [[nodiscard]] bool isOnBorder(world::SpaceIndex root, const Vec3& eye, const Vec3& direction,
                                  std::uint32_t ours, std::uint32_t exact) const {
        return anyAround([&](const Vec3& off) {
            const Vec3 moved = eye + off * bend_, turned = direction + off * bend_;
            return exact_.trace(root, moved, direction, kDefaultNearPlane).id == ours ||
                   exact_.trace(root, eye, turned, kDefaultNearPlane).id == ours ||
                   scene_.trace(root, {moved, direction, kDefaultNearPlane}).id == exact ||
                   scene_.trace(root, {eye, turned, kDefaultNearPlane}).id == exact;
        });
    }

    /// True if an eye up to 0.3 mm aside meets the polygon `id` in exact numbers: the gap is beside an opening on the way.
    [[nodiscard]] bool isMetAside(world::SpaceIndex root, const Vec3& eye, const Vec3& direction,
                                  std::uint32_t id) const {
        for (const double aside : {1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 2e-4, 3e-4}) // metres
            if (anyAround([&](const Vec3& off) {
                    return exact_.trace(root, eye + off * aside, direction, kDefaultNearPlane).id == id;
                }))
                return true;
        return false;
    }

    /// True if the polygon `id` is within the tolerance for gaps of a point.
    [[nodiscard]] bool isClose(std::uint32_t id, const Vec3& point) const {
        for (const world::Instance& instance : world_.instances) {
            const world::Mesh& mesh = world_.meshes[instance.mesh];
            if (id < instance.idBase || id - instance.idBase >= mesh.polygonCount)
                continue;
            for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; v += 3) {
                const std::array<Vec3, 3> triangle = cornersOf(instance, v);
                if (world_.vertices[v].polygon == id - instance.idBase &&
                    world::distanceToPolygon(triangle, planeOf(triangle), point) <= kGapTolerance)
                    return true;
            }
        }
        return false;
    }

    [[nodiscard]] std::array<Vec3, 3> cornersOf(const world::Instance& instance, std::size_t vertex) const {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = world_.blocks[instance.block].origin() + Vec3(instance.origin) +
                         Mat3(instance.linear) * world_.vertices[vertex + k].corner();
        return corners;
    }

    static std::string describe(world::SpaceIndex root, const Vec3& eye, const Vec3& direction) {
        char buffer[256];
        std::snprintf(buffer, sizeof buffer,
                      "root %u, eye (%.17g, %.17g, %.17g), direction (%.17g, %.17g, %.17g)", root, eye.x,
                      eye.y, eye.z, direction.x, direction.y, direction.z);
        return buffer;
    }

    const world::World& world_;
    reference::Scene scene_;
    ExactTracer exact_;
    std::mt19937 random_;
    double bend_;
};

/// A generated world without objects: their pictures may have holes, which the exact tracer does not know.
world::World bareWorld(worlds::GeneratedKind kind, std::uint32_t size, std::uint32_t seed) {
    const TempDir directory;
    EXPECT_TRUE(worlds::writeGeneratedWorld({kind, size, seed}, directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    const auto file = world::loadWorldFile(directory.path());
    EXPECT_TRUE(archive && file && !file->places.empty());
    auto loaded = world::loadWorld(*archive, world::blockAt(file->places.back().eye),
                                   {.radius = 0, .mergeZones = false});
    EXPECT_TRUE(loaded);
    world::World world = std::move(*loaded);
    std::vector<world::InstanceIndex> kept;
    for (world::Space& space : world.spaces) {
        const auto first = static_cast<std::uint32_t>(kept.size());
        for (std::uint32_t k = space.firstInstance; k < space.firstInstance + space.instanceCount; ++k) {
            const world::InstanceKind is = world.instances[world.spaceInstances[k]].kind;
            if (is == world::InstanceKind::Shell || is == world::InstanceKind::Exterior ||
                is == world::InstanceKind::Terrain)
                kept.push_back(world.spaceInstances[k]);
        }
        space.firstInstance = first;
        space.instanceCount = static_cast<std::uint32_t>(kept.size()) - first;
    }
    world.spaceInstances = std::move(kept);
    return world;
}

struct Subject {
    const char* name;
    worlds::GeneratedKind kind;
    std::uint32_t size, seed;
    double bend = 1e-9; ///< metres
};

class SecondOpinion : public ::testing::TestWithParam<Subject> {};
INSTANTIATE_TEST_SUITE_P(Worlds, SecondOpinion,
                         ::testing::Values(Subject{"complex", worlds::GeneratedKind::Complex, 20, 3, 1e-6},
                                           Subject{"nested", worlds::GeneratedKind::Nested, 16, 2},
                                           Subject{"thin", worlds::GeneratedKind::Thin, 9, 1},
                                           Subject{"town", worlds::GeneratedKind::Town, 2, 2}),
                         [](const auto& subject) { return subject.param.name; });

TEST_P(SecondOpinion, inExactNumbersTheHardestRaysEndAlike) {
    const world::World world = bareWorld(GetParam().kind, GetParam().size, GetParam().seed);
    const char* const seed = std::getenv("LIMEN_TEST_SEED");
    HardRays rays(world, seed != nullptr ? static_cast<unsigned>(std::stoul(seed)) : GetParam().seed,
                  GetParam().bend);
    Tally tally;
    while (tally.rays < 25000)
        rays.shoot(tally);
    std::cout << GetParam().name << ": " << tally.touching << " touching, " << tally.borders
              << " at borders, " << tally.gaps << " gaps\n";
    EXPECT_EQ(tally.wrong, 0u) << tally.first;
    EXPECT_GT(tally.deep, tally.rays / 5) << "too few rays change space for the test to mean anything";
    EXPECT_LE(tally.touching, tally.rays / 50);
    EXPECT_LE(tally.borders, tally.rays / 100);
    EXPECT_LE(tally.gaps, tally.rays / 50);
}

} // namespace
} // namespace limen::test
