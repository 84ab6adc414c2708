#include "motion/TravelReach.h"

#include <gtest/gtest.h>

namespace limen::motion {
namespace {

world::World worldWith(const std::vector<Vec3>& portals) {
    world::World world;
    for (const Vec3& at : portals) {
        world::PlacedObject placed;
        placed.origin = at;
        placed.travel = world::TravelEntry();
        world.placed.push_back(placed);
    }
    return world;
}

TEST(TravelReach, isTheNearestToTheGazeWithinThreeMetres) {
    const Vec3 eye(0, 0, 1), north(0, 1, 0);
    EXPECT_EQ(travelInReach(worldWith({{0, 2.9, 0}}), eye, north), 0u);
    EXPECT_EQ(travelInReach(worldWith({{0, 3.1, 0}}), eye, north), std::nullopt) << "too far";
    EXPECT_EQ(travelInReach(worldWith({{0, -2, 0}}), eye, north), std::nullopt) << "behind";
    EXPECT_EQ(travelInReach(worldWith({{2, 1.2, 0}}), eye, north), 0u) << "59 degrees to the side";
    EXPECT_EQ(travelInReach(worldWith({{2, 1.1, 0}}), eye, north), std::nullopt) << "61 degrees to the side";
    EXPECT_EQ(travelInReach(worldWith({{1, 1, 0}, {0.1, 2, 0}}), eye, north), 1u);
    world::World things = worldWith({{0, 1, 0}});
    things.placed[0].travel.reset();
    EXPECT_EQ(travelInReach(things, eye, north), std::nullopt) << "leads nowhere";
}

} // namespace
} // namespace limen::motion
