#include "frame/TransparentRuns.h"

#include "frame/PlanBatches.h"

#include <gmock/gmock.h>

namespace limen::test {
namespace {

using testing::ElementsAre;

/// The first pieces of three runs in the order in which they are drawn. The third is a large sphere: its middle is farther
/// away than the second's from the origin, its nearest point nearer.
std::vector<std::uint32_t> orderFrom(const Vec3& eye) {
    frame::FramePlan plan;
    frame::beginStage(plan, frame::StageKind::Transparent);
    frame::beginBatch(frame::Program::Blended, false, plan);
    frame::TransparentRuns runs;
    runs.addRun({10, 1, 0, 3, false}, 1, {{0, 2, 0}, 0.5}, eye);
    runs.addRun({20, 1, 0, 3, false}, 2, {{0, 6, 0}, 0.5}, eye);
    runs.addRun({30, 1, 0, 3, false}, 3, {{0, 8, 0}, 4.0}, eye);
    runs.write(false, plan);
    std::vector<std::uint32_t> order;
    for (const frame::PieceRun& run : plan.runs)
        order.push_back(run.firstPiece);
    return order;
}

TEST(TransparentRuns, goFromFarToNearByTheirNearestPoints_whateverTheirInsertion) {
    EXPECT_THAT(orderFrom({0, 0, 0}), ElementsAre(20, 30, 10));
    EXPECT_THAT(orderFrom({0, 20, 0}), ElementsAre(10, 20, 30));
}

} // namespace
} // namespace limen::test
