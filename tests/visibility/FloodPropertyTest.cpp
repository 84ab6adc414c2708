#include "geometry/ConvexPolygon.h"
#include "visibility/Region.h"
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

namespace limen::visibility {
namespace {

/// Whether a ray that passes the portal enters a space: it has a destination, and for an inexact pair the ray
/// passes both polygons.
bool isOpenFor(const Graph& graph, const Graph::Portal& portal, const Vec3& eye, const Vec3& direction) {
    if (portal.destination == kNone || portal.exact || portal.reciprocal == kNone)
        return portal.destination != kNone;
    const Graph::Portal& back = graph.portals()[portal.reciprocal];
    const double t = -back.plane.signedDistance(eye) / glm::dot(back.plane.n, direction);
    return containsProjection(graph.polygon(back), back.plane.n, eye + direction * t, 0.0);
}

/// The ray rule for portals only, without optimization: from space to space through the nearest opening
/// ahead; kNone at the end is a hole.
std::vector<std::uint32_t> chainOfRay(const Graph& graph, const View& view, const Vec3& direction) {
    std::vector<std::uint32_t> chain{view.root};
    double t0 = 0.0;
    std::uint32_t cameBy = kNone;
    for (;;) {
        double nearest = 1e300;
        std::uint32_t next = kNone;
        const Graph::Space& space = graph.spaces()[chain.back()];
        for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const Graph::Portal& portal = graph.portals()[p];
            const double speed = glm::dot(portal.plane.n, direction);
            const double t = -portal.plane.signedDistance(view.eye) / speed;
            if (speed >= 0.0 || t <= t0 || t >= nearest ||
                (cameBy != kNone && graph.portals()[cameBy].reciprocal == p))
                continue;
            if (containsProjection(graph.polygon(portal), portal.plane.n, view.eye + direction * t, 0.0)) {
                nearest = t;
                next = p;
            }
        }
        if (next == kNone)
            return chain;
        if (!isOpenFor(graph, graph.portals()[next], view.eye, direction)) {
            chain.push_back(kNone);
            return chain;
        }
        chain.push_back(graph.portals()[next].destination);
        cameBy = next;
        t0 = nearest;
    }
}

/// A lattice of box cells 4 m wide, with openings of 3 to 12 corners in random places of random walls. Some
/// walls have two openings; a few openings are inexact pairs or have no room behind. The lattice has loops,
/// and one space (the "outside") surrounds everything.
Graph randomComplex(std::mt19937& random, int size) {
    TestGraph world;
    const auto cell = [&](int x, int y, int z) {
        return static_cast<std::uint32_t>((z * size + y) * size + x);
    };
    for (int i = 0; i < size * size * size; ++i)
        world.addSpace();
    const std::uint32_t outside = world.addSpace();
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto openWall = [&](std::uint32_t a, std::uint32_t b, const Vec3& centre, int axis) {
        const int openings = unit(random) < 0.2 ? 2 : (unit(random) < 0.6 ? 1 : 0);
        for (int k = 0; k < openings; ++k) {
            const int corners = 3 + static_cast<int>(unit(random) * 10);
            const double radius = 0.3 + 0.6 * unit(random);
            Vec3 middle = centre;
            middle[(axis + 1) % 3] += openings == 2 ? (k == 0 ? -1.0 : 1.0) : unit(random) - 0.5;
            middle[(axis + 2) % 3] += unit(random) - 0.5;
            const double phase = unit(random);
            std::vector<Vec3> polygon;
            for (int i = 0; i < corners; ++i) {
                // Seen from a, on the lower side of the axis, the corners are counter-clockwise.
                const double angle = -2.0 * 3.14159265358979 * (i + phase) / corners;
                Vec3 p = middle;
                p[(axis + 1) % 3] += radius * std::cos(angle);
                p[(axis + 2) % 3] += radius * std::sin(angle);
                polygon.push_back(p);
            }
            const double make = unit(random);
            if (make < 0.15) {
                std::vector<Vec3> back(polygon.rbegin(), polygon.rend());
                for (Vec3& p : back) { // shifted and resized within the wall
                    p[(axis + 1) % 3] =
                        middle[(axis + 1) % 3] + (p[(axis + 1) % 3] - middle[(axis + 1) % 3]) * make * 9.0;
                    p[(axis + 2) % 3] += make - 0.05;
                }
                world.linkInexact(a, b, polygon, back);
            } else if (make < 0.2) {
                world.linkOneWay(a, kNone, polygon);
            } else {
                world.link(a, b, polygon);
            }
        }
    };
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const int at[3] = {x, y, z};
                for (int axis = 0; axis < 3; ++axis) {
                    Vec3 centre = Vec3(x, y, z) * 4.0 + 2.0;
                    centre[axis] += 2.0;
                    int next[3] = {x, y, z};
                    ++next[axis];
                    openWall(cell(x, y, z), next[axis] < size ? cell(next[0], next[1], next[2]) : outside,
                             centre, axis);
                    if (at[axis] == 0) {
                        centre[axis] -= 4.0;
                        openWall(outside, cell(x, y, z), centre, axis);
                    }
                }
            }
        }
    }
    return world.build();
}

