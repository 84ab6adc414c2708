#include "PlannedWorld.h"

#include <algorithm>
#include <set>

namespace limen::test {
namespace {

using frame::Gate;
using frame::Program;
using frame::StageKind;

/// A draw: the instance of the world that it shows, and the clip set of the record that draws it.
struct Drawn {
    world::InstanceIndex instance = world::kNone;
    std::uint32_t clipSet = 0;
};

struct GatePlannerTest : ::testing::TestWithParam<Gate> {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    world::SpaceIndex first = world::findCell(planned.world, rooms.world.id(rooms.first));
    world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));

    const frame::FramePlan& planFrom(const Vec3& local, double yaw, world::SpaceIndex root) {
        planned.gate = GetParam();
        return planned.planFrom(local, yaw, root);
    }
    /// In the order of drawing. Records of the plan are found again by their first id.
    [[nodiscard]] std::vector<Drawn> drawnBy(const frame::FramePlan& plan) const {
        std::vector<Drawn> drawn;
        for (const frame::Batch& batch : plan.batches)
            if (!drawsOpenings(batch.program) && batch.program != Program::SkyPlain &&
                batch.program != Program::SkyObjects)
                for (const frame::gpu::DrawPiece& piece : planned.piecesOf(batch))
                    drawn.push_back(shownBy(plan, piece.instance));
        return drawn;
    }
    [[nodiscard]] Drawn shownBy(const frame::FramePlan& plan, std::uint32_t number) const {
        if (number < plan.constants.staticInstances)
            return {number, 0};
        const frame::gpu::Instance& record =
            plan.records[number - plan.constants.staticInstances - plan.dynamicInstances.size()];
        for (world::InstanceIndex i = 0; i < planned.world.instances.size(); ++i)
            if (planned.world.instances[i].idBase == record.idBase)
                return {i, record.block >> frame::gpu::kClipSetShift};
        return {};
    }
    [[nodiscard]] world::InstanceKind kindOf(const Drawn& drawn) const {
        return planned.world.instances[drawn.instance].kind;
    }
    [[nodiscard]] std::size_t count(const frame::FramePlan& plan, Program program) const {
        return static_cast<std::size_t>(
            std::count_if(plan.batches.begin(), plan.batches.end(),
                          [&](const frame::Batch& batch) { return batch.program == program; }));
    }
};
INSTANTIATE_TEST_SUITE_P(Gates, GatePlannerTest, ::testing::Values(Gate::Planes, Gate::Depth),
                         [](const auto& gate) { return std::string(nameOf(gate.param)); });

TEST_P(GatePlannerTest, everyVisibleCellHasItsShell) {
    for (const auto& [eye, root] : {std::pair(Vec3(92, 91, 1.5), first), std::pair(Vec3(92, 104, 1.5), 0u)}) {
        const auto& plan = planFrom(eye, root == first ? 0 : 180, root);
        EXPECT_TRUE(plan.clips);
        std::set<world::InstanceIndex> shells;
        for (const Drawn& drawn : drawnBy(plan))
            if (kindOf(drawn) == world::InstanceKind::Shell)
                shells.insert(drawn.instance);
        for (const visibility::Visit& visit : planned.visible.visits)
            if (visit.space != world::kOutside && !visit.hole)
                EXPECT_TRUE(shells.contains(planned.world.spaces[visit.space].shell));
        EXPECT_EQ(shells.size(), 2u);
    }
}

TEST_P(GatePlannerTest, objectsCarryNoPlanes) {
    const auto& plan = planFrom({92, 91, 1.5}, 0, first);
    std::size_t objects = 0;
    for (const Drawn& drawn : drawnBy(plan)) {
        if (kindOf(drawn) != world::InstanceKind::Static && kindOf(drawn) != world::InstanceKind::Scenery)
            continue;
        ++objects;
        EXPECT_EQ(drawn.clipSet, 0u);
    }
    EXPECT_GT(objects, 1u);
}

TEST_P(GatePlannerTest, aShellFollowsTheShellsBeyondIt) {
    const auto& plan = planFrom({92, 91, 1.5}, 0, first);
    std::vector<world::InstanceIndex> shells;
    for (const Drawn& drawn : drawnBy(plan))
        if (kindOf(drawn) == world::InstanceKind::Shell)
            shells.push_back(drawn.instance);
    EXPECT_EQ(shells, (std::vector{planned.world.spaces[second].shell, planned.world.spaces[first].shell}));
    ASSERT_EQ(plan.spaces.size(), 3u);
    EXPECT_EQ(plan.spaces[0].space, world::kOutside);
    EXPECT_EQ(plan.spaces[1].space, second);
    EXPECT_EQ(plan.spaces[2].space, first);
}

TEST_P(GatePlannerTest, theLandscapeIsGatedToItsRegion) {
    const auto& plan = planFrom({92, 91, 1.5}, 0, first);
    std::size_t ground = 0;
    for (const Drawn& drawn : drawnBy(plan)) {
        const bool isLand =
            kindOf(drawn) == world::InstanceKind::Terrain || kindOf(drawn) == world::InstanceKind::Exterior;
        ground += isLand ? 1 : 0;
        EXPECT_TRUE(!isLand || drawn.clipSet == 1u) << "the region of the only visit outside";
    }
    EXPECT_GT(ground, 0u);
    EXPECT_EQ(plan.spaces[0].regions, 1u);
    EXPECT_EQ(plan.spaces[0].planes, 4u) << "the exit is a rectangle, seen through a larger one";
}

