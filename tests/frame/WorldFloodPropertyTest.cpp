// Properties of the flood that hold for any world: over generated complexes of convex cells, loaded from
// dats. LIMEN_TEST_WORLDS: number of worlds (200).
#include "worlds/GeneratedWorlds.h"

#include "frame/FrameView.h"
#include "frame/WorldGraph.h"
#include "geometry/ConvexPolygon.h"
#include "reference/Scene.h"
#include "visibility/Flood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace limen::test {
namespace {

using visibility::VisibleSet;

constexpr int kViews = 4; ///< of each world
constexpr int kSide = 16; ///< rays across and down a view

std::uint32_t worldCount() {
    const char* asked = std::getenv("LIMEN_TEST_WORLDS");
    return asked != nullptr ? static_cast<std::uint32_t>(std::max(1, std::atoi(asked))) : 200u;
}

struct Complex {
    worlds::test::GeneratedWorld files;
    world::World world;
    visibility::Graph graph;

    Complex(std::uint32_t seed, bool mergeZones)
        : files({worlds::GeneratedKind::Complex, 4 + seed % 29, seed}),
          world(files.load(files.blocks().front(), mergeZones)), graph(graphOf(world)) {}

    static visibility::Graph graphOf(const world::World& world) {
        auto graph = frame::visibilityGraph(world);
        EXPECT_TRUE(graph.has_value());
        return graph ? std::move(*graph) : visibility::Graph();
    }
};

/// A point inside a convex cell: a random mean of its shell's vertices.
Vec3 pointIn(const world::World& world, world::SpaceIndex space, std::mt19937& random) {
    const world::Instance& shell = world.instances[world.spaces[space].shell];
    const world::Mesh& mesh = world.meshes[shell.mesh];
    std::uniform_real_distribution<double> unit(0.01, 1.0);
    Vec3 sum(0.0);
    double weights = 0.0;
    for (std::uint32_t v = 0; v < mesh.vertexCount; ++v) {
        const double weight = std::pow(unit(random), 6.0); // lets some corners dominate
        sum += world.vertices[mesh.firstVertex + v].corner() * weight;
        weights += weight;
    }
    return sum / weights + world.blocks[shell.block].origin();
}

frame::FrameView randomView(const world::World& world, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto space = static_cast<world::SpaceIndex>(1 + random() % (world.spaces.size() - 1));
    return frame::makeView(pointIn(world, space, random), unit(random) * 360.0, unit(random) * 170.0 - 85.0,
                           40.0 + unit(random) * 80.0, kSide, kSide, space);
}

/// The direction of ray (x, y) of a view on the screen, in (x, y, w), and in the world.
Vec3 screenOf(int x, int y) {
    return {(x + 0.5) * 2.0 / kSide - 1.0, (y + 0.5) * 2.0 / kSide - 1.0, 1.0};
}
Vec3 directionOf(const visibility::View& view, const Vec3& screen) {
    return view.forward + view.right * (screen.x * view.tanHalfX) + view.up * (screen.y * view.tanHalfY);
}

VisibleSet floodOf(const Complex& complex, const visibility::View& view) {
    visibility::FloodScratch scratch;
    VisibleSet set;
    EXPECT_TRUE(visibility::flood(complex.graph, {}, view, {}, scratch, set));
    EXPECT_EQ(set.counts.visitsCut, 0u) << "the cap on visits was reached";
    EXPECT_EQ(set.counts.cyclesLeft, 0u) << "a cycle of overlapping openings was not broken";
    for (const Vec3& v : set.regionVertices)
        EXPECT_TRUE(isFinite(v));
    for (const visibility::Visit& visit : set.visits)
        EXPECT_TRUE(isFinite(visit.entryPlane.n) && std::isfinite(visit.entryPlane.d));
    return set;
}

/// Whether the ray, as a line, meets the portal's polygon.
bool meets(const world::World& world, const world::Portal& portal, const Vec3& eye, const Vec3& direction) {
    const double t = -portal.plane.signedDistance(eye) / glm::dot(portal.plane.n, direction);
    return containsProjection(cornersOf(world, portal), portal.plane.n, eye + direction * t, 0.0);
}

/// Whether a ray that meets the portal's polygon enters a space: an inexact pair is open inside both
/// polygons.
bool isOpenFor(const world::World& world, const world::Portal& portal, const Vec3& eye,
               const Vec3& direction) {
    return portal.destination != world::kNone &&
           (portal.exact || portal.reciprocal == world::kNone ||
            meets(world, world.portals[portal.reciprocal], eye, direction));
}

/// The spaces that a ray passes through, without optimization: by the nearest opening ahead, without regard
/// to walls. A walled portal is no opening. kNone at the end is a hole.
std::vector<world::SpaceIndex> chainOfRay(const world::World& world, const visibility::View& view,
                                          const Vec3& direction) {
    std::vector<world::SpaceIndex> chain{view.root};
    double t0 = 0.0;
    world::PortalIndex cameBy = world::kNone;
    for (;;) {
        double nearest = std::numeric_limits<double>::infinity();
        world::PortalIndex next = world::kNone;
        const world::Space& space = world.spaces[chain.back()];
        for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const world::Portal& portal = world.portals[p];
            const double speed = glm::dot(portal.plane.n, direction);
            const double t = -portal.plane.signedDistance(view.eye) / speed;
            if (!portal.walled && speed < 0.0 && t > t0 && t < nearest &&
                (cameBy == world::kNone || world.portals[cameBy].reciprocal != p) &&
                meets(world, portal, view.eye, direction)) {
                nearest = t;
                next = p;
            }
        }
        if (next == world::kNone)
            return chain;
        if (!isOpenFor(world, world.portals[next], view.eye, direction)) {
            chain.push_back(world::kNone);
            return chain;
        }
        chain.push_back(world.portals[next].destination);
        cameBy = next;
        t0 = nearest;
    }
}

