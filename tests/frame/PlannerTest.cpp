#include "PlannedWorld.h"

#include <gtest/gtest.h>

#include <map>

namespace limen::test {
namespace {

using frame::Program;
using frame::StageKind;

struct PlannerTest : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    world::SpaceIndex first = world::findCell(planned.world, rooms.world.id(rooms.first));
    world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));

    /// Number of draws of each instance by the batches of one program.
    [[nodiscard]] std::map<std::uint32_t, int> drawsOf(const frame::FramePlan& plan, Program program) const {
        std::map<std::uint32_t, int> draws;
        for (const frame::Batch& batch : plan.batches) {
            if (batch.program == program)
                for (const frame::gpu::DrawPiece& piece : planned.piecesOf(batch))
                    ++draws[piece.instance];
        }
        return draws;
    }
};

TEST_F(PlannerTest, hasEveryStageOnceInOrder) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    ASSERT_EQ(plan.stages.size(), frame::kStageCount);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
        EXPECT_EQ(plan.stages[i].kind, static_cast<StageKind>(i));
        EXPECT_EQ(plan.stages[i].firstBatch, next);
        next += plan.stages[i].batchCount;
    }
    EXPECT_EQ(next, plan.batches.size());
}

TEST_F(PlannerTest, drawsTheShellOfEveryCellSeenAndEachInstanceOnce) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    const auto draws = drawsOf(plan, Program::Opaque);
    for (const visibility::SeenSpace& seen : planned.visible.seen)
        EXPECT_TRUE(seen.space == world::kOutside || draws.contains(planned.world.spaces[seen.space].shell));
    for (const auto& [instance, count] : draws)
        EXPECT_EQ(count, 1) << instance;
    EXPECT_EQ(planned.visible.visits.size(), 3u) << "room, room, outside";
}

TEST_F(PlannerTest, leavesOutSpacesThatNoVisitSees) {
    const auto& plan = planned.planFrom({92, 93, 1.5}, 180, first); // back to the door
    EXPECT_EQ(planned.visible.visits.size(), 1u);
    const auto draws = drawsOf(plan, Program::Opaque);
    EXPECT_FALSE(draws.contains(planned.world.spaces[second].shell));
    EXPECT_TRUE(drawsOf(plan, Program::Terrain).empty()) << "no outside region: no terrain";
    EXPECT_EQ(plan.stages[static_cast<std::size_t>(StageKind::Sky)].batchCount, 0u) << "and no sky";
    EXPECT_EQ(plan.stages[static_cast<std::size_t>(StageKind::Ownership)].batchCount, 0u)
        << "one owner: the target needs no writes";
    for (const frame::Batch& batch : plan.batches)
        EXPECT_FALSE(batch.gated);
}

TEST_F(PlannerTest, gatesMembersOfSeveralZonesWhereThereAreSeveralVisits) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    std::size_t ungated = 0, gated = 0;
    for (const frame::Batch& batch : plan.batches) {
        for (std::uint32_t r = batch.first; batch.program == Program::Opaque && r < batch.first + batch.count;
             ++r) {
            EXPECT_TRUE(batch.gated) << "the variant with the ownership test";
            for (const frame::gpu::DrawPiece& piece : planned.piecesOf(plan.runs[r])) {
                const bool isOfOne = planned.world.instances[piece.instance].memberCount == 1;
                EXPECT_TRUE(isOfOne || plan.runs[r].gated);
                ++(plan.runs[r].gated ? gated : ungated);
            }
        }
    }
    EXPECT_GT(ungated, 0u);
    EXPECT_GT(gated, 0u);
}

// The occluders come first.
TEST_F(PlannerTest, wallsAndGroundComeBeforeAllElse) {
    const auto& plan = planned.planFrom({92, 104, 1.5}, 180, world::kOutside);
    std::size_t walls = 0;
    for (std::uint32_t b = 0; b < plan.batches.size(); ++b) {
        const frame::Batch& batch = plan.batches[b];
        if (batch.program == Program::Ownership || batch.program == Program::SkyPlain ||
            batch.program == Program::SkyObjects)
            continue;
        for (const frame::gpu::DrawPiece& piece : planned.piecesOf(batch)) {
            const world::InstanceKind kind = planned.world.instances[piece.instance].kind;
            const bool isFirst = kind == world::InstanceKind::Shell ||
                                 kind == world::InstanceKind::Exterior ||
                                 kind == world::InstanceKind::Terrain;
            const bool isSolid = batch.program == Program::Opaque || batch.program == Program::Terrain;
            EXPECT_EQ(b < plan.firstOccludee, isFirst && isSolid);
            walls += b < plan.firstOccludee ? 1 : 0;
        }
    }
    EXPECT_GT(walls, 2u);
}

