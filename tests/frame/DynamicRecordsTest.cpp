#include "PlannedWorld.h"

#include "frame/PackInstance.h"

#include <cstring>
#include <gtest/gtest.h>

namespace limen::test {
namespace {

struct DynamicRecordsTest : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    world::SpaceIndex first = world::findCell(planned.world, rooms.world.id(rooms.first));
    world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));
    world::DynamicState state;

    /// A static instance of the world, a table.
    [[nodiscard]] world::InstanceIndex table() const {
        for (world::InstanceIndex i = 0; i < planned.world.instances.size(); ++i)
            if (planned.world.instances[i].kind == world::InstanceKind::Static)
                return i;
        return world::kNone;
    }
    /// A copy of the table, in the given spaces; its bounds are ahead of the eye of planInFirst, behind the
    /// door.
    void addTable(const std::vector<world::SpaceIndex>& spaces) {
        world::Instance copy = planned.world.instances.at(table());
        copy.bounds.centre = planned.origin + Vec3(92, 96, 1);
        copy.placedIn = spaces.front();
        copy.object = 0xABCD + state.instances.size();
        copy.setMembers(static_cast<std::uint32_t>(state.members.size()), spaces.size());
        state.members.insert(state.members.end(), spaces.begin(), spaces.end());
        state.instances.push_back(copy);
    }
    const frame::FramePlan& planInFirst(const std::vector<frame::Highlight>& highlights = {}) {
        world::listBySpace(planned.world.spaces.size(), state);
        frame::FrameView view =
            frame::makeView(planned.origin + Vec3(92, 91, 1.5), 0, 0, 75, 320, 200, first);
        EXPECT_TRUE(visibility::flood(planned.graph, {}, view.view, {}, planned.scratch, planned.visible));
        view.highlights = highlights;
        planned.planner.plan(view, state, planned.visible, planned.plan);
        return planned.plan;
    }
    /// The records of a plan's dynamic instances, as the ring has them.
    [[nodiscard]] static std::vector<frame::gpu::Instance> recordsOf(const frame::FramePlan& plan) {
        std::vector<frame::gpu::Instance> records(plan.dynamicInstances.size());
        plan.dynamicRecords.write(plan.dynamicRecords.instances, plan.dynamicInstances, records);
        for (const frame::DynamicChange& change : plan.dynamicChanges)
            change.applyTo(records.at(change.instance));
        return records;
    }
    static void expectSame(const frame::gpu::Instance& a, const frame::gpu::Instance& b) {
        EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
    }
};

TEST_F(DynamicRecordsTest, areTheSameAsStaticOnes) {
    const world::InstanceIndex original = table();
    addTable({second});
    state.instances[0].linear = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    state.instances[0].level = 7;
    state.instances[0].opacity = 0.25f;
    addTable({second});
    state.instances[1].placedIn = planned.world.instances[original].placedIn;
    const std::vector<frame::gpu::Instance> records = recordsOf(planInFirst());
    ASSERT_EQ(records.size(), 2u);
    expectSame(records[0], frame::packInstance(state.instances[0], {second, 1}));
    frame::gpu::Instance expected = planned.scene.records()[original];
    expected.firstMember =
        planned.world.instances[original].placedIn; // the static one has a light set of its own
    expectSame(records[1], expected);
}

// A number so large that they are written with stores that bypass the cache.
TEST_F(DynamicRecordsTest, areTheSameInLargeNumbers) {
    constexpr std::uint32_t kMany = (2u << 20) / sizeof(frame::gpu::Instance);
    for (std::uint32_t i = 0; i < kMany; ++i) {
        addTable({second});
        state.instances.back().idBase = i;
        state.instances.back().origin.x = static_cast<float>(i);
    }
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < kMany; ++i)
        numbers.push_back(i * 7 % kMany);
    std::vector<frame::gpu::Instance> records(kMany);
    const frame::DynamicRecords made = frame::recordsOf(state.instances);
    made.write(made.instances, numbers, records);
    for (std::uint32_t i = 0; i < kMany && !HasFailure(); ++i)
        expectSame(records[i], frame::packInstance(state.instances[numbers[i]], {second, 1}));
}

TEST_F(DynamicRecordsTest, inSeveralZonesHaveMembersOfTheirOwn) {
    addTable({second});
    addTable({second, first, world::kOutside});
    const frame::FramePlan& plan = planInFirst();
    const std::vector<frame::gpu::Instance> records = recordsOf(plan);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].firstMember, second);
    EXPECT_EQ(records[1].firstMember, plan.constants.staticMembers) << "the first of the frame's";
    EXPECT_EQ(frame::gpu::memberCountOf(records[1]), 3u);
    ASSERT_EQ(plan.members.size(), 3u);
    EXPECT_EQ(plan.members[0].zone, planned.world.spaces[second].zone) << "placedIn is first";
}

TEST_F(DynamicRecordsTest, areThoseOfVisibleInstances) {
    addTable({first});
    state.instances[0].bounds.centre = planned.origin + Vec3(92, 80, 1); // behind the eye
    addTable({second});
    const frame::FramePlan& plan = planInFirst();
    EXPECT_EQ(plan.dynamicInstances, std::vector<std::uint32_t>{1});
    EXPECT_TRUE(plan.dynamicChanges.empty());
}

TEST_F(DynamicRecordsTest, haveTheHighlightsOfTheirObjects) {
    addTable({second});
    addTable({second});
    const auto records = recordsOf(planInFirst({{state.instances[1].object, 0xFF0000FFu}}));
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].highlight, 0u);
    EXPECT_EQ(records[1].highlight, 0xFF0000FFu);
}

TEST_F(DynamicRecordsTest, areNoneWithoutDynamicInstances) {
    EXPECT_TRUE(planInFirst().dynamicInstances.empty());
}

} // namespace
} // namespace limen::test
