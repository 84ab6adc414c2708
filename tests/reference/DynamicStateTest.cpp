// Dynamic states: shut openings and their fillings, moving instances, translucent surfaces.
#include "reference/DynamicStateMaker.h"

#include <set>

namespace limen::test {
namespace {

using reference::Answer;
using reference::layerHash;

/// Two rooms and a door, and a closed room with models that dynamic states copy: a leaf with the door's
/// polygon, a panel, and a pane of glass.
struct Door : ::testing::Test {
    TwoRooms rooms;
    TestWorld::Cell store = rooms.world.addBox({100, 100, 10}, {110, 110, 14});
    std::uint32_t leafModel = rooms.world.addModel(bothWays({doorway(), "oak"}));
    std::uint32_t panelModel = rooms.world.addModel(bothWays(panel(0.25, "pink", false)));
    /// A leaf of two boards, the lower one a quarter of its height.
    std::uint32_t boardsModel =
        rooms.world.addModel({{westward(10.0, 10.5), "oak"}, {westward(10.5, 12.0), "oak"}});
    std::uint32_t paneModel = 0;
    std::unique_ptr<TracedWorld> traced;
    world::SpaceIndex west = 0, east = 0;
    world::PortalIndex portal = 0;

    /// The part of the doorway between two heights; its front looks west.
    static std::vector<Vec3> westward(double low, double high) {
        std::vector<Vec3> points = rectangle({4, 1.5, low}, {4, 2.5, high});
        std::reverse(points.begin(), points.end());
        return points;
    }
    static std::vector<Vec3> doorway() { return westward(10, 12); }
    void SetUp() override {
        rooms.world.solid("glass", 0x80FFFFFFu, dat::Surface::kTranslucent, 0.5f);
        paneModel = rooms.world.addModel({panel(0.25, "glass", false)});
        rooms.world.addStatic(store, leafModel, frameAt({100, 104, 0}));
        rooms.world.addStatic(store, boardsModel, frameAt({104, 104, 0}));
        rooms.world.addStatic(store, panelModel, frameAt({102, 102, 12}));
        rooms.world.addStatic(store, paneModel, frameAt({103, 102, 12}));
        traced = std::make_unique<TracedWorld>(rooms.world);
        west = traced->space(rooms.world.id(rooms.west));
        east = traced->space(rooms.world.id(rooms.east));
        portal = traced->world().spaces[west].firstPortal;
    }
    [[nodiscard]] world::InstanceIndex like(std::uint32_t model) const {
        return staticOf(traced->world(), model);
    }
    /// Shuts the door; returns the leaf's idBase.
    std::uint32_t shutDoor(DynamicStateMaker& dynamics) const {
        const std::uint32_t leaf =
            dynamics.add(like(leafModel), Vec3(0.0), {west, east}, world::InstanceKind::Filling);
        dynamics.shut(portal);
        return leaf;
    }
    [[nodiscard]] Answer eastward(double y = 2, double z = 11) const {
        return traced->trace(west, {1, y, z}, {1, 0, 0});
    }
    [[nodiscard]] Answer westward() const { return traced->trace(east, {7, 2, 11}, {-1, 0, 0}); }
};

TEST_F(Door, aShutOpeningShowsItsFillingFromBothSidesAndOpensAgain) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t leaf = shutDoor(dynamics);
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward().id, leaf) << "the side that looks west";
    EXPECT_NEAR(eastward().t, 3.0, 1e-9);
    EXPECT_EQ(eastward().space, west);
    EXPECT_EQ(eastward().spacesVisited, 1u);
    EXPECT_EQ(westward().id, leaf + 1) << "the side that looks east";
    EXPECT_NEAR(westward().t, 3.0, 1e-9);
    traced->scene().setDynamics({});
    EXPECT_EQ(eastward().space, east);
    EXPECT_EQ(westward().space, west);
}

TEST_F(Door, theWholeOpeningIsShutRimIncluded) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t leaf = shutDoor(dynamics);
    traced->scene().setDynamics(dynamics.build());
    for (const double inward : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
        for (const Vec2& at : {Vec2(1.5 + inward, 11), Vec2(2.5 - inward, 11), Vec2(2, 12 - inward)}) {
            const Answer answer = eastward(at.x, at.y);
            EXPECT_TRUE(answer.id == leaf || traced->isShell(answer.id, west)) << answer.id;
            EXPECT_NEAR(answer.t, 3.0, 1e-9);
        }
    }
    EXPECT_TRUE(traced->isShell(eastward(2.51).id, west));
}

