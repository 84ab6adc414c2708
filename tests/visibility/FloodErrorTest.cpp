#include "visibility/TestGraph.h"

#include <gtest/gtest.h>

#include <limits>

namespace limen::visibility {
namespace {

/// Two rooms along +y with a door between them in y = 10.
Graph twoRooms() {
    TestGraph world;
    world.addSpace();
    world.addSpace();
    world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
    return world.build();
}

TEST(FloodErrors, refuseAnInvalidViewAndLeaveNoVisits) {
    const Graph graph = twoRooms();
    const View valid = viewFrom({0, 5, 0}, 0, 0, 1);
    FloodScratch scratch;
    VisibleSet set;
    FloodTrace trace;
    const auto expectRefused = [&](const View& view, std::span<const std::uint8_t> closed = {}) {
        for (FloodTrace* const watched : {&trace, static_cast<FloodTrace*>(nullptr)}) {
            ASSERT_TRUE(flood(graph, {}, valid, {}, scratch, set));
            ASSERT_FALSE(set.visits.empty());
            const Result<void> refused = flood(graph, closed, view, {}, scratch, set, watched);
            ASSERT_FALSE(refused);
            EXPECT_EQ(refused.error().code, ErrorCode::BadArgument);
            EXPECT_TRUE(set.visits.empty() && set.seen.empty());
        }
    };
    for (const std::uint32_t root : {2u, kNone}) {
        View view = valid;
        view.root = root;
        expectRefused(view);
    }
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        for (Vec3 View::*const vector : {&View::eye, &View::right, &View::up, &View::forward}) {
            View view = valid;
            (view.*vector).y = bad;
            expectRefused(view);
        }
    }
    for (const double bad : {kNan, kInfinity, 0.0, -1.0}) {
        for (double View::*const tangent : {&View::tanHalfX, &View::tanHalfY}) {
            View view = valid;
            view.*tangent = bad;
            expectRefused(view);
        }
    }
    View skewed = valid;
    skewed.up = skewed.forward;
    expectRefused(skewed);
    skewed.up = 2.0 * valid.up;
    expectRefused(skewed);
    expectRefused(valid, std::vector<std::uint8_t>(graph.portals().size() + 1, 0));
}

TEST(FloodErrors, nameTheRootThatDoesNotExist) {
    const Graph graph = twoRooms();
    FloodScratch scratch;
    VisibleSet set;
    const Result<void> refused = flood(graph, {}, viewFrom({0, 5, 0}, 0, 0, 7), {}, scratch, set);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message(), "view of a flood: root 7 is not one of the 2 spaces");
}

} // namespace
} // namespace limen::visibility
