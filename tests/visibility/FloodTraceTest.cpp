// For each fate of a portal, a small scene that produces it.
#include "visibility/TestGraph.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace limen::visibility {
namespace {

struct Traced {
    VisibleSet set;
    FloodTrace trace;

    [[nodiscard]] std::vector<PortalFate> fatesOf(std::uint32_t portal, std::uint32_t visit = 0) const {
        std::vector<PortalFate> fates;
        for (const FloodTrace::Entry& entry : trace.entries)
            if (entry.portal == portal && entry.visit == visit)
                fates.push_back(entry.fate);
        return fates;
    }
};

Traced traced(const Graph& graph, const View& view, const Limits& limits = {},
              std::span<const std::uint8_t> closed = {}) {
    Traced result;
    FloodScratch scratch;
    result.trace.entries.resize(3); // of an earlier flood
    EXPECT_TRUE(flood(graph, closed, view, limits, scratch, result.set, &result.trace));
    return result;
}

using Fates = std::vector<PortalFate>;

/// The fates of the first portal of a room at the origin with one opening to another room, 10 m to the north.
Fates fatesOfOneDoor(const View& view, std::span<const std::uint8_t> closed = {}) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    return traced(world.build(), view, {}, closed).fatesOf(0);
}

TEST(FloodTrace, hasAdmittedRaysAndTheWayBack) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    const Traced flood = traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_EQ(flood.trace.entries,
              (std::vector<FloodTrace::Entry>{{0, 0, PortalFate::Admitted}, {1, 1, PortalFate::WayBack}}));
}

TEST(FloodTrace, tellsOfOpeningsOnTheWrongSideBehindTheEyeAndBesideIt) {
    EXPECT_EQ(fatesOfOneDoor(viewFrom({0, 0, 0}, 0, 0, 0)), Fates{PortalFate::Admitted});
    EXPECT_EQ(fatesOfOneDoor(viewFrom({0, 0, 0}, 180, 0, 0)), Fates{PortalFate::BehindEye});
    EXPECT_EQ(fatesOfOneDoor(viewFrom({0, 0, 0}, 60, 0, 0)), Fates{PortalFate::OutsideRegion});
    EXPECT_EQ(fatesOfOneDoor(viewFrom({0, 12, 0}, 0, 0, 0)), Fates{PortalFate::WrongSide});
    EXPECT_EQ(fatesOfOneDoor(viewFrom({5, 10, 0}, -90, 0, 0)), Fates{PortalFate::EdgeOn});
}

TEST(FloodTrace, tellsOfOpeningsThatAreShutOrLeadNowhere) {
    const std::vector<std::uint8_t> shut{1, 1};
    EXPECT_EQ(fatesOfOneDoor(viewFrom({0, 0, 0}, 0, 0, 0), shut), Fates{PortalFate::Shut});
    EXPECT_EQ(fatesOfOneDoor(viewFrom({0, 10, 0}, 0, 0, 0), shut), Fates{PortalFate::EdgeOn})
        << "in the plane of the filling";
    TestGraph world;
    world.addSpace();
    world.linkOneWay(0, kNone, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    EXPECT_EQ(traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0)).fatesOf(0),
              Fates{PortalFate::LeadsNowhere});
}

TEST(FloodTrace, tellsOfPolygonsWithoutArea) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.link(0, 1, {{-1, 10, 0}, {0, 10, 0}, {1, 10, 0}});
    EXPECT_EQ(traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0)).fatesOf(0), Fates{PortalFate::NoArea});
}

TEST(FloodTrace, tellsOfInexactPairsThatMissEachOther) {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2),
                      uprightRectangle({5, 10, 0}, {0, 1, 0}, 2, 2));
    EXPECT_EQ(traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0)).fatesOf(0), Fates{PortalFate::PairMissed});
    TestGraph partly;
    partly.addSpace();
    partly.addSpace();
    partly.linkInexact(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 4, 2),
                       uprightRectangle({0, 10, 0}, {0, 1, 0}, 2, 2));
    Fates fates = traced(partly.build(), viewFrom({0, 0, 0}, 0, 0, 0)).fatesOf(0);
    std::sort(fates.begin(), fates.end());
    EXPECT_EQ(fates, (Fates{PortalFate::PairMissed, PortalFate::Admitted})) << "the hole around it, too";
}

TEST(FloodTrace, tellsOfOpeningsBeforeThePlaneThatTheRaysCameInBy) {
    // An opening of the second room that is on this side of the door to that room.
    TestGraph world;
    for (int i = 0; i < 3; ++i)
        world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.linkOneWay(1, 2, uprightRectangle({0, 5, 0}, {0, -1, 0}, 2, 2));
    const Graph graph = world.build();
    const Traced flood = traced(graph, viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_EQ(graph.portals()[2].space, 1u);
    EXPECT_EQ(flood.fatesOf(2, 1), Fates{PortalFate::BeforeEntry});
}

TEST(FloodTrace, tellsOfOpeningsThatNearerOnesCover) {
    TestGraph world;
    for (int i = 0; i < 3; ++i)
        world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 6, 6));
    world.link(0, 2, uprightRectangle({0, 30, 0}, {0, -1, 0}, 2, 2));
    const Traced flood = traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_EQ(flood.fatesOf(0), Fates{PortalFate::Admitted});
    EXPECT_EQ(flood.fatesOf(1), Fates{PortalFate::Covered});
}

