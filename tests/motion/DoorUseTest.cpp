#include "motion/DoorUse.h"
#include "motion/DynamicStateBuilder.h"
#include "support/MovingHut.h"

#include <gmock/gmock.h>

namespace limen::motion {
namespace {

using ::testing::ElementsAre;

// Doors of the hut: front (shut), inner (half open), pane (does not swing).
struct HutDoors {
    test::MovingHut hut;
    world::World world = hut.load();
    DoorUse use;
    world::SpaceIndex front = world::findCell(world, hut.source.id(hut.front));

    [[nodiscard]] std::vector<double> openness() const {
        std::vector<double> open;
        use.write(world, open);
        return open;
    }
    [[nodiscard]] const world::Door& door(std::size_t i) const { return world.doors[i]; }
    [[nodiscard]] std::optional<std::size_t> inReach(const Vec3& from, const Vec3& towards,
                                                     world::SpaceIndex space) const {
        return doorInReach(world, space, hut.at(from), glm::normalize(towards));
    }
};

TEST(DoorUse, doorsRestUntilTheyAreUsed) {
    HutDoors f;
    EXPECT_THAT(f.openness(), ElementsAre(0.0, 0.5, 0.0));
    f.use.pass(10.0);
    EXPECT_THAT(f.openness(), ElementsAre(0.0, 0.5, 0.0));
}

TEST(DoorUse, aDoorSwingsOpenWithinASecond_andShutAgain_andBackOnItsWay) {
    HutDoors f;
    f.use.use(f.door(0));
    EXPECT_TRUE(f.use.opens(f.door(0)));
    f.use.pass(0.25);
    EXPECT_THAT(f.openness(), ElementsAre(0.25, 0.5, 0.0));
    f.use.pass(2.0);
    EXPECT_THAT(f.openness(), ElementsAre(1.0, 0.5, 0.0));
    f.use.use(f.door(0));
    f.use.pass(0.5);
    f.use.use(f.door(0));
    f.use.pass(0.25);
    EXPECT_THAT(f.openness(), ElementsAre(0.75, 0.5, 0.0));
}

TEST(DoorUse, oneThatRestsHalfOpenShutsFirst) {
    HutDoors f;
    f.use.use(f.door(1));
    f.use.pass(1.0);
    EXPECT_THAT(f.openness(), ElementsAre(0.0, 0.0, 0.0));
}

TEST(DoorUse, allAtOnce_thenOneByOne) {
    HutDoors f;
    f.use.putAll(f.world, 1.0);
    f.use.use(f.door(1));
    f.use.pass(0.25);
    EXPECT_THAT(f.openness(), ElementsAre(1.0, 0.75, 1.0));
}

TEST(DoorUse, doorsAreKnownByNameWhenAnotherPartOfTheWorldIsLoaded) {
    HutDoors f;
    f.use.use(f.door(0));
    f.use.pass(1.0);
    world::World other = f.world;
    std::swap(other.doors[0], other.doors[2]);
    std::vector<double> open;
    f.use.write(other, open);
    EXPECT_THAT(open, ElementsAre(0.0, 0.5, 1.0));
    other.doors.clear();
    f.use.pass(1.0);
    f.use.write(other, open);
    EXPECT_TRUE(open.empty());
}

TEST(DoorUse, theMomentFollows) {
    HutDoors f;
    DynamicStateBuilder dynamicsBuilder(f.world);
    world::DynamicState dynamics;
    DynamicStateInput input;
    std::vector<double> open;
    const auto isShut = [&] {
        f.use.write(f.world, open);
        input.doors = open;
        dynamicsBuilder.build(input, dynamics);
        return dynamics.closed[f.door(0).portal] != 0;
    };
    EXPECT_TRUE(isShut());
    f.use.use(f.door(0));
    EXPECT_TRUE(isShut()) << "not yet";
    f.use.pass(0.01);
    EXPECT_FALSE(isShut());
}

TEST(DoorInReach, isTheOneLookedAt_fromEitherSide) {
    const HutDoors f;
    EXPECT_EQ(f.inReach({11.5, 11.5, 3.7}, {-1, 0, 0}, f.front), 0u);
    EXPECT_EQ(f.inReach({8.5, 11.5, 3.7}, {1, 0, -0.3}, world::kOutside), 0u);
    EXPECT_EQ(f.inReach({12.5, 11.5, 3.7}, {1, 0, 0}, f.front), 1u);
    EXPECT_EQ(f.inReach({12.0, 11.5, 3.7}, {1, 0.2, 0}, f.front), 1u) << "both are near";
    EXPECT_EQ(f.inReach({12.0, 11.5, 3.7}, {-1, 0.2, 0}, f.front), 0u);
}

TEST(DoorInReach, isNoneThatIsFarOrBehindOrElsewhereOrDoesNotSwing) {
    const HutDoors f;
    EXPECT_EQ(f.inReach({13.0, 11.5, 3.7}, {-1, 0, 0}, f.front), std::nullopt) << "3 m";
    EXPECT_EQ(f.inReach({11.0, 13.5, 3.7}, {0, 1, 0}, f.front), std::nullopt);
    EXPECT_EQ(f.inReach({11.0, 11.5, 3.7}, {-1, 0, 0}, world::findCell(f.world, f.hut.source.id(f.hut.rear))),
              std::nullopt)
        << "not of that room";
    EXPECT_EQ(f.inReach({19.5, 12.0, 3.7}, {-1, 0, 0}, world::kOutside), std::nullopt) << "a pane";
}

} // namespace
} // namespace limen::motion
