#include "PlannedWorld.h"

#include "world/DynamicState.h"

#include <set>

namespace limen::test {
namespace {

using frame::Occlusion;

/// A house of one room on a plain: a door to the south and one to the north, in line. Its floor is 2 m below the plain. Tables
/// south and north of it, and one in the room. In the north-east, a hill.
struct House {
    TestWorld world;
    std::uint32_t table = world.addModel(insideOut(boxWalls({-0.2, -0.2, 0}, {0.2, 0.2, 0.8}, "red")));
    House() {
        world.setFlatTerrain(world.home(), 0);
        const auto room = world.addBox({86, 90, -2}, {98, 98, 4}, "brown");
        const auto south = world.openOutside(room, rectangle({91, 90, 0.1}, {93, 90, 2}));
        const auto north = world.openOutside(room, rectangle({91, 98, 0.1}, {93, 98, 2}));
        world.addBuilding(boxExterior({86, 90, 0}, {98, 98, 4}), {south, north});
        for (std::size_t i = 0; i < kInRoom; ++i)
            world.addObject(table, frameAt(kTables[i]));
        world.addStatic(room, table, frameAt(kTables[kInRoom]));
        world.terrain(world.home()).heights[6 * 9 + 6] = 15; // at (144, 144): 30 m
    }
    static constexpr std::size_t kBefore = 0, kThroughDoors = 1, kBehindWall = 2, kBeside = 3,
                                 kBehindHill = 4, kInRoom = 5;
    static inline const std::vector<Vec3> kTables{{92, 80, 0},   {92, 108, 0},  {96, 104, 0},
                                                  {104, 108, 0}, {186, 186, 0}, {92, 97, -2}};
};

struct Occluders : ::testing::Test {
    /// Numbers of the tables that a plan draws.
    std::set<std::size_t> tablesFrom(const Vec3& eye, double yaw, world::SpaceIndex root,
                                     Occlusion occlusion) {
        planned.occlusion = occlusion;
        static_cast<void>(planned.planFrom(eye, yaw, root));
        return tables();
    }
    /// Of the last plan.
    [[nodiscard]] std::set<std::size_t> tables() const {
        std::set<std::size_t> drawn;
        for (const frame::Batch& batch : planned.plan.batches)
            if (batch.program == frame::Program::Opaque)
                for (const frame::gpu::DrawPiece& piece : planned.piecesOf(batch)) {
                    const world::Instance& instance = planned.world.instances[piece.instance];
                    for (std::size_t i = 0; i < House::kTables.size(); ++i)
                        if (glm::distance(Vec3(instance.origin), House::kTables[i]) < 0.01)
                            drawn.insert(i);
                }
        return drawn;
    }
    House house;
    PlannedWorld planned{house.world};
};

using Tables = std::set<std::size_t>;

TEST_F(Occluders, serveNoPlanThatLeavesOutARule) {
    const Vec3 eye(92, 70, 1.5);
    ASSERT_FALSE(tablesFrom(eye, 0, world::kOutside, Occlusion::Always).contains(House::kBehindWall));
    planned.view.rules.viewcone = false; // then an instance is tested against one visit alone
    planned.planner.plan(planned.view, planned.visible, planned.plan);
    EXPECT_TRUE(tables().contains(House::kBehindWall));
}

TEST_F(Occluders, leaveOutWhatWallsHide_unlessItShowsThroughTheHouse) {
    const Vec3 eye(92, 70, 1.5);
    const Tables all = tablesFrom(eye, 0, world::kOutside, Occlusion::Off);
    EXPECT_TRUE(all.contains(House::kBehindWall));
    const Tables drawn = tablesFrom(eye, 0, world::kOutside, Occlusion::Always);
    EXPECT_TRUE(drawn.contains(House::kBefore));
    EXPECT_TRUE(drawn.contains(House::kThroughDoors))
        << "hidden in the root, but seen in the visit behind both doors";
    EXPECT_TRUE(drawn.contains(House::kBeside));
    EXPECT_FALSE(drawn.contains(House::kBehindWall));
}

TEST_F(Occluders, leaveOutWhatLandHides) {
    const Vec3 eye(104, 104, 1.5);
    EXPECT_TRUE(tablesFrom(eye, 45, world::kOutside, Occlusion::Off).contains(House::kBehindHill));
    EXPECT_FALSE(tablesFrom(eye, 45, world::kOutside, Occlusion::Always).contains(House::kBehindHill));
    EXPECT_TRUE(
        tablesFrom({144, 144, 31.5}, 45, world::kOutside, Occlusion::Always).contains(House::kBehindHill))
        << "from the top of the hill";
}

TEST_F(Occluders, countForAnEyeOutsideAlone) {
    const Vec3 eye(92, 92, 1.5);
    const world::SpaceIndex room = 1;
    ASSERT_NE(room, world::kOutside);
    EXPECT_EQ(tablesFrom(eye, 0, room, Occlusion::Always), tablesFrom(eye, 0, room, Occlusion::Off));
}

TEST_F(Occluders, hideNothingFromAnEyePastItsDoor) {
    const Vec3 eye(92, 90.00001, 1.5);
    const Tables all = tablesFrom(eye, 0, world::kOutside, Occlusion::Off);
    ASSERT_NE(planned.visible.visits[0].space, world::kOutside) << "rays begin in the room";
    EXPECT_TRUE(all.contains(House::kInRoom));
    EXPECT_EQ(tablesFrom(eye, 0, world::kOutside, Occlusion::Always), all);
}

TEST_F(Occluders, pauseAfterAFrameInWhichTheyHideLittle) {
    const Vec3 eye(92, 70, 1.5);
    EXPECT_FALSE(tablesFrom(eye, 0, world::kOutside, Occlusion::IfWorthwhile).contains(House::kBehindWall))
        << "more than a sixth: the next frame has them, too";
    EXPECT_EQ(tablesFrom({92, 84, 1.5}, 180, world::kOutside, Occlusion::IfWorthwhile),
              Tables{House::kBefore})
        << "the house is behind the eye";
    int without = 0;
    while (without < 100 &&
           tablesFrom(eye, 0, world::kOutside, Occlusion::IfWorthwhile).contains(House::kBehindWall))
        ++without;
    EXPECT_EQ(without, 15);
    EXPECT_FALSE(tablesFrom(eye, 0, world::kOutside, Occlusion::Always).contains(House::kBehindWall));
}

TEST_F(Occluders, leaveOutDynamicInstancesToo) {
    const auto planWith = [&](Occlusion occlusion) {
        world::DynamicState dynamics;
        for (const Vec3& place : {House::kTables[House::kBefore], House::kTables[House::kBehindWall]}) {
            world::Instance instance = planned.world.instances.back();
            instance.kind = world::InstanceKind::Dynamic;
            instance.bounds = {planned.origin + place, 1.0};
            instance.setMembers(static_cast<std::uint32_t>(dynamics.members.size()), 1);
            instance.placedIn = world::kOutside;
            dynamics.members.push_back(world::kOutside);
            dynamics.instances.push_back(instance);
        }
        world::listBySpace(planned.world.spaces.size(), dynamics);
        planned.planFrom({92, 70, 1.5}, 0, world::kOutside); // floods
        planned.view.occlusion = occlusion;
        planned.planner.plan(planned.view, dynamics, planned.visible, planned.plan);
        return planned.plan.dynamicInstances.size();
    };
    EXPECT_EQ(planWith(Occlusion::Off), 2u);
    EXPECT_EQ(planWith(Occlusion::Always), 1u);
}

} // namespace
} // namespace limen::test