/// The chain of the last visit in drawing order whose region contains the direction: the result of painting.
std::vector<world::SpaceIndex> chainOfOwner(const VisibleSet& set, const Vec3& screen) {
    std::uint32_t owner = 0;
    for (std::uint32_t i = 0; i < set.visits.size(); ++i) {
        const auto region = set.region(set.visits[i]);
        bool inside = true;
        for (std::size_t e = 0; e < region.size() && inside; ++e)
            inside = glm::dot(glm::cross(region[e], region[(e + 1) % region.size()]), screen) >= 0.0;
        owner = inside ? i : owner;
    }
    std::vector<world::SpaceIndex> chain;
    for (; owner != visibility::kNone; owner = set.visits[owner].parent)
        chain.insert(chain.begin(), set.visits[owner].space);
    return chain;
}

/// Whether a ray within 1/1250 of a pixel has the chain. Corners are stored as floats, some hundredths of a
/// millimetre off their opening's plane, so a ray that near to an edge may pass on either side.
bool isChainNearby(const world::World& world, const visibility::View& view, const Vec3& screen,
                   const std::vector<world::SpaceIndex>& chain) {
    for (int i = 0; i < 8; ++i) {
        const Vec3 s = screen + Vec3(std::cos(i * 0.785), std::sin(i * 0.785), 0.0) * 1e-4;
        if (chainOfRay(world, view, directionOf(view, s)) == chain)
            return true;
    }
    return false;
}

TEST(WorldFloodProperty, theVisibleSetHoldsEverySpaceThatARayOfTheReferenceEndsIn) {
    std::size_t farther = 0;
    for (std::uint32_t seed = 1; seed <= worldCount() && !::testing::Test::HasFailure(); ++seed) {
        const Complex complex(seed, seed % 2 == 0);
        const reference::Scene scene(complex.world);
        std::mt19937 random(seed);
        for (int v = 0; v < kViews && !::testing::Test::HasFailure(); ++v) {
            const visibility::View view = randomView(complex.world, random).view;
            const VisibleSet set = floodOf(complex, view);
            std::vector<bool> seen(complex.world.spaces.size(), false);
            for (const visibility::SeenSpace& s : set.seen)
                seen[s.space] = true;
            for (int i = 0; i < kSide * kSide; ++i) {
                const Vec3 direction = directionOf(view, screenOf(i % kSide, i / kSide));
                const reference::Answer answer = scene.trace(view.root, {view.eye, direction, 0.0});
                ASSERT_TRUE(seen[answer.space])
                    << worlds::test::nameOf(complex.files.spec()) << ", view " << v << ", ray " << i
                    << ": space " << answer.space << " is hit and not among the seen";
                farther += answer.spacesVisited > 2 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(farther, worldCount()) << "too few rays passed two openings for a meaningful test";
}

TEST(WorldFloodProperty, theOwnerOfAPixelIsTheLeafOfTheChainThatItsRayFinds) {
    std::size_t farther = 0;
    for (std::uint32_t seed = 1; seed <= worldCount() && !::testing::Test::HasFailure(); ++seed) {
        const Complex complex(seed, false);
        std::mt19937 random(seed);
        for (int v = 0; v < kViews && !::testing::Test::HasFailure(); ++v) {
            const visibility::View view = randomView(complex.world, random).view;
            const VisibleSet set = floodOf(complex, view);
            for (int i = 0; i < kSide * kSide; ++i) {
                const Vec3 screen = screenOf(i % kSide, i / kSide);
                const auto owner = chainOfOwner(set, screen);
                const auto ray = chainOfRay(complex.world, view, directionOf(view, screen));
                ASSERT_TRUE(owner == ray || isChainNearby(complex.world, view, screen, owner))
                    << worlds::test::nameOf(complex.files.spec()) << ", view " << v << ", ray " << i
                    << ": chain of " << ray.size() << " spaces, owner of depth " << owner.size();
                farther += ray.size() > 2 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(farther, worldCount()) << "too few rays passed two openings for a meaningful test";
}

} // namespace
} // namespace limen::test
