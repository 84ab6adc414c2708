#pragma once

#include "visibility/VisibleSet.h"
#include "world/World.h"

namespace limen::test {

inline world::Instance instanceOf(world::InstanceKind kind, std::uint32_t mesh, world::SpaceIndex placedIn,
                                  std::uint64_t object, dat::RecordId record, std::uint32_t idBase) {
    world::Instance instance;
    instance.kind = kind;
    instance.mesh = mesh;
    instance.placedIn = placedIn;
    instance.object = object;
    instance.record = record;
    instance.idBase = idBase;
    return instance;
}

/// Outside with a terrain of two polygons (ids 2, 3), one cell with a shell of three (ids 4..6), an opening
/// each way.
inline world::World smallWorld() {
    world::World world;
    world.spaces.resize(2);
    world.spaces[1].cellId = 0xA9B40105;
    world.portals.resize(2);
    world.portals[0].space = 0;
    world.portals[0].recordIndex = 4;
    world.portals[1].space = 1;
    world.portals[1].recordIndex = 2;
    world.meshes.resize(2);
    world.meshes[0].polygonCount = 2;
    world.meshes[1].polygonCount = 3;
    world.meshes[1].firstPolygonInfo = 2;
    world.polygonIds = {0, 1, 10, 20, 30};
    // Out of order on purpose: the table sorts by id.
    world.instances = {instanceOf(world::InstanceKind::Shell, 1, 1, 0x1122, 0xA9B40105, 4),
                       instanceOf(world::InstanceKind::Terrain, 0, 0, 0x33, 0xA9B4FFFF, 2)};
    world.idEnd = 7;
    return world;
}

/// From the cell, and through its opening outside.
inline visibility::VisibleSet twoVisits() {
    visibility::VisibleSet visible;
    visible.visits.resize(2);
    visible.regionVertices = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1},
                              {0, 0, 0},   {2, 0, 4},  {2, 2, 4}, {0, 2, 4}};
    visible.visits[0].zone = visible.visits[0].space = 1;
    visible.visits[0].vertexCount = 4;
    visibility::Visit& second = visible.visits[1];
    second.parent = 0;
    second.portal = 1;
    second.firstVertex = second.vertexCount = 4;
    second.depth = 1;
    visible.seen = {{1, 0, {}}, {0, 1, {}}, {1, 1, {}}};
    return visible;
}

} // namespace limen::test
