#include "PlannedWorld.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

constexpr std::uint32_t kRed = 0xFF0000FFu, kFaint = 0x10FFFFFFu;

struct HighlightsTest : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    world::SpaceIndex first = world::findCell(planned.world, rooms.world.id(rooms.first));

    const frame::FramePlan& planWith(std::vector<frame::Highlight> highlights) {
        planned.planFrom({92, 91, 1.5}, 0, first);
        planned.view.highlights = highlights;
        planned.planner.plan(planned.view, planned.visible, planned.plan);
        planned.view.highlights = {};
        return planned.plan;
    }
    [[nodiscard]] world::InstanceIndex tableOf(world::SpaceIndex space) const {
        for (world::InstanceIndex i = 0; i < planned.world.instances.size(); ++i) {
            const world::Instance& in = planned.world.instances[i];
            if (in.kind == world::InstanceKind::Static && in.placedIn == space)
                return i;
        }
        return world::kNone;
    }
};

TEST_F(HighlightsTest, noneReplaceNothing) {
    const frame::FramePlan& plan = planWith({});
    EXPECT_TRUE(plan.replacements.empty());
    EXPECT_EQ(plan.constants.replacementCount, 0u);
    EXPECT_TRUE(plan.records.empty());
}

TEST_F(HighlightsTest, replacesARecordByTheSameInAnotherColour) {
    const world::InstanceIndex table = tableOf(first);
    ASSERT_NE(table, world::kNone);
    const frame::FramePlan& plan = planWith({{planned.world.instances[table].object, kRed}});
    ASSERT_EQ(plan.replacements.size(), 1u);
    EXPECT_EQ(plan.constants.replacementCount, 1u);
    EXPECT_EQ(plan.replacements[0].instance, table);
    EXPECT_EQ(plan.replacements[0].by, planned.world.instances.size()) << "the first instance of the frame";
    ASSERT_EQ(plan.records.size(), 1u);
    const frame::gpu::Instance& record = plan.records[0];
    EXPECT_EQ(record.highlight, kRed);
    EXPECT_EQ(record.idBase, planned.world.instances[table].idBase);
    EXPECT_EQ(frame::gpu::memberCountOf(record), 1u);
    EXPECT_EQ(record.firstMember, planned.scene.records()[table].firstMember) << "the resident member";
    EXPECT_TRUE(plan.members.empty());
}

TEST_F(HighlightsTest, ofOneObjectTheLastCounts) {
    const std::uint64_t object = planned.world.instances[tableOf(first)].object;
    for (const std::uint32_t before : {kFaint, 0u}) {
        const frame::FramePlan& plan = planWith({{object, before}, {object, kRed}});
        ASSERT_EQ(plan.records.size(), 1u);
        EXPECT_EQ(plan.records[0].highlight, kRed);
    }
}

TEST_F(HighlightsTest, ignoresUnknownObjects) {
    EXPECT_TRUE(planWith({{0xDEADBEEFu, kRed}}).records.empty());
}

} // namespace
} // namespace limen::test
