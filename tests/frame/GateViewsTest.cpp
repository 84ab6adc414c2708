#include "PlannedWorld.h"

#include "frame/gates/GateViews.h"

#include <algorithm>

namespace limen::test {
namespace {

using frame::LandscapeStep;
using visibility::Visit;

Visit visit(std::uint32_t space, std::uint32_t parent, std::uint32_t depth, std::uint32_t portal = 0) {
    Visit made;
    made.space = made.zone = space;
    made.parent = parent;
    made.depth = depth;
    made.portal = portal;
    return made;
}

TEST(GateViews, farToNearPutsEveryVisitAfterThoseBeyondIt) {
    // 0 ─ 1 ─ 2
    //   │   └ 3
    //   └ 4
    const std::vector<Visit> visits{visit(1, 9, 0), visit(2, 0, 1), visit(3, 1, 2), visit(4, 1, 2),
                                    visit(5, 0, 1)};
    EXPECT_EQ(frame::farToNear(visits), (std::vector<std::uint32_t>{2, 3, 1, 4, 0}));
}

TEST(GateViews, aSpaceStandsWhereItsLastVisitIs) {
    const std::vector<Visit> visits{visit(1, 9, 0), visit(2, 0, 1), visit(3, 1, 2), visit(2, 0, 1)};
    EXPECT_EQ(frame::spacesOf(visits, frame::farToNear(visits)), (std::vector<std::uint32_t>{3, 2, 1}));
}

/// A house of one room with a door to the north and a window to the south, beside a house without openings.
struct Houses {
    TestWorld world;
    TestWorld::Cell room = world.addBox({90, 90, 0.1}, {94, 94, 3}, "brown");
    Houses() {
        world.setFlatTerrain(world.home(), 0);
        const auto door = world.openOutside(room, rectangle({91, 94, 0.1}, {93, 94, 2}));
        const auto window = world.openOutside(room, rectangle({91, 90, 1}, {93, 90, 2}));
        world.addBuilding(boxExterior({100, 90, 0}, {104, 94, 3}), {});
        world.addBuilding(boxExterior({90, 90, 0}, {94, 94, 3}), {door, window});
    }
};

struct DepthViewsTest : ::testing::Test {
    Houses houses;
    PlannedWorld planned{houses.world};
    world::SpaceIndex room = world::findCell(planned.world, houses.world.id(houses.room));
    frame::Exteriors exteriors = frame::exteriorsOf(planned.world);

    frame::DepthViews viewsFrom(const Vec3& local, double yaw, world::SpaceIndex root) {
        planned.gate = frame::Gate::Depth;
        planned.planFrom(local, yaw, root);
        return frame::depthViews(planned.world, exteriors, planned.visible.visits, planned.view.view.eye);
    }
    [[nodiscard]] const Visit& at(std::uint32_t visit) const { return planned.visible.visits[visit]; }
};

TEST_F(DepthViewsTest, anOpeningBelongsToTheExteriorAroundIt) {
    const auto exterior = [&](std::uint32_t portal) {
        return planned.world.instances[exteriors.ofOpening[portal]];
    };
    std::size_t openings = 0;
    for (std::uint32_t p = 0; p < planned.world.portals.size(); ++p) {
        if (planned.world.portals[p].space != world::kOutside) {
            EXPECT_EQ(exteriors.ofOpening[p], world::kNone);
            continue;
        }
        ++openings;
        EXPECT_NEAR(exterior(p).bounds.centre.x - planned.origin.x, 92.0, 0.5);
    }
    EXPECT_EQ(openings, 2u);
    EXPECT_EQ(exteriors.all.size(), 2u);
}

TEST_F(DepthViewsTest, fromOutsideABuildingIsStampedAndTheLandscapeIsNotRepeated) {
    const frame::DepthViews views = viewsFrom({92, 110, 1.5}, 180, world::kOutside);
    EXPECT_EQ(views.landscape, std::vector<std::uint32_t>{0}) << "not again through door and window";
    EXPECT_GT(planned.visible.visits.size(), 2u) << "the flood goes on through the window";
    ASSERT_EQ(views.buildings.size(), 1u);
    ASSERT_EQ(views.buildings[0].openings.size(), 1u);
    EXPECT_EQ(at(views.buildings[0].openings[0]).space, room);
    EXPECT_EQ(views.buildings[0].visits, views.buildings[0].openings);
    EXPECT_TRUE(views.inside.empty());
    EXPECT_FALSE(views.clearsDepth());
}

TEST_F(DepthViewsTest, fromInsideTheOpeningsAreFences) {
    const frame::DepthViews views = viewsFrom({92, 91, 1.5}, 0, room);
    EXPECT_EQ(views.inside, std::vector<std::uint32_t>{0});
    ASSERT_EQ(views.fences.size(), 1u);
    EXPECT_EQ(at(views.fences[0]).space, world::kOutside);
    EXPECT_EQ(views.landscape, views.fences);
    EXPECT_TRUE(views.clearsDepth());
}

TEST_F(DepthViewsTest, withoutAViewOfTheOutsideNothingOfItIsDrawn) {
    const frame::DepthViews views = viewsFrom({91.9, 92, 1.5}, 90, room);
    EXPECT_TRUE(views.landscape.empty());
    EXPECT_TRUE(views.steps.empty());
    EXPECT_FALSE(views.clearsDepth());
}

// A building that is not seen into must not be punched by the stamps of one behind it.
TEST_F(DepthViewsTest, buildingsOfABlockGoFromFarToNear) {
    const auto kindsFrom = [&](const Vec3& eye, double yaw) {
        std::vector<LandscapeStep::Kind> kinds;
        for (const LandscapeStep& step : viewsFrom(eye, yaw, world::kOutside).steps)
            if (step.kind != LandscapeStep::Kind::Block)
                kinds.push_back(step.kind);
        return kinds;
    };
    using Kind = LandscapeStep::Kind;
    EXPECT_EQ(kindsFrom({92, 110, 1.5}, 180), (std::vector{Kind::Exterior, Kind::Building}));
    EXPECT_EQ(kindsFrom({104, 110, 1.5}, 210), (std::vector{Kind::Building, Kind::Exterior}));
}

TEST_F(DepthViewsTest, stepsGoFromFarToNearWithABuildingAfterItsBlock) {
    const frame::DepthViews views = viewsFrom({92, 110, 1.5}, 180, world::kOutside);
    const Vec3 eye = planned.view.view.eye;
    double last = 1e300;
    std::vector<int> seen(planned.world.blocks.size(), 0);
    for (std::size_t i = 0; i < views.steps.size(); ++i) {
        const LandscapeStep& step = views.steps[i];
        if (step.kind != LandscapeStep::Kind::Block) {
            EXPECT_EQ(last, 0.0) << "the buildings are in the eye's block, the last one";
            continue;
        }
        ++seen[step.index];
        const Vec3 low = planned.world.blocks[step.index].origin();
        const double x = std::max({low.x - eye.x, 0.0, eye.x - low.x - world::kBlockSize});
        const double y = std::max({low.y - eye.y, 0.0, eye.y - low.y - world::kBlockSize});
        EXPECT_LE(std::hypot(x, y), last);
        last = std::hypot(x, y);
    }
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
    EXPECT_EQ(last, 0.0) << "the eye's own block is the nearest";
}

} // namespace
} // namespace limen::test