/// Numbers of shells among the pieces of batches that may have some, and of all pieces of the other batches.
struct ShellCounts {
    std::size_t shells = 0, others = 0;
};
ShellCounts shellsOf(const PlannedWorld& planned, const frame::FramePlan& plan, Program program) {
    ShellCounts counts;
    for (const frame::Batch& batch : plan.batches) {
        if (batch.program != program)
            continue;
        for (const frame::gpu::DrawPiece& piece : planned.piecesOf(batch)) {
            const bool isShell = planned.world.instances[piece.instance].kind == world::InstanceKind::Shell;
            EXPECT_TRUE(batch.shells || !isShell) << "programs without shells draw none";
            counts.shells += isShell ? 1 : 0;
            counts.others += batch.shells ? 0 : 1;
        }
    }
    return counts;
}

TEST_F(PlannerTest, aBatchSaysWhetherItMayHaveShells) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    const ShellCounts opaque = shellsOf(planned, plan, Program::Opaque);
    EXPECT_GT(opaque.shells, 1u) << "the rooms";
    EXPECT_GT(opaque.others, 1u) << "the tables";
    EXPECT_EQ(shellsOf(planned, plan, Program::Terrain).shells, 0u);
    for (const frame::Batch& batch : plan.batches)
        EXPECT_TRUE(batch.program != Program::CutOut || !batch.shells) << "no shell has cut-outs";
}

TEST(ShellsWithCutOuts, areInABatchThatSaysSo) {
    TestWorld source;
    source.solid("grate", 0xFF808080, dat::Surface::kBase1ClipMap);
    const TestWorld::Cell room = source.addBox({90, 90, 0}, {94, 94, 3}, "grate");
    PlannedWorld planned(source);
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, world::findCell(planned.world, source.id(room)));
    EXPECT_GT(shellsOf(planned, plan, Program::CutOut).shells, 0u);
    for (const frame::Batch& batch : plan.batches)
        EXPECT_TRUE(batch.program != Program::CutOut || batch.shells);
}

TEST_F(PlannerTest, aBatchsRunsAddUp) {
    for (const Vec3& eye : {Vec3(92, 91, 1.5), Vec3(92, 104, 1.5)}) {
        const auto& plan = planned.planFrom(eye, 180, eye.y < 98 ? first : world::kOutside);
        std::uint32_t triangles = 0;
        for (const frame::Batch& batch : plan.batches) {
            if (batch.program == Program::Ownership || batch.program == Program::SkyPlain)
                continue;
            const auto pieces = planned.piecesOf(batch);
            EXPECT_EQ(pieces.size(), batch.draws);
            std::uint32_t indices = 0;
            for (std::uint32_t r = batch.first; r < batch.first + batch.count; ++r) {
                indices += plan.runs[r].indexCount;
                EXPECT_GT(plan.runs[r].pieceCount, 0u);
                EXPECT_EQ(plan.runs[r].indicesBefore, planned.pieces[plan.runs[r].firstPiece].indicesBefore);
            }
            for (const frame::gpu::DrawPiece& piece : pieces) {
                indices -= 3 * piece.triangles;
                triangles += piece.triangles;
            }
            EXPECT_EQ(indices, 0u);
        }
        EXPECT_EQ(triangles, plan.counts.triangles);
        EXPECT_EQ(plan.counts.instancesTested, plan.counts.instancesDrawn + plan.counts.instancesCulled);
    }
}