View randomView(std::mt19937& random, int size) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const int cell = static_cast<int>(unit(random) * size * size * size);
    const Vec3 corner(cell % size, cell / size % size, cell / size / size);
    const Vec3 eye = (corner + Vec3(unit(random), unit(random), unit(random)) * 0.98 + 0.01) * 4.0;
    return viewFrom(eye, unit(random) * 360.0, unit(random) * 178.0 - 89.0, static_cast<std::uint32_t>(cell));
}

/// Whether the chain owns a direction within a ten-millionth of this one: a direction on an edge may have
/// either owner.
bool ownedNearby(const Graph& graph, const View& view, const Vec3& screen,
                 const std::vector<std::uint32_t>& owner) {
    for (int i = 0; i < 8; ++i) {
        const Vec3 s = screen + Vec3(std::cos(i * 0.785), std::sin(i * 0.785), 0.0) * 1e-7;
        const Vec3 d = view.forward + view.right * (s.x * view.tanHalfX) + view.up * (s.y * view.tanHalfY);
        if (chainOfRay(graph, view, d) == owner)
            return true;
    }
    return false;
}

/// A visit's position in the tree, and its properties.
auto linkOf(const Visit& v) {
    return std::tuple(v.zone, v.space, v.parent, v.portal, v.firstVertex, v.vertexCount, v.depth, v.inPlane,
                      v.hole, v.narrowed, v.split);
}

