#include "PlannedWorld.h"

#include "frame/SkyParts.h"
#include "frame/ZoneScreenRects.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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
    void split() { parts = splitSky(frame, set, plan); }
    [[nodiscard]] Rects rectsOf(frame::RectRun run) const {
        return {plan.rects.begin() + run.first, plan.rects.begin() + run.first + run.count};
    }
    frame::FrameView frame;
    visibility::VisibleSet set;
    frame::FramePlan plan;
    frame::SkyParts parts;
};

int countAt(const Rects& rects, float x, float y) {
    return static_cast<int>(std::count_if(rects.begin(), rects.end(), [&](const frame::gpu::vec4& r) {
        return r.x <= x && x < r.z && r.y <= y && y < r.w;
    }));
}

TEST(SkyParts, anOpeningTakesTheCellsThatItTouches) {
    Openings openings;
    openings.addBox(0.1, 0.3, 0.2, 0.4); // columns 8 and 9, rows 10 and 11, with two pixels around it
    openings.split();
    const Rects tested = openings.rectsOf(openings.parts.tested);
    ASSERT_EQ(tested.size(), 1u);
    EXPECT_EQ(tested[0], frame::gpu::vec4(0.0f, 0.25f, 0.25f, 0.5f));
    EXPECT_EQ(openings.rectsOf(openings.parts.open).size(), 4u) << "below, above, and at both sides";
}

TEST(SkyParts, withoutAnOpeningAllIsOpen_andOneOverTheWholeWindowTakesAll) {
    Openings none;
    none.split();
    EXPECT_EQ(none.parts.tested.count, 0u);
    EXPECT_EQ(none.rectsOf(none.parts.open), Rects{frame::gpu::vec4(-1, -1, 1, 1)});
    Openings around;
    around.addBox(-1.0, -1.0, 1.0, 1.0);
    around.split();
    EXPECT_EQ(around.parts.open.count, 0u);
    EXPECT_EQ(around.rectsOf(around.parts.tested), Rects{frame::gpu::vec4(-1, -1, 1, 1)});
}

RC_GTEST_PROP(SkyParts, coverThePictureOnce_andNoOpeningIsInTheOpenPart, ()) {
    Openings openings;
    const auto ndc = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 1000.0; };
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i) {
        const double left = ndc(), low = ndc();
        const double right = std::min(left + std::abs(ndc()) / 3.0, 1.0),
                     high = std::min(low + std::abs(ndc()) / 3.0, 1.0);
        openings.addBox(left, low, right, high);
        openings.addBox(left, low, (left + right) / 2.0, high, 2); // behind the first
    }
    openings.split();
    const Rects open = openings.rectsOf(openings.parts.open),
                tested = openings.rectsOf(openings.parts.tested);
    for (std::uint32_t y = 0; y < openings.frame.height; ++y) {
        for (std::uint32_t x = 0; x < openings.frame.width; ++x) {
            const float atX = (2.0f * static_cast<float>(x) + 1.0f) / 320.0f - 1.0f,
                        atY = (2.0f * static_cast<float>(y) + 1.0f) / 180.0f - 1.0f;
            const int openHere = countAt(open, atX, atY);
            RC_ASSERT(openHere + countAt(tested, atX, atY) == 1);
            for (std::size_t i = 1; i < openings.set.visits.size() && openHere > 0; ++i) {
                const auto rect = rectAround(openings.frame, openings.set, openings.set.visits[i]);
                RC_ASSERT(countAt({rect}, atX, atY) == 0);
            }
        }
    }
}

struct PlannedSky : ::testing::Test {
    Rooms rooms;
    PlannedWorld planned{rooms.world};
    /// Of the plain sky's batches: whether they take the ownership test, and have rectangles.
    std::vector<std::pair<bool, bool>> skyFrom(const Vec3& eye, double yaw, world::SpaceIndex root,
                                               bool fewTests) {
        static_cast<void>(planned.planFrom(eye, yaw, root));
        planned.view.fewTests = planned.view.fillsVoids = fewTests;
        planned.planner.plan(planned.view, planned.visible, planned.plan);
        std::vector<std::pair<bool, bool>> found;
        for (const frame::Batch& batch : planned.plan.batches)
            if (batch.program == Program::SkyPlain)
                found.emplace_back(batch.gated, batch.count > 0);
        return found;
    }
};
using Found = std::vector<std::pair<bool, bool>>;

TEST_F(PlannedSky, isInTwoPartsForAnEyeOutside) {
    const world::SpaceIndex second = world::findCell(planned.world, rooms.world.id(rooms.second));
    EXPECT_EQ(skyFrom({92, 104, 1.5}, 180, world::kOutside, true), (Found{{false, true}, {true, true}}));
    EXPECT_EQ(skyFrom({92, 104, 1.5}, 180, world::kOutside, false), (Found{{true, false}}))
        << "every fragment tests";
    EXPECT_EQ(skyFrom({92, 104, 1.5}, 0, world::kOutside, true), (Found{{false, false}})) << "one visit";
    EXPECT_EQ(skyFrom({92, 96, 1.5}, 0, second, true), (Found{{true, false}})) << "through the exit";
}

} // namespace
} // namespace limen::test