TEST_F(PlannerTest, voidsAreFilledWhereSeveralVisitsMeet) {
    Vec3 eye(92, 96, 1.5);
    const auto hasPlainSky = [&](double yaw, bool fillsVoids) {
        static_cast<void>(planned.planFrom(eye, yaw, second));
        planned.view.fillsVoids = fillsVoids;
        planned.planner.plan(planned.view, planned.visible, planned.plan);
        return std::any_of(planned.plan.batches.begin(), planned.plan.batches.end(),
                           [](const frame::Batch& batch) { return batch.program == Program::SkyPlain; });
    };
    EXPECT_FALSE(hasPlainSky(180, false));
    EXPECT_EQ(planned.visible.visits.size(), 2u) << "the rooms, not the outside";
    EXPECT_TRUE(hasPlainSky(180, true));
    EXPECT_FALSE(hasPlainSky(90, true)) << "one visit has no edges";
    EXPECT_EQ(planned.visible.visits.size(), 1u);
    EXPECT_TRUE(hasPlainSky(0, false)) << "towards the exit";
    const world::Portal& portal = planned.world.portals[planned.world.spaces[second].firstPortal];
    for (const double height : {5e-4, 2e-3}) { // beside the opening
        eye = Vec3(97, 96, 1.5);
        eye -= portal.plane.n * (portal.plane.signedDistance(planned.origin + eye) - height);
        EXPECT_EQ(hasPlainSky(90, true), height < 1e-3) << "cracks between close triangles";
        EXPECT_EQ(planned.visible.visits.size(), 1u);
        EXPECT_FALSE(hasPlainSky(90, false));
    }
}

TEST_F(PlannerTest, visitsMirrorTheTree) {
    const auto& plan = planned.planFrom({92, 91, 1.5}, 0, first);
    ASSERT_EQ(plan.visits.size(), planned.visible.visits.size());
    EXPECT_EQ(plan.visits[0].parent, frame::gpu::kNoVisit);
    EXPECT_EQ(plan.visits[0].entryPlane, frame::gpu::vec4(0, 0, 0, 1)) << "all points are beyond the root's";
    for (std::uint32_t i = 1; i < plan.visits.size(); ++i) {
        EXPECT_LT(plan.visits[i].parent, i);
        EXPECT_EQ(plan.visits[i].zone, planned.visible.visits[i].zone);
    }
}

TEST_F(PlannerTest, batchesDependOnTheStagesAlone) {
    const auto batches = [&](const Vec3& eye, double yaw, world::SpaceIndex root) {
        std::vector<std::pair<Program, bool>> list;
        for (const frame::Batch& batch : planned.planFrom(eye, yaw, root).batches)
            list.emplace_back(batch.program, batch.gated);
        return list;
    };
    EXPECT_EQ(batches({92, 91, 1.5}, 0, first), batches({92, 104, 1.5}, 180, world::kOutside));
    EXPECT_EQ(batches({92, 91, 1.5}, 180, first), batches({92, 93, 1.5}, 180, first));
}

TEST_F(PlannerTest, hasNoFarPlane) {
    const auto& plan = planned.planFrom({92, 104, 1.5}, 0, world::kOutside);
    float before = 2.0f;
    for (const float metres : {0.5f, 100.0f, 3999.0f, 4001.0f, 1e6f, 1e9f}) {
        const Vec3f way = Vec3f(planned.view.view.forward) * metres;
        const frame::gpu::vec4 clip = plan.constants.clipFromEye * frame::gpu::vec4(way, 1.0f);
        const float depth = clip.z / clip.w; // 1 at the near plane
        EXPECT_GT(depth, 0.0f) << metres << " m are not clipped";
        EXPECT_LT(depth, before);
        before = depth;
    }
}

TEST_F(PlannerTest, theEyeIsTwoFloatsAndBlocksWholeMultiples) {
    const Vec3 eye(92.123456789, 91.987654321, 1.5);
    const auto& plan = planned.planFrom(eye, 0, first);
    const Vec3 sum = Vec3(plan.constants.eyeHigh) + Vec3(plan.constants.eyeLow);
    EXPECT_LT(glm::length(sum - eye), 1e-11);
    for (const auto& block : plan.blocks) {
        EXPECT_EQ(std::fmod(block.x, 192.0f), 0.0f);
        EXPECT_EQ(std::fmod(block.y, 192.0f), 0.0f);
    }
}

} // namespace
} // namespace limen::test
