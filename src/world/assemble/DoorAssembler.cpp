#include "world/assemble/DoorAssembler.h"

#include "core/Assert.h"
#include "geometry/Compass.h"
#include "world/Lookup.h"
#include "world/OpeningParts.h"
#include "world/mesh/ShutPane.h"
#include "world/mesh/Triangulate.h"

namespace limen::world {
namespace {

/// A portal's outline in the frame of its block. Exact: the points are corners of that block.
std::vector<Vec3> localOutline(const World& world, const Portal& portal) {
    LIMEN_ASSERT(portal.block < world.blocks.size(), "the portal's vertices are local to a block");
    const Vec3 origin = world.blocks[portal.block].origin();
    std::vector<Vec3> points;
    for (const Vec3& p : polygonOf(world, portal))
        points.push_back(p - origin);
    return points;
}

/// Both sides of an opening's polygon, block-local. One texture repeat a metre.
MeshData fillingMesh(const World& world, const Portal& portal) {
    const std::vector<Vec3> points = localOutline(world, portal);
    const Vec3 up = std::abs(portal.plane.n.z) < 0.7 ? Vec3(0.0, 0.0, 1.0) : Vec3(0.0, 1.0, 0.0);
    const Vec3f across(glm::normalize(glm::cross(up, portal.plane.n)));
    std::vector<TriangleCorners> triangles;
    triangulate(points, triangles);
    MeshData mesh;
    std::vector<std::uint32_t>& indices = mesh.indicesOf(SurfaceList::Opaque);
    for (std::uint16_t side = 0; side < 2; ++side) {
        const Vec3f normal = Vec3f(portal.plane.n) * (side == 0 ? 1.0f : -1.0f);
        for (TriangleCorners t : triangles) {
            if (side == 1)
                std::swap(t[1], t[2]);
            for (const std::uint32_t corner : t) {
                const Vec3f p(points[corner]);
                indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
                mesh.vertices.push_back(
                    {p, normal, Vec2f(glm::dot(across, p), -glm::dot(Vec3f(up), p)), side, 0, Vec3f(0.0f)});
                mesh.vertices.back().placeAt(points[corner]);
            }
        }
        mesh.polygonIds.push_back(portal.polygonId);
    }
    return mesh;
}

PortalIndex findPortal(const World& world, SpaceIndex space, std::uint32_t recordIndex) {
    const Space& from = world.spaces[space];
    for (PortalIndex p = from.firstPortal; p < from.firstPortal + from.portalCount; ++p)
        if (world.portals[p].recordIndex == recordIndex)
            return p;
    return kNone;
}

} // namespace

void DoorAssembler::add(const DoorEntry& entry, std::size_t index) {
    const SpaceIndex space = findCell(world_, entry.cell);
    if (space == kNone)
        return;
    const std::uint64_t object = dynamicObject(DynamicObject::Door, index);
    Door door;
    door.name = entry.name;
    door.portal = findPortal(world_, space, entry.portal);
    door.opaque = entry.opaque;
    door.open = entry.open;
    if (door.portal == kNone) {
        world_.findings.push_back({entry.cell, "world.json: door \"" + entry.name +
                                                   "\" names a portal that the cell does not have"});
        return;
    }
    const Portal& portal = openingOf(world_, door.portal);
    door.reciprocal = world_.portals[door.portal].reciprocal;
    door.firstLeaf = static_cast<std::uint32_t>(world_.leaves.size());
    for (const LeafEntry& leaf : entry.leaves)
        addLeaf(leaf, door, object);
    door.leafCount = static_cast<std::uint32_t>(world_.leaves.size()) - door.firstLeaf;
    if (door.opaque && portal.cornerCount >= 3)
        door.filling = addFilling(door, object);
    world_.doors.push_back(std::move(door));
}

void DoorAssembler::addPlaced(Door door, std::uint64_t object) {
    LIMEN_ASSERT(door.portal < world_.portals.size(), "a door of a database hangs in a portal of the world");
    if (door.opaque && openingOf(world_, door.portal).cornerCount >= 3)
        door.filling = addFilling(door, object);
    world_.doors.push_back(std::move(door));
}

void DoorAssembler::addLeaf(const LeafEntry& entry, const Door& door, std::uint64_t object) {
    const Portal& portal = openingOf(world_, door.portal);
    world_.leaves.push_back({entry.model,
                             bodies_.add(entry.model, InstanceKind::Filling, object),
                             entry.position,
                             entry.yaw,
                             entry.swing,
                             {}});
    if (!door.opaque && portal.vertexCount >= 3)
        world_.leaves.back().shut = addShutBody(world_.leaves.back(), portal);
}

MovingBody DoorAssembler::addShutBody(const Leaf& leaf, const Portal& portal) {
    const std::vector<Vec3> outline = localOutline(world_, portal);
    const Vec3 block = world_.blocks[portal.block].origin();
    const Mat3 turn = turnedTo(leaf.yaw);
    MovingBody body{static_cast<std::uint32_t>(world_.movingParts.size()), leaf.body.partCount, {}};
    for (std::uint32_t p = leaf.body.firstPart; p < leaf.body.firstPart + leaf.body.partCount; ++p) {
        Instance part = world_.movingParts[p];
        const PartMesh* mesh = models_.part(part.record);
        LIMEN_ASSERT(mesh != nullptr, "the leaf's part was made from this mesh");
        const Placement placement{turn * Mat3(part.linear), leaf.hinge - block + turn * Vec3(part.origin)};
        const auto number = static_cast<std::uint32_t>(world_.movingParts.size());
        part.mesh = arena_.add(placedBetween(outline, mesh->mesh, placement),
                               contentKey(MeshSource::ShutPane, part.record, number));
        part.bounds = world_.meshes[part.mesh].bounds;
        part.block = portal.block;
        part.linear = glm::mat3(1.0f);
        part.origin = Vec3f(0.0f);
        world_.movingParts.push_back(part);
    }
    return body;
}

std::uint32_t DoorAssembler::addFilling(const Door& door, std::uint64_t object) {
    const Portal& portal = openingOf(world_, door.portal);
    Instance filling;
    filling.kind = InstanceKind::Filling;
    filling.mesh =
        arena_.add(fillingMesh(world_, portal),
                   contentKey(MeshSource::Filling, world_.spaces[portal.space].cellId, portal.recordIndex));
    filling.bounds = world_.meshes[filling.mesh].bounds;
    filling.block = portal.block;
    filling.object = object;
    if (door.leafCount > 0 && world_.leaves[door.firstLeaf].body.partCount > 0) {
        // The margin of the filling that shows beside the leaf has the leaf's material.
        const Instance& leaf = world_.movingParts[world_.leaves[door.firstLeaf].body.firstPart];
        filling.record = leaf.record;
        filling.firstMaterial = leaf.firstMaterial;
    } else {
        filling.firstMaterial = materials_.addPlain(Vec4f(0.12f, 0.09f, 0.07f, 1.0f), SurfaceClass::Opaque);
    }
    world_.movingParts.push_back(filling);
    return static_cast<std::uint32_t>(world_.movingParts.size() - 1);
}

} // namespace limen::world