/// A graph with the portals of every space in another order.
struct Shuffled {
    Graph graph;
    std::vector<std::uint32_t> was; ///< by portal: its number in the original
};
Shuffled shuffle(const Graph& graph, std::mt19937& random) {
    Shuffled result;
    std::vector<SpaceDesc> spaces;
    for (const auto& s : graph.spaces()) {
        spaces.push_back({s.firstPortal, s.portalCount, s.zone});
        const auto first = static_cast<std::ptrdiff_t>(result.was.size());
        for (std::uint32_t p = s.firstPortal; p < s.firstPortal + s.portalCount; ++p)
            result.was.push_back(p);
        std::shuffle(result.was.begin() + first, result.was.end(), random);
    }
    std::vector<std::uint32_t> isNow(result.was.size());
    for (std::uint32_t i = 0; i < isNow.size(); ++i)
        isNow[result.was[i]] = i;
    std::vector<PortalDesc> portals;
    std::vector<Vec3> vertices;
    for (const std::uint32_t old : result.was) {
        const Graph::Portal& p = graph.portals()[old];
        portals.push_back({p.space, p.destination, p.reciprocal == kNone ? kNone : isNow[p.reciprocal],
                           static_cast<std::uint32_t>(vertices.size()), p.vertexCount, p.exact});
        const auto polygon = graph.polygon(p);
        vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
    auto built = Graph::build(spaces, portals, vertices);
    RC_ASSERT(built.has_value());
    result.graph = std::move(*built);
    return result;
}

/// Every visit as its chain of portals, root first, with its region; sorted. `was` renames portals, unless
/// empty.
using ChainAndRegion = std::pair<std::vector<std::uint32_t>, std::vector<double>>;
std::vector<ChainAndRegion> visitsByChain(const VisibleSet& set, const std::vector<std::uint32_t>& was) {
    std::vector<ChainAndRegion> all;
    for (const Visit& visit : set.visits) {
        ChainAndRegion& entry = all.emplace_back();
        for (const Visit* up = &visit; up->parent != kNone; up = &set.visits[up->parent])
            entry.first.insert(entry.first.begin(), was.empty() ? up->portal : was[up->portal]);
        for (const Vec3& v : set.region(visit))
            entry.second.insert(entry.second.end(), {v.x, v.y, v.z});
    }
    std::sort(all.begin(), all.end());
    return all;
}

RC_GTEST_PROP(FloodProperty, theOwnerOfAPixelIsTheChainOfItsRay, (unsigned seed)) {
    std::mt19937 random(seed);
    const int size = 1 + static_cast<int>(random() % 3);
    const Graph graph = randomComplex(random, size);
    for (int v = 0; v < 4; ++v) {
        const View view = randomView(random, size);
        const VisibleSet set = floodOnce(graph, view);
        for (int y = 0; y < 12; ++y) {
            for (int x = 0; x < 12; ++x) {
                const Vec3 screen((x + 0.5) / 6.0 - 1.0, (y + 0.5) / 6.0 - 1.0, 1.0);
                const Vec3 d = view.forward + view.right * (screen.x * view.tanHalfX) +
                               view.up * (screen.y * view.tanHalfY);
                const auto owner = chainOf(set, ownerOf(set, screen));
                RC_ASSERT(owner == chainOfRay(graph, view, d) || ownedNearby(graph, view, screen, owner));
            }
        }
    }
}

RC_GTEST_PROP(FloodProperty, aChildLiesInItsParentAndNoPortalRepeatsInAChain, (unsigned seed)) {
    std::mt19937 random(seed);
    const Graph graph = randomComplex(random, 3);
    const VisibleSet set = floodOnce(graph, randomView(random, 3));
    for (std::uint32_t i = 1; i < set.visits.size(); ++i) {
        const Visit& visit = set.visits[i];
        RC_ASSERT(visit.parent < i);
        const auto outer = set.region(set.visits[visit.parent]);
        for (const Vec3& v : set.region(visit)) {
            RC_ASSERT(isFinite(v));
            for (std::size_t e = 0; e < outer.size(); ++e)
                RC_ASSERT(glm::dot(glm::cross(outer[e], outer[(e + 1) % outer.size()]), v) >= -1e-9);
        }
        for (std::uint32_t up = visit.parent; up != kNone; up = set.visits[up].parent)
            RC_ASSERT(set.visits[up].portal != visit.portal);
    }
}

RC_GTEST_PROP(FloodProperty, aTraceChangesNothingAndHasEveryPortalOfTheSeenSpaces, (unsigned seed)) {
    std::mt19937 random(seed);
    const Graph graph = randomComplex(random, 3);
    const View view = randomView(random, 3);
    FloodScratch scratch;
    VisibleSet watched;
    FloodTrace trace;
    RC_ASSERT(flood(graph, {}, view, {}, scratch, watched, &trace).has_value());
    const VisibleSet alone = floodOnce(graph, view);
    RC_ASSERT(watched.regionVertices == alone.regionVertices);
    RC_ASSERT(watched.visits.size() == alone.visits.size());
    RC_ASSERT(watched.counts.portalsTested == alone.counts.portalsTested);
    std::size_t openings = 0, admitted = 0;
    for (const Visit& visit : watched.visits)
        openings += visit.parent != kNone && !visit.hole ? 1u : 0u;
    std::vector<std::uint8_t> traced(watched.visits.size() * graph.portals().size(), 0);
    for (const FloodTrace::Entry& entry : trace.entries) {
        admitted += entry.fate == PortalFate::Admitted ? 1u : 0u;
        traced[entry.visit * graph.portals().size() + entry.portal] = 1;
    }
    RC_ASSERT(admitted == openings);
    for (const SeenSpace& seen : watched.seen) {
        const Graph::Space& space = graph.spaces()[seen.space];
        for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p)
            RC_ASSERT(traced[seen.visit * graph.portals().size() + p] == 1);
    }
}