// Past the side of the door: a part of the second room that has no exit.
TEST_P(GatePlannerTest, withoutAnOutsideRegionThereIsNoLandscapeAndNoSky) {
    const auto& plan = planFrom({91.2, 93.9, 1.5}, 90, first);
    ASSERT_EQ(planned.visible.visits.size(), 2u);
    ASSERT_EQ(planned.visible.visits[1].space, second);
    EXPECT_EQ(count(plan, Program::SkyPlain), 0u);
    EXPECT_EQ(count(plan, Program::SkyObjects), 0u);
    for (const Drawn& drawn : drawnBy(plan))
        EXPECT_TRUE(kindOf(drawn) == world::InstanceKind::Shell ||
                    kindOf(drawn) == world::InstanceKind::Static);
}

TEST_P(GatePlannerTest, aSingleVisitHasTheSamePlanWithEveryGate) {
    const frame::FramePlan gated = planFrom({92, 93, 1.5}, 180, first); // back to the door
    ASSERT_EQ(planned.visible.visits.size(), 1u);
    planned.gate = Gate::Ownership;
    const auto& plan = planned.planFrom({92, 93, 1.5}, 180, first);
    EXPECT_FALSE(gated.clips);
    EXPECT_EQ(gated.gate, GetParam());
    ASSERT_EQ(gated.batches.size(), plan.batches.size());
    for (std::size_t b = 0; b < plan.batches.size(); ++b) {
        EXPECT_EQ(gated.batches[b].program, plan.batches[b].program);
        EXPECT_EQ(gated.batches[b].draws, plan.batches[b].draws);
    }
}

struct PlanesPlanTest : GatePlannerTest {};
INSTANTIATE_TEST_SUITE_P(Gates, PlanesPlanTest, ::testing::Values(Gate::Planes),
                         [](const auto& gate) { return std::string(nameOf(gate.param)); });

TEST_P(PlanesPlanTest, theBatchesAreThoseOfOwnershipInNumber) {
    const std::size_t few = planFrom({92, 91, 1.5}, 0, first).batches.size();
    EXPECT_EQ(planFrom({92, 104, 1.5}, 180, world::kOutside).batches.size(), few);
    planned.gate = Gate::Ownership;
    EXPECT_EQ(planned.planFrom({92, 91, 1.5}, 0, first).batches.size(), few + 1) << "ownership has openings";
}

TEST_P(PlanesPlanTest, aShellIsClippedByItsCellsRegion) {
    const auto& plan = planFrom({92, 91, 1.5}, 0, first);
    for (const Drawn& drawn : drawnBy(plan)) {
        if (drawn.instance == planned.world.spaces[second].shell)
            EXPECT_GT(drawn.clipSet, 1u);
        if (drawn.instance == planned.world.spaces[first].shell)
            EXPECT_EQ(drawn.clipSet, 0u) << "the root has the whole picture";
    }
}

struct DepthPlanTest : GatePlannerTest {};
INSTANTIATE_TEST_SUITE_P(Gates, DepthPlanTest, ::testing::Values(Gate::Depth),
                         [](const auto& gate) { return std::string(nameOf(gate.param)); });

TEST_P(DepthPlanTest, fromInsideDepthIsClearedOnceBeforeTheFencesAndTheCells) {
    const auto& plan = planFrom({92, 91, 1.5}, 0, first);
    const auto clears = [](const frame::Stage& stage) { return stage.clearsDepth; };
    ASSERT_EQ(std::count_if(plan.stages.begin(), plan.stages.end(), clears), 1);
    const frame::Stage& stage = *std::find_if(plan.stages.begin(), plan.stages.end(), clears);
    EXPECT_EQ(stage.kind, StageKind::Ownership);
    ASSERT_EQ(stage.batchCount, 1u);
    EXPECT_EQ(plan.batches[stage.firstBatch].program, Program::Fence);
    for (std::uint32_t b = 0; b < plan.batches.size(); ++b) {
        for (const frame::gpu::DrawPiece& piece :
             drawsOpenings(plan.batches[b].program) || plan.batches[b].program == Program::SkyPlain
                 ? std::vector<frame::gpu::DrawPiece>()
                 : planned.piecesOf(plan.batches[b])) {
            const bool isShell = kindOf(shownBy(plan, piece.instance)) == world::InstanceKind::Shell;
            const bool isLand = kindOf(shownBy(plan, piece.instance)) == world::InstanceKind::Terrain;
            EXPECT_TRUE(!isShell || b > stage.firstBatch);
            EXPECT_TRUE(!isLand || b < stage.firstBatch);
        }
    }
}

TEST_P(DepthPlanTest, fromOutsideAnOpeningIsStampedBeforeItsCellsAndTheExteriorIsLast) {
    const auto& plan = planFrom({92, 104, 1.5}, 180, world::kOutside);
    std::size_t stamp = plan.batches.size(), shell = 0, exterior = 0, terrain = 0;
    for (std::size_t b = 0; b < plan.batches.size(); ++b) {
        if (plan.batches[b].program == Program::Stamp)
            stamp = b;
        if (drawsOpenings(plan.batches[b].program) || plan.batches[b].program == Program::SkyPlain)
            continue;
        for (const frame::gpu::DrawPiece& piece : planned.piecesOf(plan.batches[b])) {
            const world::InstanceKind kind = kindOf(shownBy(plan, piece.instance));
            shell = kind == world::InstanceKind::Shell ? b : shell;
            exterior = kind == world::InstanceKind::Exterior ? b : exterior;
            terrain = kind == world::InstanceKind::Terrain ? b : terrain;
        }
    }
    EXPECT_LT(terrain, stamp);
    EXPECT_LT(stamp, shell);
    EXPECT_LT(shell, exterior);
    EXPECT_EQ(count(plan, Program::Fence), 0u);
    EXPECT_TRUE(std::none_of(plan.stages.begin(), plan.stages.end(),
                             [](const frame::Stage& stage) { return stage.clearsDepth; }));
}

} // namespace
} // namespace limen::test
