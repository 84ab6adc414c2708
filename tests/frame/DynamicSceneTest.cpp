#include "PlannedWorld.h"

#include "frame/PackInstance.h"

#include <cstring>
#include <gtest/gtest.h>

namespace limen::test {
namespace {

struct DynamicSceneTest : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    world::SpaceIndex first = world::findCell(planned.world, rooms.world.id(rooms.first));
    world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));
    world::DynamicState state;
    frame::DynamicScene dynamics;

    /// A copy of a table, in the given spaces; its bounds are ahead of the eye of planInFirst, behind the
    /// door.
    void addTable(const std::vector<world::SpaceIndex>& spaces) {
        const auto table =
            std::find_if(planned.world.instances.begin(), planned.world.instances.end(),
                         [](const world::Instance& in) { return in.kind == world::InstanceKind::Static; });
        ASSERT_NE(table, planned.world.instances.end());
        world::Instance copy = *table;
        copy.placedIn = spaces.front();
        copy.bounds.centre = planned.origin + Vec3(92, 96, 1);
        copy.object = 0xABCD + state.instances.size();
        copy.setMembers(static_cast<std::uint32_t>(state.members.size()), spaces.size());
        state.members.insert(state.members.end(), spaces.begin(), spaces.end());
        state.instances.push_back(copy);
    }
    void pack() {
        world::listBySpace(planned.world.spaces.size(), state);
        dynamics.pack(planned.scene, state);
    }
    const frame::FramePlan& planInFirst(std::vector<frame::Highlight> highlights = {}) {
        frame::FrameView view =
            frame::makeView(planned.origin + Vec3(92, 91, 1.5), 0, 0, 75, 320, 200, first);
        EXPECT_TRUE(visibility::flood(planned.graph, {}, view.view, {}, planned.scratch, planned.visible));
        view.highlights = highlights;
        planned.planner.plan(view, dynamics, planned.visible, planned.plan);
        return planned.plan;
    }
};

TEST_F(DynamicSceneTest, packsAnInstanceLikeAStaticOne) {
    addTable({first});
    pack();
    ASSERT_EQ(dynamics.records().size(), 1u);
    const world::Instance& in = state.instances[0];
    for (world::InstanceIndex i = 0; i < planned.world.instances.size(); ++i) {
        const world::Instance& original = planned.world.instances[i];
        if (original.idBase == in.idBase && original.placedIn == in.placedIn) {
            EXPECT_EQ(std::memcmp(&dynamics.records()[0], &planned.scene.records()[i],
                                  sizeof(frame::gpu::Instance)),
                      0);
            return;
        }
    }
    FAIL() << "the original is not in the world";
}

TEST_F(DynamicSceneTest, givesRecordsOfSeveralZonesMembersOfTheirOwn) {
    addTable({first});
    addTable({second, first, world::kOutside});
    addTable({second});
    pack();
    const auto sceneMembers = static_cast<std::uint32_t>(planned.scene.members().size());
    const auto records = dynamics.records();
    EXPECT_EQ(records[0].firstMember, first);
    EXPECT_EQ(records[1].firstMember, sceneMembers);
    EXPECT_EQ(frame::gpu::memberCountOf(records[1]), 3u);
    EXPECT_EQ(records[2].firstMember, second);
    ASSERT_EQ(dynamics.members().size(), 3u);
    EXPECT_EQ(dynamics.members()[0].zone, planned.world.spaces[second].zone) << "placedIn is first";
    const frame::FramePlan& plan = planInFirst();
    ASSERT_EQ(plan.members.size(), 3u);
    EXPECT_EQ(plan.constants.staticMembers, sceneMembers);
}

TEST_F(DynamicSceneTest, planRefersToTheRecordsOfVisibleInstances) {
    addTable({second});
    addTable({first});
    state.instances[1].bounds.centre = planned.origin + Vec3(92, 80, 1); // behind the eye
    pack();
    const frame::FramePlan& plan = planInFirst();
    EXPECT_EQ(plan.dynamicRecords.data(), dynamics.records().data());
    EXPECT_EQ(plan.dynamicInstances, std::vector<std::uint32_t>{0});
    EXPECT_TRUE(plan.dynamicHighlights.empty());
}

TEST_F(DynamicSceneTest, highlightsAreThePlansAndNotTheRecords) {
    addTable({second});
    addTable({second});
    pack();
    const frame::FramePlan& plan = planInFirst({{state.instances[1].object, 0xFF0000FFu}});
    ASSERT_EQ(plan.dynamicHighlights.size(), 1u);
    EXPECT_EQ(plan.dynamicHighlights[0].instance, 1u);
    EXPECT_EQ(plan.dynamicHighlights[0].colour, 0xFF0000FFu);
    EXPECT_EQ(dynamics.records()[1].highlight, 0u);
}

TEST_F(DynamicSceneTest, aNewStateReplacesTheOldOne) {
    addTable({first, second});
    pack();
    state = {};
    addTable({second});
    pack();
    EXPECT_EQ(dynamics.records().size(), 1u);
    EXPECT_TRUE(dynamics.members().empty());
    EXPECT_EQ(&dynamics.state(), &state);
}

TEST_F(DynamicSceneTest, withoutAStateThereIsNothingDynamic) {
    EXPECT_TRUE(dynamics.records().empty());
    EXPECT_TRUE(planInFirst().dynamicInstances.empty());
}

} // namespace
} // namespace limen::test