TEST_F(Door, aLeafSmallerThanItsOpeningLeavesNoGap) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t small =
        dynamics.add(like(panelModel), {4, 2, 11}, {west, east}, world::InstanceKind::Filling);
    dynamics.shut(portal);
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward(1.6, 10.1).id, small) << "where the leaf has no triangle";
    EXPECT_EQ(eastward(2, 11).id, small);
    EXPECT_EQ(westward().id, small + 1);
}

TEST_F(Door, ofALeafOfSeveralPolygonsTheOneThatTheRayMeetsIsShown) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t boards =
        dynamics.add(like(boardsModel), Vec3(0.0), {west, east}, world::InstanceKind::Filling);
    dynamics.shut(portal);
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward(2, 10.2).id, boards);
    EXPECT_EQ(eastward(2, 11).id, boards + 1);
    EXPECT_TRUE(westward().id == boards || westward().id == boards + 1)
        << "no polygon looks east; nothing is open";
}

TEST_F(Door, theFillingComesFirstOfWhatLiesInItsPlane) {
    for (const auto& [off, wins] :
         {std::pair(-0.00015, true), {0.0, true}, {0.00015, true}, {-0.0005, false}}) {
        SCOPED_TRACE(off);
        DynamicStateMaker dynamics(traced->world());
        const std::uint32_t other = dynamics.add(like(panelModel), {4 + off, 2, 11}, {west});
        const std::uint32_t leaf = shutDoor(dynamics);
        traced->scene().setDynamics(dynamics.build());
        EXPECT_EQ(eastward().id, wins ? leaf : other);
    }
}

TEST_F(Door, aShutOpeningWithoutASurfaceIsAHole) {
    DynamicStateMaker dynamics(traced->world());
    dynamics.shut(portal, false);
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward().id, 0u);
    EXPECT_TRUE(std::isnan(eastward().t));
}

TEST_F(Door, aShutOpeningNearerThanTheNearPlaneLetsNothingThrough) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t leaf = shutDoor(dynamics);
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(traced->trace(west, {3.979, 2, 11}, {1, 0, 0}).id, leaf);
    for (const double x : {3.99, 3.9999, 4.0}) {
        const Answer answer = traced->trace(west, {x, 2, 11}, {1, 0, 0});
        EXPECT_EQ(answer.spacesVisited, 1u) << x;
        EXPECT_NE(answer.id, leaf) << x << ": too near to be met";
        EXPECT_EQ(answer.space, west) << x;
    }
    EXPECT_EQ(traced->trace(west, {4.0, 2, 11}, {-1, 0, 0}).space, west);
    EXPECT_EQ(traced->trace(west, {4.0001, 2, 11}, {1, 0, 0}).space, east) << "the eye is past the door";
}

TEST_F(Door, movingThingsAreMetInEverySpaceTheyAreMembersOfAndInNoOther) {
    DynamicStateMaker dynamics(traced->world());
    const world::SpaceIndex store_ = traced->space(rooms.world.id(store));
    const std::uint32_t both = dynamics.add(like(panelModel), {3, 2, 11}, {west, east});
    const std::uint32_t westOnly = dynamics.add(like(panelModel), {5, 2, 11}, {west});
    dynamics.add(like(panelModel), {2, 2, 11}, {store_});
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward().id, both);
    EXPECT_NEAR(eastward().t, 2.0, 1e-6);
    // From the east: through the door and then the panel that is both rooms'; the one at 5 m is the west's
    // alone.
    EXPECT_EQ(westward().id, both + 1);
    EXPECT_NEAR(westward().t, 4.0, 1e-6);
    EXPECT_NE(westward().id, westOnly + 1);
    traced->scene().setDynamics({});
    EXPECT_NEAR(westward().t, 7.0, 1e-9) << "gone with its dynamic state";
}

