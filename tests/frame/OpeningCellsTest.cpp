#include "PlannedWorld.h"

#include "frame/OpeningCells.h"
#include "frame/ZoneScreenRects.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <tuple>

namespace limen::test {
namespace {

using frame::Program;
using Rects = std::vector<frame::gpu::vec4>;

/// Hand-made openings of a root that is outside.
struct Openings {
    Openings() {
        frame.width = 320;
        frame.height = 180;
        add({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, 0);
    }
    void add(const std::vector<Vec3>& region, std::uint32_t depth) {
        visibility::Visit visit;
        visit.depth = depth;
        visit.firstVertex = static_cast<std::uint32_t>(set.regionVertices.size());
        visit.vertexCount = static_cast<std::uint32_t>(region.size());
        set.visits.push_back(visit);
        set.regionVertices.insert(set.regionVertices.end(), region.begin(), region.end());
    }
    void addBox(double left, double low, double right, double high, std::uint32_t depth = 1) {
        add({{left, low, 1}, {right, low, 1}, {right, high, 1}, {left, high, 1}}, depth);
    }
    [[nodiscard]] Rects rects() {
        const frame::RectRun run = rectsOfOpenings(frame, set, plan);
        return {plan.rects.begin() + run.first, plan.rects.begin() + run.first + run.count};
    }
    frame::FrameView frame;
    visibility::VisibleSet set;
    frame::FramePlan plan;
};

int countAt(const Rects& rects, float x, float y) {
    return static_cast<int>(std::count_if(rects.begin(), rects.end(), [&](const frame::gpu::vec4& r) {
        return r.x <= x && x < r.z && r.y <= y && y < r.w;
    }));
}

TEST(OpeningCells, areThoseThatAnOpeningTouches) {
    Openings openings;
    openings.addBox(0.1, 0.3, 0.2, 0.4); // columns 8 and 9, rows 10 and 11, with two pixels around it
    EXPECT_EQ(openings.rects(), Rects{frame::gpu::vec4(0.0f, 0.25f, 0.25f, 0.5f)});
}

TEST(OpeningCells, areNoneWithoutAnOpening_andAllUnderOneOverTheWholeWindow) {
    Openings none;
    EXPECT_EQ(none.rects(), Rects{});
    Openings around;
    around.addBox(-1.0, -1.0, 1.0, 1.0);
    EXPECT_EQ(around.rects(), Rects{frame::gpu::vec4(-1, -1, 1, 1)});
}

TEST(OpeningCells, haveAShareOfThePicture) {
    Openings openings;
    openings.addBox(0.1, 0.3, 0.2, 0.4);
    openings.addBox(-0.8, -0.9, -0.6, -0.7);
    const frame::RectRun rects = rectsOfOpenings(openings.frame, openings.set, openings.plan);
    EXPECT_DOUBLE_EQ(shareOf(rects, openings.plan), (4.0 + 9.0) / 256.0);
    EXPECT_EQ(shareOf({}, openings.plan), 0.0);
}

RC_GTEST_PROP(OpeningCells, coverEachOpeningOnce_andNoPixelTwice, ()) {
    Openings openings;
    openings.frame.width = 160;
    openings.frame.height = 90;
    const auto ndc = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 1000.0; };
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i) {
        const double left = ndc(), low = ndc();
        const double right = std::min(left + std::abs(ndc()) / 3.0, 1.0),
                     high = std::min(low + std::abs(ndc()) / 3.0, 1.0);
        openings.addBox(left, low, right, high);
        openings.addBox(left, low, (left + right) / 2.0, high, 2); // behind the first
    }
    const Rects rects = openings.rects();
    for (std::uint32_t y = 0; y < openings.frame.height; ++y) {
        for (std::uint32_t x = 0; x < openings.frame.width; ++x) {
            const float atX = (2.0f * static_cast<float>(x) + 1.0f) / 160.0f - 1.0f,
                        atY = (2.0f * static_cast<float>(y) + 1.0f) / 90.0f - 1.0f;
            const int here = countAt(rects, atX, atY);
            RC_ASSERT(here <= 1);
            for (std::size_t i = 1; i < openings.set.visits.size() && here == 0; ++i) {
                const auto rect = rectAround(openings.frame, openings.set, openings.set.visits[i]);
                RC_ASSERT(countAt({rect}, atX, atY) == 0);
            }
        }
    }
}

struct PlannedSky : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    /// The batch of a program; nullptr: none.
    const frame::Batch* batchFrom(Program program, const Vec3& eye, double yaw, world::SpaceIndex root,
                                  bool fast) {
        static_cast<void>(planned.planFrom(eye, yaw, root));
        planned.view.fewTests = planned.view.fillsVoids = fast;
        planned.planner.plan(planned.view, planned.visible, planned.plan);
        const auto& batches = planned.plan.batches;
        const auto found = std::find_if(batches.begin(), batches.end(),
                                        [&](const frame::Batch& batch) { return batch.program == program; });
        return found == batches.end() ? nullptr : &*found;
    }
};

