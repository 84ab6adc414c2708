#pragma once

#include "support/LoadTestWorld.h"

namespace limen::test {

/// A hut of two rooms on a flat meadow, with dynamic objects: an opaque front door (room 1 to the outside),
/// an opaque door between the rooms, a pane in the rear window (room 2 to the outside), a villager walking
/// from the meadow through both doors, a player with the same model, one emitter in the meadow and one
/// carried by the villager. Positions are block-local.
///
///           y
///  14 +---------+---------+
///     | front   D  rear   P      D, d: doors, P: pane; d is in the wall x = 10
///  10 d---------+---------+
///     10        14        18   x
struct MovingHut {
    TestWorld source;
    TestWorld::Cell front = source.addBox({10, 10, 2}, {14, 14, 5}, "blue"),
                    rear = source.addBox({14, 10, 2}, {18, 14, 5}, "red");
    TestWorld::Portal frontDoor, innerDoor, window;
    world::MovingEntries moving;
    std::uint32_t leaf = 0, pane = 0, body = 0, table = 0;

    MovingHut() {
        innerDoor = source.link(front, rectangle({14, 11, 2}, {14, 12, 4}), rear).first;
        frontDoor = source.openOutside(front, rectangle({10, 11, 2}, {10, 12, 4}));
        window = source.openOutside(rear, rectangle({18, 11, 3}, {18, 13, 4}));
        source.addBuilding(boxExterior({10, 10, 2}, {18, 14, 5.2}), {frontDoor, window});
        source.setFlatTerrain(source.home(), 1);
        // A door leaf extends from its origin along +y (closed in the plane x = const), 1 m wide, 2 m high, 6
        // cm thick.
        source.solid("glass", 0xFF80A0C0u, 0x10, 0.6f);
        leaf = source.addModel(boxExterior({-0.03, 0, 0}, {0.03, 1, 2}, "wood"));
        pane = source.addModel(boxExterior({-0.01, 0, 0}, {0.01, 2, 1}, "glass"));
        body = source.addModel(boxExterior({-0.25, -0.2, 0}, {0.25, 0.2, 1.75}, "coat"));
        // A table in the rear room that extends through the inner door.
        table = source.addModel(boxExterior({-1, -0.2, 0}, {1, 0.2, 0.8}, "oak"));
        source.addStatic(rear, table, frameAt({14.5, 11.5, 2}));
        moving.doors.push_back(
            {"front", source.id(front), frontDoor.index, true, 0.0, {{leaf, at({10, 11, 2}), 0.0, -90.0}}});
        moving.doors.push_back(
            {"inner", source.id(front), innerDoor.index, true, 0.5, {{leaf, at({14, 11, 2}), 0.0, 90.0}}});
        moving.doors.push_back(
            {"pane", source.id(rear), window.index, false, 0.0, {{pane, at({18, 11, 3}), 0.0, 0.0}}});
        world::RouteEntry route;
        route.name = "through";
        route.points = {{at({4, 11.5, 2}), 0},
                        {at({12, 11.5, 2}), source.id(front)},
                        {at({16, 11.5, 2}), source.id(rear)}};
        moving.routes.push_back(route);
        moving.villagers.push_back({"anna", "through", body, 1.0, 0.0, {}, {}});
        moving.player = body;
        world::EmitterEntry smoke;
        smoke.name = "smoke";
        smoke.surface = source.surfaceId("glass");
        smoke.position = at({9, 11.5, 3});
        smoke.velocity = {0, 0, 1};
        smoke.spread = 0.2;
        smoke.rate = 5;
        smoke.life = 2;
        smoke.size = {0.2, 0.6};
        smoke.alpha = {0.8, 0.0};
        moving.emitters.push_back(smoke);
        smoke.name = "lantern";
        smoke.attachedTo = "anna";
        smoke.position = {0.3, 0.3, 1.0};
        moving.emitters.push_back(smoke);
    }
    [[nodiscard]] Vec3 at(const Vec3& local) const { return toGlobal(source, local); }
    [[nodiscard]] world::World load(const world::LoadOptions& options = {}) {
        return loadTestWorld(source, options, moving);
    }
};

} // namespace limen::test
