// The flood of graphs that no world should have: it ends, and its result is finite and a tree.
#include "visibility/TestGraph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

namespace limen::visibility {
namespace {

/// Draws extreme values more often than a uniform distribution.
class Odd {
public:
    explicit Odd(unsigned seed, bool flat = false) : random_(seed), inARow_(oneIn(2)), flat_(flat) {}

    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
    bool oneIn(std::uint32_t count) { return below(count) == 0; }
    double number(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
    Vec3 point() {
        if (oneIn(3)) { // on a coarse grid: many planes and edges coincide
            return Vec3(static_cast<int>(below(7)) - 3, static_cast<int>(below(7)) - 3,
                        static_cast<int>(below(7)) - 3);
        }
        return {number(4), number(4), number(4)};
    }

    /// Convex or not, flat or not, wound either way, large or without area.
    std::vector<Vec3> polygon() {
        std::vector<Vec3> points;
        switch (below(6)) {
        case 0: // any points
            for (std::uint32_t n = below(flat_ ? 4 : 8); n > 0; --n)
                points.push_back(point());
            return points;
        case 1: // all on a line, or in one place
            points.assign(3 + below(3), point());
            for (std::size_t i = 1; i < points.size() && oneIn(2); ++i)
                points[i] += Vec3(static_cast<double>(i), 0, 0);
            return points;
        default:
            return regular();
        }
    }

private:
    std::vector<Vec3> regular() {
        const bool south = inARow_ && !oneIn(5);
        const Vec3 centre = point();
        const Vec3 across = south ? Vec3(1.0 + std::abs(number(3)), number(0.2), 0) : point();
        const Vec3 towards = south ? Vec3(0, number(0.2), 1.0 + std::abs(number(3))) : point();
        const std::uint32_t corners = 3 + below(10);
        const double bent = oneIn(3) && !flat_ ? 0.3 : 0.0, size = oneIn(8) ? (flat_ ? 1e2 : 1e6) : 1.0;
        std::vector<Vec3> points;
        for (std::uint32_t i = 0; i < corners; ++i) {
            const double angle = 2.0 * 3.14159265358979 * i / corners;
            const Vec3 bend = Vec3(number(1), number(1), number(1)) * bent;
            points.push_back(centre + (across * std::cos(angle) + towards * std::sin(angle)) * size + bend);
        }
        return points;
    }
    std::mt19937 random_;
    bool inARow_; ///< most openings face south: a gaze from there passes through many
    bool flat_;   ///< no polygon is bent
};

/// At most nine openings between at most four spaces: into the same space, duplicated, one-way, with an
/// arbitrary portal as reciprocal.
Graph oddGraph(Odd& odd) {
    const std::uint32_t spaceCount = 1 + odd.below(4);
    std::vector<SpaceDesc> spaces(spaceCount);
    std::vector<PortalDesc> portals;
    std::vector<Vec3> vertices;
    const std::uint32_t total = odd.oneIn(4) ? 1 + odd.below(5) : 6 + odd.below(4);
    for (std::uint32_t s = 0; s < spaceCount; ++s) {
        spaces[s].zone = odd.oneIn(6) ? 0 : s;
        spaces[s].firstPortal = static_cast<std::uint32_t>(portals.size());
        while (portals.size() < (s + 1) * total / spaceCount) {
            PortalDesc portal;
            portal.space = s;
            portal.destination = odd.oneIn(12) ? kNone : odd.below(spaceCount);
            portal.reciprocal = odd.oneIn(3) ? kNone : odd.below(total);
            portal.exact = !odd.oneIn(3);
            portal.firstVertex = static_cast<std::uint32_t>(vertices.size());
            std::vector<Vec3> polygon = odd.polygon();
            if (!portals.empty() && odd.oneIn(4)) { // the last one again, or turned round
                const PortalDesc& last = portals.back();
                polygon.assign(vertices.begin() + last.firstVertex,
                               vertices.begin() + last.firstVertex + last.vertexCount);
                if (odd.oneIn(2))
                    std::reverse(polygon.begin(), polygon.end());
            }
            portal.vertexCount = static_cast<std::uint32_t>(polygon.size());
            vertices.insert(vertices.end(), polygon.begin(), polygon.end());
            portals.push_back(portal);
            ++spaces[s].portalCount;
        }
    }
    auto graph = Graph::build(spaces, portals, vertices);
    RC_ASSERT(graph.has_value());
    return std::move(*graph);
}

/// A random eye, often in an opening's plane, on its edge or in its corner.
View oddView(Odd& odd, const Graph& graph) {
    View view = viewFrom(odd.point(), odd.oneIn(3) ? 90.0 * odd.below(4) : odd.number(180.0),
                         odd.oneIn(3) ? 0.0 : odd.number(89.0),
                         odd.below(static_cast<std::uint32_t>(graph.spaces().size())));
    const auto polygon =
        graph.polygon(graph.portals()[odd.below(static_cast<std::uint32_t>(graph.portals().size()))]);
    if (odd.oneIn(2)) {
        view = viewFrom(Vec3(0, -4, 0) + odd.point() * 0.25, odd.oneIn(2) ? 0.0 : odd.number(30), 0.0,
                        view.root);
    } else if (!polygon.empty() && odd.oneIn(2)) {
        const Vec3 a = polygon[odd.below(static_cast<std::uint32_t>(polygon.size()))];
        const Vec3 b = polygon[odd.below(static_cast<std::uint32_t>(polygon.size()))];
        view.eye = a + (b - a) * (odd.oneIn(2) ? 0.5 : 0.0);
    }
    return view;
}

/// The distance outside an edge that rounding can cause.
double slack(const Vec3& edge, const Vec3& v) {
    return 1e-9 * (1.0 + glm::length(edge) * glm::length(v));
}

/// Whether the inner region is inside every edge of the outer one.
bool liesIn(std::span<const Vec3> inner, std::span<const Vec3> outer) {
    for (std::size_t e = 0; e < outer.size(); ++e) {
        const Vec3 edge = glm::cross(outer[e], outer[(e + 1) % outer.size()]);
        for (const Vec3& v : inner)
            if (glm::dot(edge, v) < -slack(edge, v))
                return false;
    }
    return true;
}

void checkVisit(const Graph& graph, const VisibleSet& set, std::uint32_t index) {
    const Visit& visit = set.visits[index];
    RC_ASSERT(visit.parent < index);
    RC_ASSERT(visit.depth == set.visits[visit.parent].depth + 1 && visit.depth <= graph.portals().size());
    RC_ASSERT(isFinite(visit.entryPlane.n) && std::isfinite(visit.entryPlane.d));
    const auto region = set.region(visit);
    RC_ASSERT(region.size() >= 3u);
    for (const Vec3& v : region)
        RC_ASSERT(isFinite(v));
    for (std::uint32_t up = visit.parent; up != kNone; up = set.visits[up].parent)
        RC_ASSERT(set.visits[up].portal != visit.portal);
}

RC_GTEST_PROP(FloodAnyGraph, endsAndYieldsATreeOfFiniteRegions, (unsigned seed)) {
    Odd odd(seed);
    const Graph graph = oddGraph(odd);
    for (int v = 0; v < 50; ++v) {
        const View view = oddView(odd, graph);
        const VisibleSet set = floodOnce(graph, view, {1u << 20, {}});
        RC_ASSERT(set.counts.visitsCut == 0u);
        for (std::uint32_t i = 1; i < set.visits.size(); ++i)
            checkVisit(graph, set, i);
        for (const SeenSpace& s : set.seen) {
            RC_ASSERT(s.visit < set.visits.size() && s.space < graph.spaces().size());
            RC_ASSERT(!std::isnan(s.rect.minX + s.rect.maxX) && !std::isnan(s.rect.minY + s.rect.maxY));
        }
    }
}

RC_GTEST_PROP(FloodAnyGraph, regionsLieInTheirParentsFromAnEyeThatTouchesNothing, (unsigned seed)) {
    Odd odd(seed, true);
    const Graph graph = oddGraph(odd);
    for (int v = 0; v < 50; ++v) {
        View view = oddView(odd, graph);
        // From an eye on the outline of an opening, or inside the hull of a bent one, parts of it have no
        // direction.
        view.eye += Vec3(odd.number(0.5), odd.number(0.5), odd.number(0.5));
        const VisibleSet set = floodOnce(graph, view);
        for (std::uint32_t i = 1; i < set.visits.size(); ++i) {
            const auto inner = set.region(set.visits[i]);
            const auto outer = set.region(set.visits[set.visits[i].parent]);
            RC_ASSERT(liesIn(inner, outer));
        }
    }
}

TEST(FloodAnyGraph, theGraphsTriedLeadSomewhere) {
    std::size_t visits = 0, deep = 0, loops = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        Odd odd(seed);
        const Graph graph = oddGraph(odd);
        for (int v = 0; v < 50; ++v) {
            const VisibleSet set = floodOnce(graph, oddView(odd, graph));
            visits += set.visits.size() - 1;
            for (const Visit& visit : set.visits) {
                deep += visit.depth >= 3 ? 1 : 0;
                loops += visit.depth > 1 && visit.space == set.visits[0].space ? 1 : 0;
            }
        }
    }
    EXPECT_GT(visits, 1000u);
    EXPECT_GT(deep, 10u);
    EXPECT_GT(loops, 50u);
}

} // namespace
} // namespace limen::visibility
