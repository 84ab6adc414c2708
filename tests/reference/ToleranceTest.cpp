// The tolerances that are part of the rule (docs/ray-rule.md), each from both sides of its bound.
#include "reference/DynamicStateMaker.h"

namespace limen::test {
namespace {

using reference::Answer;

struct Doorway : ::testing::Test {
    TwoRooms rooms;
    /// A closed room far away, with a two-sided panel of half a metre each way that dynamic states copy.
    TestWorld::Cell store = rooms.world.addBox({100, 100, 10}, {104, 104, 14});
    std::uint32_t model = rooms.world.addModel(bothWays(panel(0.25, "pink", false)));
    std::unique_ptr<TracedWorld> traced;
    world::SpaceIndex west = 0, east = 0;
    void SetUp() override {
        rooms.world.addStatic(store, model, frameAt({102, 102, 12}));
        traced = std::make_unique<TracedWorld>(rooms.world);
        west = traced->space(rooms.world.id(rooms.west));
        east = traced->space(rooms.world.id(rooms.east));
    }
    /// The answer for a ray along ±x, with a panel at x that is a member of one room only.
    Answer withPanel(double x, world::SpaceIndex member, world::SpaceIndex root, std::uint32_t& panelId) {
        DynamicStateMaker dynamics(traced->world());
        panelId = dynamics.add(staticOf(traced->world(), model), {x, 2, 11}, {member});
        traced->scene().setDynamics(dynamics.build());
        return root == west ? traced->trace(west, {1, 2, 11}, {1, 0, 0})
                            : traced->trace(east, {7, 2, 11}, {-1, 0, 0});
    }
};

TEST_F(Doorway, anEyeInThePlaneAndInsideTheOpeningLeavesIfTheRayPointsOutward) {
    for (const double off :
         {-0.00019, -0.0001, -0.0000006, -0.0000004, 0.0, 0.0000004, 0.0000006, 0.0001, 0.00019}) {
        SCOPED_TRACE(off);
        const Vec3 eye(4 + off, 2, 11);
        const bool isPassed = off > 0.0000005; // then the eye begins in the east
        const Answer out = traced->trace(west, eye, {1, 0.1, 0});
        EXPECT_EQ(out.space, east);
        EXPECT_NEAR(out.t, 4 - off, 1e-9);
        EXPECT_EQ(out.spacesVisited, isPassed ? 1u : 2u);
        const Answer in = traced->trace(west, eye, {-1, 0.1, 0});
        EXPECT_EQ(in.space, west);
        EXPECT_NEAR(in.t, 4 + off, 1e-9);
        EXPECT_EQ(in.spacesVisited, isPassed ? 2u : 1u);
        const Answer other = traced->trace(east, eye, {-1, 0.1, 0});
        EXPECT_EQ(other.space, west) << "the same eye said to be in the other room";
        EXPECT_NEAR(other.t, 4 + off, 1e-9);
        // Almost along the plane, which is crossed far away or never: in it out at once, else never.
        EXPECT_EQ(traced->trace(west, eye, {1e-7, 1, 0}).space, off < -0.0000005 ? west : east);
        EXPECT_EQ(traced->trace(west, eye, {-1e-7, 1, 0}).space, isPassed ? east : west);
    }
}

TEST_F(Doorway, beyondTheToleranceAnEyeBehindThePlaneDoesNotLeave) {
    const Answer answer = traced->trace(west, {4.00021, 2, 11}, {1, 0, 0});
    EXPECT_EQ(answer.id, 0u) << "the western room has no surface there";
    EXPECT_EQ(answer.spacesVisited, 1u);
    EXPECT_EQ(traced->trace(west, {3.99979, 2, 11}, {1e-7, 1, 0}).space, west)
        << "before the plane it is crossed where it is crossed";
}

TEST_F(Doorway, anEyeInThePlaneButBesideTheOpeningDoesNotLeave) {
    const Answer answer = traced->trace(west, {4.0, 3.0, 11}, {-1, 0, 0});
    EXPECT_NEAR(answer.t, 4.0, 1e-9);
    EXPECT_NE(traced->trace(west, {4.0, 2.51, 11}, {1, -0.01, 0}).space, east);
    EXPECT_EQ(traced->trace(west, {4.0, 2.5, 11}, {1, -0.01, 0}).space, east)
        << "edges belong to the opening";
}

TEST_F(Doorway, aRayNeverGoesStraightBackThroughTheOpeningItCameBy) {
    // The way back is tilted by half a degree, so that a ray that slants by less crosses both polygons
    // outward.
    world::World world = loadTestWorld(rooms.world, {.radius = 1});
    const world::SpaceIndex a = world::findCell(world, rooms.world.id(rooms.west)),
                            b = world::findCell(world, rooms.world.id(rooms.east));
    world::Portal& back = world.portals[world.spaces[b].firstPortal];
    const double tilt = 0.01;
    const Vec3 middle = toGlobal(rooms.world, {4, 2, 11});
    back.plane.n = glm::normalize(Vec3(std::cos(tilt), -std::sin(tilt), 0));
    back.plane.d = -glm::dot(back.plane.n, middle);
    const reference::Scene scene(world);
    const Vec3 eye = toGlobal(rooms.world, {3.9999, 1.6, 11});
    const Vec3 along(0.0005, 1, 0);
    ASSERT_LT(glm::dot(back.plane.n, along), 0.0) << "else the test means nothing";
    ASSERT_GT(back.plane.signedDistance(eye), 0.0);
    const Answer answer = scene.trace(a, {eye, along, 0.02});
    EXPECT_EQ(answer.space, b);
    EXPECT_EQ(answer.spacesVisited, 2u);
    EXPECT_NEAR(answer.t, 2.4, 1e-6);
}

TEST_F(Doorway, aWallAMicrometreAwayIsMetAndOneInWhosePlaneTheEyeIsIsNot) {
    for (const double away : {1e-6, 1e-5, 1e-3, 0.019}) {
        const Answer answer = traced->trace(west, {4 - away, 3.5, 11}, {1, 0, 0}, kDefaultNearPlane);
        EXPECT_TRUE(traced->isShell(answer.id, west)) << away;
        EXPECT_NEAR(answer.t, away, 1e-9);
    }
    EXPECT_EQ(traced->trace(west, {4 - 3e-7, 3.5, 11}, {1, 0, 0}, kDefaultNearPlane).id, 0u);
}

TEST_F(Doorway, surfacesBelowTheNearPlaneAreNotMetAndPortalsAre) {
    std::uint32_t id = 0;
    EXPECT_EQ(withPanel(1.0201, west, west, id).id, id);
    EXPECT_EQ(withPanel(1.0199, west, west, id).space, east);
    EXPECT_NEAR(withPanel(1.0199, west, west, id).t, 7.0, 1e-9);
    EXPECT_EQ(traced->trace(west, {3.999, 2, 11}, {1, 0, 0}).space, east) << "a portal 1 mm away";
}

TEST_F(Doorway, aSurfaceWithinATenthOfAMillimetreOfThePlaneIsMetFromBothSides) {
    std::uint32_t id = 0;
    for (const world::SpaceIndex member : {west, east}) {
        for (const world::SpaceIndex root : {west, east}) {
            for (const double off : {-0.00015, 0.0, 0.00015}) {
                SCOPED_TRACE(::testing::Message()
                             << "member " << member << " root " << root << " off " << off);
                const Answer answer = withPanel(4 + off, member, root, id);
                EXPECT_TRUE(answer.id == id || answer.id == id + 1);
                EXPECT_NEAR(answer.t, 3 + (root == west ? off : -off), 1e-6);
            }
        }
    }
}

TEST_F(Doorway, farFromThePlaneASurfaceIsMetInItsOwnSpaceOnly) {
    std::uint32_t id = 0;
    const auto met = [&](double x, world::SpaceIndex member, world::SpaceIndex root) {
        const Answer answer = withPanel(x, member, root, id);
        return answer.id == id || answer.id == id + 1;
    };
    EXPECT_FALSE(met(3.9995, east, west)) << "before the plane it enters by";
    EXPECT_FALSE(met(4.0005, west, west)) << "beyond the plane it left by";
    EXPECT_FALSE(met(3.9995, east, east));
    EXPECT_FALSE(met(4.0005, west, east));
    EXPECT_TRUE(met(3.9995, west, west));
    EXPECT_TRUE(met(3.9995, west, east));
    EXPECT_TRUE(met(4.0005, east, west));
    EXPECT_TRUE(met(4.0005, east, east));
}

TEST_F(Doorway, theToleranceIsMeasuredAcrossThePlaneNotAlongTheRay) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t id = dynamics.add(staticOf(traced->world(), model), {4.0001, 2, 11}, {west});
    traced->scene().setDynamics(dynamics.build());
    // Slanting by 0.02, the ray is 5 mm beyond the plane, counted along itself, when it meets the panel.
    const Answer answer = traced->trace(west, {3.99, 1.6, 11}, {0.02, 1, 0});
    EXPECT_EQ(answer.id, id);
    EXPECT_NEAR(answer.t, 0.505, 1e-5);
}

TEST_F(Doorway, ofTwoSurfacesInThePlaneTheNearerIsMet) {
    for (const double first : {-0.0001, 0.0001}) {
        DynamicStateMaker dynamics(traced->world());
        const std::uint32_t mine = dynamics.add(staticOf(traced->world(), model), {4 + first, 2, 11}, {west});
        const std::uint32_t theirs =
            dynamics.add(staticOf(traced->world(), model), {4 - first, 2, 11}, {east});
        traced->scene().setDynamics(dynamics.build());
        EXPECT_EQ(traced->trace(west, {1, 2, 11}, {1, 0, 0}).id, first < 0 ? mine : theirs);
    }
}

TEST(Tolerance, portalsInOnePlaneThatLeadInACircleEnd) {
    // Both doors look the same way in the same place: the ray must end, even with the eye there.
    TwoRooms rooms;
    world::World world = loadTestWorld(rooms.world, {.radius = 1});
    const world::SpaceIndex a = world::findCell(world, rooms.world.id(rooms.west)),
                            b = world::findCell(world, rooms.world.id(rooms.east));
    world::Portal& there = world.portals[world.spaces[a].firstPortal];
    world::Portal& back = world.portals[world.spaces[b].firstPortal];
    back.plane = there.plane;
    back.firstCorner = there.firstCorner;
    back.firstVertex = there.firstVertex;
    there.reciprocal = back.reciprocal = world::kNone;
    const reference::Scene scene(world);
    const Answer inPlane = scene.trace(a, {toGlobal(rooms.world, {4, 2, 11}), {1, 0, 0}, 0.02});
    EXPECT_EQ(inPlane.spacesVisited, 3u) << "through each of them once";
    const Answer before = scene.trace(a, {toGlobal(rooms.world, {1, 2, 11}), {1, 0, 0}, 0.02});
    EXPECT_EQ(before.spacesVisited, 2u) << "the way on is not beyond the way in";
    EXPECT_NEAR(before.t, 7.0, 1e-9);
    EXPECT_EQ(before.space, b);
}

TEST(Tolerance, theBorderOfAWideHoleIsNotWider) {
    TwoRooms rooms;
    world::World world = loadTestWorld(rooms.world, {.radius = 1});
    const world::SpaceIndex a = world::findCell(world, rooms.world.id(rooms.west));
    // The opening is gone, so that its place is a hole.
    world::Portal& portal = world.portals[world.spaces[a].firstPortal];
    portal.vertexCount = portal.cornerCount = 0;
    const reference::Scene scene(world);
    for (const double in : {0.0001, 0.3})
        EXPECT_EQ(scene.trace(a, {toGlobal(rooms.world, {1, 2.5 - in, 11}), {1, 0, 0}, 0.02}).id, 0u) << in;
    EXPECT_NE(scene.trace(a, {toGlobal(rooms.world, {1, 2.5001, 11}), {1, 0, 0}, 0.02}).id, 0u);
}

TEST(Tolerance, aGapNarrowerThanTheDatasRoundingIsClosedAndAWiderOneIsAHole) {
    for (const double gap : {0.0001, 0.001}) {
        SCOPED_TRACE(gap);
        TwoRooms rooms;
        world::World world = loadTestWorld(rooms.world, {.radius = 1});
        const world::SpaceIndex a = world::findCell(world, rooms.world.id(rooms.west)),
                                b = world::findCell(world, rooms.world.id(rooms.east));
        // Both polygons of the opening end short of the wall at y = 2.5.
        for (const world::SpaceIndex s : {a, b}) {
            world::Portal& portal = world.portals[world.spaces[s].firstPortal];
            portal.vertexCount = 0;
            for (std::uint32_t i = portal.firstCorner; i < portal.firstCorner + portal.cornerCount; ++i) {
                Vec3& p = world.portalCorners[i];
                p.y = std::min(p.y, toGlobal(rooms.world, {0, 2.5 - gap, 0}).y);
            }
        }
        const reference::Scene scene(world);
        const Answer slip =
            scene.trace(a, {toGlobal(rooms.world, {1, 2.5 - gap * 0.5, 11}), {1, 0, 0}, 0.02});
        // In the middle of the gap opening and wall are equally near.
        const world::InstanceIndex shells[] = {world.spaces[a].shell, world.spaces[b].shell};
        const bool isMet = std::any_of(std::begin(shells), std::end(shells), [&](world::InstanceIndex i) {
            const std::uint32_t base = world.instances[i].idBase;
            return slip.id >= base && slip.id < base + world.meshes[world.instances[i].mesh].polygonCount;
        });
        EXPECT_EQ(isMet, gap < 0.0002);
        EXPECT_EQ(slip.id == 0, gap > 0.0002);
    }
}

} // namespace
} // namespace limen::test
