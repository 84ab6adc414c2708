#include "PlannedWorld.h"

#include "frame/ZoneScreenRects.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

constexpr std::uint32_t kSize = 100; // pixels, each way: two are 0.04 of NDC
constexpr world::ZoneIndex kOut = 0, kRoom = 1, kOther = 2;

/// Hand-made visits; the root has the whole screen.
struct ZoneScreenRectsTest : ::testing::Test {
    ZoneScreenRectsTest() {
        frame.width = frame.height = kSize;
        add(kRoom, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
    }
    void add(world::ZoneIndex zone, const std::vector<Vec3>& region) {
        visibility::Visit visit;
        visit.zone = zone;
        visit.depth = set.visits.empty() ? 0 : 1;
        visit.firstVertex = static_cast<std::uint32_t>(set.regionVertices.size());
        visit.vertexCount = static_cast<std::uint32_t>(region.size());
        set.visits.push_back(visit);
        set.regionVertices.insert(set.regionVertices.end(), region.begin(), region.end());
    }
    void addAt(world::ZoneIndex zone, double x) {
        add(zone, {{x, 0, 1}, {x + 0.05, 0, 1}, {x + 0.05, 0.1, 1}, {x, 0.1, 1}});
    }
    frame::FrameView frame;
    visibility::VisibleSet set;
    frame::FramePlan plan;
    frame::ZoneScreenRects rects{3};
};

TEST_F(ZoneScreenRectsTest, exceedTheRegionByTwoPixels) {
    add(kOut, {{0, -1, 2}, {1, 0, 2}, {0.5, 2, 4}}); // (x, y, w): 0 .. 0.5 and -0.5 .. 0.5
    rects.find(frame, set, plan);
    ASSERT_EQ(rects.of(kOut), (frame::RectRun{0, 1}));
    const auto& rect = plan.rects[0];
    EXPECT_FLOAT_EQ(rect.x, -0.04f);
    EXPECT_FLOAT_EQ(rect.y, -0.54f);
    EXPECT_FLOAT_EQ(rect.z, 0.54f);
    EXPECT_FLOAT_EQ(rect.w, 0.54f);
}

TEST_F(ZoneScreenRectsTest, theRootsZoneHasNone_norHasOneThatIsNotVisited) {
    addAt(kOut, 0.0);
    addAt(kRoom, 0.5); // seen again, through the outside
    rects.find(frame, set, plan);
    EXPECT_EQ(rects.of(kRoom), frame::RectRun());
    EXPECT_EQ(rects.of(kOther), frame::RectRun());
    EXPECT_EQ(rects.of(world::kNone), frame::RectRun());
    EXPECT_EQ(plan.rects.size(), 1u);
}

TEST_F(ZoneScreenRectsTest, eachVisitHasItsOwn_ofMoreThanEightTheLastHoldsAll) {
    addAt(kOther, 0.9);
    for (int i = 0; i < 10; ++i)
        addAt(kOut, -0.9 + 0.1 * i);
    rects.find(frame, set, plan);
    ASSERT_EQ(rects.of(kOut), (frame::RectRun{0, frame::ZoneScreenRects::kMostRects}));
    EXPECT_EQ(rects.of(kOther), (frame::RectRun{8, 1}));
    EXPECT_FLOAT_EQ(plan.rects[1].x, -0.84f);
    EXPECT_FLOAT_EQ(plan.rects[1].z, -0.71f);
    EXPECT_FLOAT_EQ(plan.rects[7].x, -0.24f);
    EXPECT_FLOAT_EQ(plan.rects[7].z, 0.09f);
}

TEST_F(ZoneScreenRectsTest, areForgottenWithTheFrame) {
    addAt(kOut, 0.0);
    rects.find(frame, set, plan);
    set.visits.pop_back();
    plan.clear();
    rects.find(frame, set, plan);
    EXPECT_EQ(rects.of(kOut), frame::RectRun());
    EXPECT_TRUE(plan.rects.empty());
}

// From the first room: the second is seen through the door, the landscape through the door and the exit, and
// the content of the first room anywhere.
TEST(PlannedRects, runsOfZonesSeenThroughOpeningsHaveTheirRects) {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    const auto first = world::findCell(planned.world, rooms.world.id(rooms.first));
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    ASSERT_EQ(planned.visible.visits.size(), 3u);
    std::size_t narrowed = 0;
    for (const frame::Batch& batch : plan.batches) {
        if (batch.program != frame::Program::Opaque && batch.program != frame::Program::Terrain)
            continue;
        for (std::uint32_t r = batch.first; r < batch.first + batch.count; ++r) {
            for (const frame::gpu::DrawPiece& piece : planned.piecesOf(plan.runs[r])) {
                const world::Instance& in = planned.world.instances[piece.instance];
                const bool isAlone = in.memberCount == 1;
                EXPECT_EQ(plan.runs[r].rects.count > 0, isAlone && in.placedIn != first);
                narrowed += plan.runs[r].rects.count;
            }
        }
    }
    EXPECT_GE(narrowed, 2u) << "the second room's shell, the ground";
}

} // namespace
} // namespace limen::test