RC_GTEST_PROP(FloodProperty, theSameInputGivesTheSameBits, (unsigned seed)) {
    std::mt19937 random(seed);
    const Graph graph = randomComplex(random, 3);
    FloodScratch scratch;
    VisibleSet warm;
    const View view = randomView(random, 3);
    RC_ASSERT(flood(graph, {}, randomView(random, 3), {}, scratch, warm).has_value());
    RC_ASSERT(flood(graph, {}, view, {}, scratch, warm).has_value());
    const VisibleSet fresh = floodOnce(graph, view);
    RC_ASSERT(warm.regionVertices == fresh.regionVertices);
    RC_ASSERT(warm.visits.size() == fresh.visits.size());
    RC_ASSERT(warm.seen.size() == fresh.seen.size());
    for (std::size_t i = 0; i < fresh.visits.size(); ++i) {
        RC_ASSERT(linkOf(warm.visits[i]) == linkOf(fresh.visits[i]));
        RC_ASSERT(warm.visits[i].entryPlane.n == fresh.visits[i].entryPlane.n);
        RC_ASSERT(warm.visits[i].entryPlane.d == fresh.visits[i].entryPlane.d);
    }
    for (std::size_t i = 0; i < fresh.seen.size(); ++i) {
        const SeenSpace &a = warm.seen[i], &b = fresh.seen[i];
        RC_ASSERT(a.space == b.space && a.visit == b.visit);
        RC_ASSERT(a.rect.minX == b.rect.minX && a.rect.maxX == b.rect.maxX);
        RC_ASSERT(a.rect.minY == b.rect.minY && a.rect.maxY == b.rect.maxY);
    }
    RC_ASSERT(fresh.counts.visitsCut == 0u && fresh.counts.cyclesLeft == 0u);
}

RC_GTEST_PROP(FloodProperty, theOrderInWhichPortalsAreListedChangesNothingButTheOrder, (unsigned seed)) {
    std::mt19937 random(seed);
    const int size = 1 + static_cast<int>(random() % 3);
    const Graph graph = randomComplex(random, size);
    const Shuffled shuffled = shuffle(graph, random);
    for (int v = 0; v < 4; ++v) {
        const View view = randomView(random, size);
        const VisibleSet set = floodOnce(graph, view), other = floodOnce(shuffled.graph, view);
        // A cycle of overlaps may be cut at any of its members; the painted picture is the same.
        if (set.counts.cyclesSplit == 0) {
            RC_ASSERT(other.counts.cyclesSplit == 0u);
            RC_ASSERT(visitsByChain(set, {}) == visitsByChain(other, shuffled.was));
            RC_ASSERT(set.seen.size() == other.seen.size());
        }
        for (int i = 0; i < 144; ++i) {
            const Vec3 screen((i % 12 + 0.5) / 6.0 - 1.0, (i / 12 + 0.5) / 6.0 - 1.0, 1.0);
            RC_ASSERT(chainOf(set, ownerOf(set, screen)) == chainOf(other, ownerOf(other, screen)));
        }
    }
}

RC_GTEST_PROP(FloodProperty, mergingZonesLosesNoSpaceThatARayReaches, (unsigned seed)) {
    std::mt19937 random(seed);
    const Graph apart = randomComplex(random, 3);
    // The same world with all cells in one zone, and the outside in a zone of its own.
    std::vector<SpaceDesc> spaces;
    std::vector<PortalDesc> portals;
    std::vector<Vec3> vertices;
    for (const auto& s : apart.spaces())
        spaces.push_back({s.firstPortal, s.portalCount, s.zone == apart.spaces().size() - 1 ? 1u : 0u});
    for (const auto& p : apart.portals()) {
        portals.push_back({p.space, p.destination, p.reciprocal, static_cast<std::uint32_t>(vertices.size()),
                           p.vertexCount, p.exact});
        const auto polygon = apart.polygon(p);
        vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
    const auto merged = Graph::build(spaces, portals, vertices);
    RC_ASSERT(merged.has_value());
    const View view = randomView(random, 3);
    const VisibleSet exact = floodOnce(apart, view);
    const VisibleSet zones = floodOnce(*merged, view);
    for (const SeenSpace& s : exact.seen) {
        RC_ASSERT(std::any_of(zones.seen.begin(), zones.seen.end(),
                              [&](const SeenSpace& z) { return z.space == s.space; }));
    }
}

} // namespace
} // namespace limen::visibility