TEST_F(Door, ofTwoSurfacesInOnePlaceTheLowerIdIsMetWhateverTheirOrder) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t lower = dynamics.add(like(panelModel), {3, 2, 11}, {west});
    dynamics.add(like(panelModel), {3, 2, 11}, {west});
    world::DynamicState both = dynamics.build();
    for (int order = 0; order < 2; ++order) {
        traced->scene().setDynamics(both);
        EXPECT_EQ(eastward().id, lower);
        EXPECT_EQ(eastward(2.1, 10.9).id, lower);
        std::swap(both.instances[0].idBase, both.instances[1].idBase);
    }
}

TEST_F(Door, movingThingsInASpaceButOutsideItsWallsAreMetWhereTheyAre) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t both = dynamics.add(like(panelModel), {5, 2, 11}, {west, east});
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward().id, both);
    EXPECT_EQ(eastward().space, east) << "met beyond the door";
    EXPECT_EQ(eastward().spacesVisited, 2u);
}

TEST_F(Door, translucentPolygonsInFrontOfTheEndAreCountedOnceEach) {
    DynamicStateMaker dynamics(traced->world());
    std::set<std::uint32_t> expected;
    for (const double x : {2.0, 2.5})
        expected.insert(dynamics.add(like(paneModel), {x, 2, 11}, {west}));
    expected.insert(dynamics.add(like(paneModel), {6, 2, 11}, {east}));
    expected.insert(
        dynamics.add(like(paneModel), {4, 2, 11}, {west, east})); // in the plane: both rooms have it
    dynamics.add(like(paneModel), {9, 2, 11}, {east});            // behind the end
    dynamics.add(like(paneModel), {5, 2, 11}, {west});            // the ray is in the east by then
    dynamics.add(like(paneModel), {3, 2, 11}, {east});            // and not there yet
    dynamics.add(like(paneModel), {1.01, 2, 11}, {west});         // before the near plane
    dynamics.add(like(paneModel), {3, 3.5, 11}, {west});          // beside the ray
    traced->scene().setDynamics(dynamics.build());
    std::uint32_t hash = 0;
    for (const std::uint32_t id : expected)
        hash += layerHash(id);
    const Answer answer = eastward();
    EXPECT_EQ(answer.layers.count, 4u);
    EXPECT_EQ(answer.layers.hash, hash);
    EXPECT_NEAR(answer.t, 7.0, 1e-9) << "they have no id and no depth";
    EXPECT_EQ(westward().layers.count, 0u) << "their backs";
    EXPECT_EQ(traced->trace(west, {1, 3, 11}, {1, 0, 0}).layers.count, 0u);
}

TEST_F(Door, aShutOpeningHidesTheLayersBehindIt) {
    DynamicStateMaker dynamics(traced->world());
    const std::uint32_t before = dynamics.add(like(paneModel), {2, 2, 11}, {west});
    dynamics.add(like(paneModel), {6, 2, 11}, {east});
    dynamics.add(like(paneModel), {4, 2, 11}, {west, east}); // in its plane, where the filling comes first
    shutDoor(dynamics);
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward().layers, (reference::Layers{1, layerHash(before)}));
}

TEST_F(Door, manyLayersAreAllCounted) {
    DynamicStateMaker dynamics(traced->world());
    std::uint32_t hash = 0;
    for (int i = 0; i < 100; ++i)
        hash += layerHash(dynamics.add(like(paneModel), {1.2 + i * 0.02, 2, 11}, {west}));
    traced->scene().setDynamics(dynamics.build());
    EXPECT_EQ(eastward().layers, (reference::Layers{100, hash}));
}

TEST(Layers, staticPanesCountOncePerPolygonWhateverTheirTriangles) {
    TestWorld source;
    source.solid("glass", 0x80FFFFFFu, dat::Surface::kTranslucent, 0.5f);
    const auto cell = source.addBox({0, 0, 10}, {4, 4, 14});
    source.addStatic(cell, source.addModel({panel(1, "glass")}), frameAt({2, 2, 12}));
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    // Exactly along the diagonal that the pane's two triangles share, too.
    for (const double v : {-0.9, -0.5, 0.0, 0.3, 0.9}) {
        for (const double w : {v, -v, 0.1}) {
            const Answer answer = traced.trace(room, {1, 2 + v, 12 + w}, {1, 0, 0});
            EXPECT_EQ(answer.layers.count, 1u) << v << " " << w;
            EXPECT_NEAR(answer.t, 3.0, 1e-9);
        }
    }
}