TEST_F(PlannedSky, hasVoidsNearOpenings_forAFastFrameFromOutside) {
    const world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));
    const auto plain = [&](const Vec3& eye, double yaw, world::SpaceIndex root, bool fast) {
        const frame::Batch* batch = batchFrom(Program::SkyPlain, eye, yaw, root, fast);
        return batch == nullptr ? std::tuple(false, false, 9u)
                                : std::tuple(batch->gated, batch->count > 0, batch->draws);
    };
    EXPECT_EQ(plain({92, 104, 1.5}, 180, world::kOutside, true), std::tuple(true, true, 1u));
    EXPECT_EQ(plain({92, 104, 1.5}, 180, world::kOutside, false), std::tuple(true, false, 1u));
    EXPECT_EQ(plain({92, 104, 1.5}, 0, world::kOutside, true), std::tuple(false, false, 1u)) << "one visit";
    EXPECT_EQ(plain({92, 96, 1.5}, 0, second, true), std::tuple(true, false, 1u)) << "through the exit";
    EXPECT_EQ(plain({92, 96, 1.5}, 180, second, true), std::tuple(true, false, 0u)) << "voids alone";
}

struct RootFirstPlan : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};

    /// The turns of a program's batches, in order; Clearing has none.
    [[nodiscard]] std::vector<std::pair<Program, frame::Turn>> solid() const {
        std::vector<std::pair<Program, frame::Turn>> out;
        const frame::Stage& stage = planned.plan.stages[static_cast<std::size_t>(frame::StageKind::Solid)];
        for (std::uint32_t i = stage.firstBatch; i < stage.firstBatch + stage.batchCount; ++i)
            out.emplace_back(planned.plan.batches[i].program, planned.plan.batches[i].turn);
        return out;
    }
    bool isRootFirst(const Vec3& eye, double yaw, world::SpaceIndex root) {
        planned.rootFirst = true;
        const auto& plan = planned.planFrom(eye, yaw, root);
        return (plan.constants.flags & frame::gpu::kFrameRootFirst) != 0;
    }
};

TEST_F(RootFirstPlan, drawsTheRootBeforeTheClearingAndTheRestAfterIt) {
    using frame::Turn;
    ASSERT_TRUE(isRootFirst({92, 112, 1.5}, 180, world::kOutside));
    EXPECT_EQ(solid(), (std::vector<std::pair<Program, Turn>>{{Program::Opaque, Turn::Before},
                                                              {Program::Terrain, Turn::Before},
                                                              {Program::Opaque, Turn::Before},
                                                              {Program::CutOut, Turn::Before},
                                                              {Program::Clearing, Turn::Both},
                                                              {Program::CutOut, Turn::After},
                                                              {Program::Terrain, Turn::After}}));
    const frame::FramePlan& plan = planned.plan;
    std::set<std::uint32_t> before, after;
    for (const frame::Batch& batch : plan.batches) {
        EXPECT_EQ(batch.gated && batch.turn == Turn::Before, false);
        for (std::uint32_t r = batch.first; batch.turn != Turn::Both && r < batch.first + batch.count; ++r)
            for (const frame::gpu::DrawPiece& piece : planned.piecesOf(plan.runs[r])) {
                const Turn turn = plan.runs[r].turn;
                if (batch.turn == Turn::Before && turn != Turn::After)
                    before.insert(piece.instance);
                if (batch.turn == Turn::After && turn != Turn::Before)
                    after.insert(piece.instance);
            }
    }
    std::set<std::uint32_t> all = before;
    all.insert(after.begin(), after.end());
    EXPECT_EQ(all.size(), plan.counts.instancesDrawn) << "each has a turn";
    const world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));
    EXPECT_TRUE(after.contains(planned.world.spaces[second].shell)) << "behind the exit";
    EXPECT_FALSE(before.contains(planned.world.spaces[second].shell));
    for (const std::uint32_t instance : before)
        EXPECT_NE(planned.world.instances[instance].kind, world::InstanceKind::Shell);
    EXPECT_FALSE(before.empty());
}

TEST_F(RootFirstPlan, isForAnEyeOutsideThatSeesSmallOpenings) {
    const world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));
    EXPECT_TRUE(isRootFirst({92, 112, 1.5}, 180, world::kOutside));
    EXPECT_FALSE(isRootFirst({92, 99, 1.5}, 180, world::kOutside)) << "the exit fills much of the picture";
    EXPECT_FALSE(isRootFirst({92, 112, 1.5}, 0, world::kOutside)) << "one visit";
    EXPECT_FALSE(isRootFirst({92, 96, 1.5}, 0, second)) << "within a cell";
}

TEST_F(PlannedSky, objectsTakeATestInExactFramesAlone) {
    for (const bool fast : {false, true}) {
        const frame::Batch* objects =
            batchFrom(Program::SkyObjects, {92, 104, 1.5}, 180, world::kOutside, fast);
        ASSERT_NE(objects, nullptr);
        EXPECT_EQ(objects->gated, !fast);
    }
}

} // namespace
} // namespace limen::test
