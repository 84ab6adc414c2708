#include "CallList.h"

#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

frame::FramePlan planOf(std::initializer_list<frame::Batch> batches) {
    frame::FramePlan plan;
    plan.batches = batches;
    plan.stages = {{frame::StageKind::Solid, 0, static_cast<std::uint32_t>(batches.size())}};
    return plan;
}

TEST(CallList, framesOfOneListMustMakeAsManyCalls) {
    CallList calls;
    calls.add(planOf({{frame::Program::Opaque, false, 0, 1}}), 20);
    calls.add(planOf({{frame::Program::Opaque, false, 7, 900}}), 20);
    EXPECT_TRUE(calls.isOneForEachList());
    EXPECT_EQ(calls.lists(), 1u);
    calls.add(planOf({{frame::Program::Opaque, false, 0, 2}}), 21);
    EXPECT_FALSE(calls.isOneForEachList());
    EXPECT_EQ(calls.most(), 21u);
}

TEST(CallList, framesOfOtherListsMayDiffer) {
    CallList calls;
    calls.add(planOf({{frame::Program::Opaque, false, 0, 1}}), 20);
    calls.add(planOf({{frame::Program::Opaque, true, 0, 1}}), 21);
    calls.add(planOf({{frame::Program::CutOut, false, 0, 1}}), 22);
    calls.add(planOf({{frame::Program::Opaque, false, 0, 1}, {frame::Program::Opaque, false, 0, 1}}), 23);
    frame::FramePlan other = planOf({{frame::Program::Opaque, false, 0, 1}});
    other.stages[0].kind = frame::StageKind::Transparent;
    calls.add(other, 24);
    EXPECT_TRUE(calls.isOneForEachList());
    EXPECT_EQ(calls.lists(), 5u);
    EXPECT_EQ(calls.most(), 24u);
}

TEST(CallList, hashTellsEveryFrame) {
    CallList one, other;
    one.add(planOf({}), 20);
    other.add(planOf({}), 20);
    EXPECT_EQ(one.hash(), other.hash());
    other.add(planOf({}), 20);
    EXPECT_NE(one.hash(), other.hash());
}

} // namespace
} // namespace limen::bench::test