// Two ridges across a pane: a ray along it can pass the first one and the second one.
TEST(Layers, aPaneThatIsNotFlatCountsAsOftenAsARayMeetsIt) {
    TestWorld source;
    source.solid("glass", 0x80FFFFFFu, dat::Surface::kTranslucent, 0.5f);
    const auto cell = source.addBox({0, 0, 10}, {4, 4, 14});
    std::vector<Vec3> ridges;
    for (const double y : {-0.5, 0.5})
        for (int i = 0; i < 4; ++i)
            ridges.emplace_back(y < 0.0 ? i - 1.5 : 1.5 - i, y, (i % 2 == 0) == (y < 0.0) ? 0.0 : 0.1);
    source.addStatic(cell, source.addModel({{ridges, "glass"}}), frameAt({2, 2, 12}));
    const TracedWorld traced(source);
    const world::SpaceIndex room = traced.space(source.id(cell));
    std::size_t most = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 eye(0.1 + 0.003 * (i % 20), 1.7 + 0.03 * (i / 20), 12.09), to(3.9, 2.0, 12.05);
        const Answer answer = traced.trace(room, eye, to - eye);
        most = std::max<std::size_t>(most, answer.layers.count);
        const Answer back = traced.trace(room, to, eye - to);
        most = std::max<std::size_t>(most, back.layers.count);
    }
    EXPECT_EQ(most, 2u);
    EXPECT_EQ(traced.trace(room, {2, 2, 13}, {0.01, 0.02, -1}).layers.count, 1u);
}

TEST(Zones, objectsOfAZoneAreMetThroughItsWallsOnlyByChoice) {
    // A panel of the western room pokes through the wall beside the door into the eastern room.
    TwoRooms rooms;
    rooms.world.addStatic(rooms.west, rooms.world.addModel(bothWays(panel(0.2, "pink", false))),
                          frameAt({4.1, 0.4, 12.6}));
    const auto trace = [&](bool byZone) {
        const TracedWorld traced(rooms.world, {.radius = 1}, {.objectsByZone = byZone});
        const world::World& world = traced.world();
        const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                                east = traced.space(rooms.world.id(rooms.east));
        EXPECT_EQ(world.spaces[west].zone, world.spaces[east].zone);
        const Answer own = traced.trace(west, {1, 0.4, 12.6}, {1, 0, 0});
        EXPECT_TRUE(traced.isShell(own.id, west)) << "the wall is before it";
        return traced.trace(east, {7, 0.4, 12.6}, {-1, 0, 0}).t;
    };
    EXPECT_NEAR(trace(false), 3.0, 1e-6) << "the wall";
    EXPECT_NEAR(trace(true), 2.9, 1e-6) << "the panel";
}

TEST(Zones, movingObjectsGoByZoneAsWell) {
    TwoRooms rooms;
    const auto store = rooms.world.addBox({100, 100, 10}, {110, 110, 14});
    const std::uint32_t model = rooms.world.addModel(bothWays(panel(0.2, "pink", false)));
    rooms.world.addStatic(store, model, frameAt({102, 102, 12}));
    for (const bool byZone : {false, true}) {
        TracedWorld traced(rooms.world, {.radius = 1}, {.objectsByZone = byZone});
        const world::SpaceIndex west = traced.space(rooms.world.id(rooms.west)),
                                east = traced.space(rooms.world.id(rooms.east));
        DynamicStateMaker dynamics(traced.world());
        const std::uint32_t id = dynamics.add(staticOf(traced.world(), model), {4.1, 0.4, 12.6}, {west});
        traced.scene().setDynamics(dynamics.build());
        const Answer answer = traced.trace(east, {7, 0.4, 12.6}, {-1, 0, 0});
        EXPECT_EQ(answer.id == id + 1, byZone);
        EXPECT_NEAR(answer.t, byZone ? 2.9 : 3.0, 1e-6);
    }
}

} // namespace
} // namespace limen::test
