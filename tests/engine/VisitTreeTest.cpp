#include "engine/report/VisitTree.h"
#include "support/SmallWorld.h"

#include <gtest/gtest.h>

namespace limen::engine {
namespace {

using test::smallWorld;
using test::twoVisits;

TEST(VisitTree, aVisitSaysWhereItLeadsThroughWhatAndHowLargeItIs) {
    const world::World world = smallWorld();
    visibility::VisibleSet visible = twoVisits();
    EXPECT_EQ(visitLabel(world, visible, 0), "0 0xA9B40105, the eye's, 100 %");
    visible.regionVertices[4] = {0, 0, 4};
    EXPECT_EQ(visitLabel(world, visible, 1), "1 outside, portal 2 of 0xA9B40105, 6.25 %");
    visible.visits[1].inPlane = visible.visits[1].split = true;
    EXPECT_EQ(visitLabel(world, visible, 1),
              "1 outside, portal 2 of 0xA9B40105, 6.25 %, eye in its plane, a part of it");
}

TEST(VisitTree, aHoleSaysWhyTheRaysEnd) {
    const world::World world = smallWorld();
    visibility::VisibleSet visible = twoVisits();
    visible.regionVertices[4] = {0, 0, 4};
    visible.visits[1].hole = true;
    EXPECT_EQ(visitLabel(world, visible, 1), "1 leads nowhere, portal 2 of 0xA9B40105, 6.25 %");
    visible.visits[1].shut = true;
    EXPECT_EQ(visitLabel(world, visible, 1), "1 shut, portal 2 of 0xA9B40105, 6.25 %");
}

TEST(VisitTree, whatIsSeenBesidesIsOfTheVisitAlone) {
    const world::World world = smallWorld();
    const visibility::VisibleSet visible = twoVisits();
    EXPECT_TRUE(seenBesides(world, visible, 0).empty());
    EXPECT_EQ(seenBesides(world, visible, 1), std::vector<std::string>{"0xA9B40105"});
}

} // namespace
} // namespace limen::engine