TEST(FloodTrace, tellsOfOpeningsThatTheBudgetLeavesOut) {
    TestGraph world;
    for (int i = 0; i < 4; ++i)
        world.addSpace();
    for (std::uint32_t i = 1; i < 4; ++i) // ever smaller, side by side
        world.linkOneWay(0, i, uprightRectangle({4.0 * i - 8.0, 10, 0}, {0, -1, 0}, 3.0 / (i * i), 2));
    Limits limits;
    limits.maxVisits = 3;
    const Traced flood = traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0), limits);
    EXPECT_EQ(flood.fatesOf(0), Fates{PortalFate::Admitted});
    EXPECT_EQ(flood.fatesOf(2), Fates{PortalFate::Budget});
    EXPECT_GT(flood.set.counts.visitsCut, 0u);
}

TEST(FloodTrace, tellsWhatBecomesOfOpeningsWithinAZone) {
    TestGraph world;
    for (int i = 0; i < 5; ++i)
        world.addSpace(0);
    world.linkOneWay(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    world.linkOneWay(0, 2, uprightRectangle({0, -10, 0}, {0, 1, 0}, 2, 2));
    world.linkOneWay(0, 3, uprightRectangle({30, 10, 0}, {0, -1, 0}, 2, 2));
    world.linkOneWay(0, 4, uprightRectangle({0, 12, 0}, {0, 1, 0}, 2, 2));
    world.linkOneWay(0, 0, uprightRectangle({0, 9, 0}, {0, -1, 0}, 2, 2));
    const Traced flood = traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_EQ(flood.fatesOf(0), Fates{PortalFate::WithinZone});
    EXPECT_EQ(flood.fatesOf(1), Fates{PortalFate::BehindEye});
    EXPECT_EQ(flood.fatesOf(2), Fates{PortalFate::OutsideRegion});
    EXPECT_EQ(flood.fatesOf(3), Fates{PortalFate::WrongSide});
    EXPECT_EQ(flood.fatesOf(4), Fates{PortalFate::WithinZone}) << "it leads into its own space";
    const std::vector<std::uint8_t> shut{1, 0, 0, 0, 0};
    EXPECT_EQ(traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0), {}, shut).fatesOf(0),
              Fates{PortalFate::Shut});
}

TEST(FloodTrace, tellsOfRingsOfBentOpenings) {
    // A bent polygon extends beyond its own plane, so that rays meet it again.
    TestGraph world;
    world.addSpace();
    world.addSpace();
    const std::vector<Vec3> bent{{-2, 10, -2}, {2, 10, -2}, {2, 10, 2}, {0, 16, 3}, {-2, 10, 2}};
    world.linkOneWay(0, 1, bent);
    world.linkOneWay(1, 0, bent);
    const Traced flood = traced(world.build(), viewFrom({0, 0, 0}, 0, 0, 0));
    const bool again = std::any_of(flood.trace.entries.begin(), flood.trace.entries.end(),
                                   [](const auto& entry) { return entry.fate == PortalFate::InChain; });
    EXPECT_TRUE(again);
}

TEST(FloodTrace, everyPortalOfASpaceThatIsSeenIsToldOfAlsoWhenThereAreMany) {
    TestGraph world;
    world.addSpace();
    for (std::uint32_t i = 0; i < 200; ++i) {
        world.addSpace();
        const double angle = 0.0314159 * i;
        const Vec3 out(std::sin(angle), std::cos(angle), 0);
        world.link(0, i + 1, uprightRectangle(out * (20.0 + i % 7), -out, 0.3, 2));
    }
    const Graph graph = world.build();
    ASSERT_NE(graph.spaces()[0].root, kNone) << "it has a tree of bounds";
    const View view = viewFrom({0, 0, 0}, 30, 0, 0);
    const Traced flood = traced(graph, view);
    std::size_t admitted = 0;
    for (std::uint32_t p = 0; p < 200; ++p) {
        ASSERT_EQ(flood.fatesOf(p).size(), 1u) << p;
        admitted += flood.fatesOf(p).front() == PortalFate::Admitted ? 1u : 0u;
    }
    EXPECT_EQ(admitted, flood.set.visits.size() - 1);
    const VisibleSet untraced = floodOnce(graph, view);
    EXPECT_EQ(untraced.regionVertices, flood.set.regionVertices) << "a trace changes nothing";
    EXPECT_EQ(untraced.counts.portalsTested, flood.set.counts.portalsTested);
}

} // namespace
} // namespace limen::visibility
