#include "viewer/inspect/PortalTraces.h"

#include "support/SmallWorld.h"
#include "visibility/View.h"

#include <gtest/gtest.h>
#include <set>

namespace limen::viewer {
namespace {

using visibility::PortalFate;

TEST(PortalTraces, ofAPortalThatSeveralVisitsComeToTheMostCounts) {
    visibility::FloodTrace trace;
    trace.entries = {{0, 7, PortalFate::OutsideRegion},
                     {1, 3, PortalFate::WayBack},
                     {2, 7, PortalFate::Admitted},
                     {3, 7, PortalFate::WrongSide},
                     {4, 7, PortalFate::Admitted}};
    const std::vector<PortalTrace> traces = portalTraces(trace);
    EXPECT_EQ(traces, (std::vector<PortalTrace>{{3, PortalFate::WayBack, 1}, {7, PortalFate::Admitted, 2}}));
    const auto counts = countFates(traces);
    EXPECT_EQ(counts[static_cast<std::size_t>(PortalFate::Admitted)], 1u);
    EXPECT_EQ(counts[static_cast<std::size_t>(PortalFate::WayBack)], 1u);
    EXPECT_EQ(counts[static_cast<std::size_t>(PortalFate::OutsideRegion)], 0u);
}

TEST(PortalTraces, everyFateHasANameAndAColourOfItsOwn) {
    std::set<std::string_view> names;
    std::set<output::Rgb> colours;
    for (std::size_t i = 0; i < visibility::kPortalFates; ++i) {
        names.insert(nameOf(static_cast<PortalFate>(i)));
        colours.insert(colourOf(static_cast<PortalFate>(i)));
    }
    EXPECT_EQ(names.size(), visibility::kPortalFates);
    EXPECT_EQ(colours.size(), visibility::kPortalFates);
    EXPECT_FALSE(names.contains(""));
}

TEST(PortalTraces, aPortalSaysWhichItIsAndWhereItLeads) {
    world::World world = test::smallWorld();
    world.portals[0].destination = 1;
    EXPECT_EQ(portalLabel(world, {0, PortalFate::Admitted, 5}), "4 of outside to 0xA9B40105, visit 5");
    EXPECT_EQ(portalLabel(world, {1, PortalFate::LeadsNowhere, 0}), "2 of 0xA9B40105 to nothing, visit 0");
}

TEST(PortalTraces, outlinesLieWhereTheEyeSeesThemAndThoseThatCameToMostOnTop) {
    world::World world = test::smallWorld();
    world.portalCorners = {{-1, 4, -1}, {1, 4, -1}, {0, 4, 1}, {0, -4, 1}, {1, -4, -1}, {-1, -4, -1}};
    world.portals[0].cornerCount = world.portals[1].cornerCount = world.portals[1].firstCorner = 3;
    const std::vector<PortalTrace> traces{{0, PortalFate::Admitted, 0}, {1, PortalFate::BehindEye, 0}};
    const visibility::View north; // from the origin, 90 degrees wide
    const std::vector<PortalLine> lines = portalLines(world, traces, north);
    ASSERT_EQ(lines.size(), 3u) << "the other one is behind the eye";
    EXPECT_EQ(lines[0].from, Vec2(-0.25, -0.25));
    EXPECT_EQ(lines[0].to, Vec2(0.25, -0.25));
    EXPECT_EQ(lines[2].from, Vec2(0.0, 0.25));
    visibility::View aside = north;
    aside.eye = {0, -10, 0};
    const std::vector<PortalLine> both = portalLines(world, traces, aside);
    ASSERT_EQ(both.size(), 6u);
    EXPECT_EQ(both.front().fate, PortalFate::BehindEye);
    EXPECT_EQ(both.back().fate, PortalFate::Admitted);
}

} // namespace
} // namespace limen::viewer
