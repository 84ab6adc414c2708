#include "world/Assembly.h"

#include "geometry/Compass.h"
#include "world/Loader.h"
#include "world/ShutPane.h"
#include "world/Triangulate.h"

#include <algorithm>

// The part of Assembly that makes what can move: doors and panes, routes, villagers, emitters, rain.
namespace limen::world {
namespace {

/// Both sides of an opening's polygon as a mesh, block-local; pictures laid on in metres.
MeshData fillingMesh(const World& world, const Portal& portal, const Vec3& origin) {
    const std::span<const Vec3> polygon = polygonOf(world, portal);
    std::vector<Vec3> points;
    for (const Vec3& p : polygon)
        points.push_back(p - origin); // exact: they are corners of this block
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

MeshData spriteMesh(SurfaceList surfaces, const Vec2f& low, const Vec2f& high) {
    MeshData mesh;
    const std::array<Vec2f, 4> corners{Vec2f(0, 1), Vec2f(1, 1), Vec2f(1, 0), Vec2f(0, 0)};
    for (const std::size_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
        const Vec2f& corner = corners[i];
        const Vec3f at(low.x + corner.x * (high.x - low.x), 0.0f, high.y + corner.y * (low.y - high.y));
        mesh.indicesOf(surfaces).push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back({at, Vec3f(0.0f, -1.0f, 0.0f), corner, 0, 0, Vec3f(0.0f)});
    }
    mesh.polygonIds.push_back(0);
    return mesh;
}

MovingBody Assembly::addBody(dat::RecordId modelId, InstanceKind kind, std::uint64_t object,
                             const Dress& dress) {
    const Model model = dress.parts.empty() ? models_.model(modelId) : models_.dressed(modelId, dress);
    MovingBody body;
    body.firstPart = static_cast<std::uint32_t>(world_.movingParts.size());
    body.bounds = model.bounds;
    std::vector<ModelPart> parts = model.parts;
    if (kind != InstanceKind::Filling) // what shuts an opening is the same from everywhere
        parts.insert(parts.end(), model.farther.begin(), model.farther.end());
    std::vector<PosedPart> posed;
    for (const ModelPart& part : parts) {
        const PartMesh* mesh = models_.part(part.gfxObj);
        if (mesh == nullptr || mesh->mesh.empty())
            continue;
        Instance instance;
        instance.kind = kind;
        instance.mesh = arena_.shared(*mesh);
        instance.linear = glm::mat3(part.linear);
        instance.origin = Vec3f(part.origin);
        instance.bounds = world_.meshes[instance.mesh].bounds;
        instance.object = object;
        instance.record = part.gfxObj;
        instance.firstMaterial = dressedMaterials(*mesh, part.part, dress);
        if (kind != InstanceKind::Filling)
            instance.levelRange = part.reach;
        world_.movingParts.push_back(instance);
        posed.push_back({part.part, part.scale});
    }
    body.partCount = static_cast<std::uint32_t>(world_.movingParts.size()) - body.firstPart;
    if (kind != InstanceKind::Filling) // doors are moved by their hinges alone
        addCycles(modelId, posed, body);
    return body;
}

void Assembly::addCycles(dat::RecordId model, std::span<const PosedPart> posed, MovingBody& body) {
    body.cycles = cycles_.of(model);
    if (std::all_of(body.cycles.begin(), body.cycles.end(), [](std::uint32_t c) { return c == kNone; }))
        return;
    body.firstPosed = static_cast<std::uint32_t>(world_.posedParts.size());
    world_.posedParts.insert(world_.posedParts.end(), posed.begin(), posed.end());
    body.bounds = boundsInMotion(world_, body);
}

void Assembly::addDoor(const DoorEntry& entry, std::size_t index) {
    const SpaceIndex space = findCell(world_, entry.cell);
    if (space == kNone)
        return;
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
    const Portal& portal = world_.portals[door.portal];
    door.reciprocal = portal.reciprocal;
    door.firstLeaf = static_cast<std::uint32_t>(world_.leaves.size());
    for (const LeafEntry& leaf : entry.leaves) {
        world_.leaves.push_back(
            {leaf.model,
             addBody(leaf.model, InstanceKind::Filling, movingObject(MovingThing::Door, index)),
             leaf.position,
             leaf.yaw,
             leaf.swing,
             {}});
        if (!door.opaque && portal.vertexCount >= 3)
            world_.leaves.back().shut = addShutBody(world_.leaves.back(), portal);
    }
    door.leafCount = static_cast<std::uint32_t>(world_.leaves.size()) - door.firstLeaf;
    if (door.opaque && portal.cornerCount >= 3)
        door.filling = addFilling(door, movingObject(MovingThing::Door, index));
    world_.doors.push_back(std::move(door));
}

MovingBody Assembly::addShutBody(const Leaf& leaf, const Portal& portal) {
    const Vec3 block = world_.blocks[portal.block].origin();
    std::vector<Vec3> outline;
    for (const Vec3& p : polygonOf(world_, portal))
        outline.push_back(p - block); // exact: they are corners of this block
    const Mat3 turn = turnedTo(leaf.yaw);
    MovingBody body{static_cast<std::uint32_t>(world_.movingParts.size()), leaf.body.partCount, {}};
    for (std::uint32_t p = leaf.body.firstPart; p < leaf.body.firstPart + leaf.body.partCount; ++p) {
        Instance part = world_.movingParts[p];
        const Placement placement{turn * Mat3(part.linear), leaf.hinge - block + turn * Vec3(part.origin)};
        const auto number = static_cast<std::uint32_t>(world_.movingParts.size());
        part.mesh = arena_.add(placedBetween(outline, models_.part(part.record)->mesh, placement),
                               contentKey(MeshSource::ShutPane, part.record, number));
        part.bounds = world_.meshes[part.mesh].bounds;
        part.block = portal.block;
        part.linear = glm::mat3(1.0f);
        part.origin = Vec3f(0.0f);
        world_.movingParts.push_back(part);
    }
    return body;
}

std::uint32_t Assembly::addFilling(const Door& door, std::uint64_t object) {
    const Portal& portal = world_.portals[door.portal];
    Instance filling;
    filling.kind = InstanceKind::Filling;
    filling.mesh =
        arena_.add(fillingMesh(world_, portal, world_.blocks[portal.block].origin()),
                   contentKey(MeshSource::Filling, world_.spaces[portal.space].cellId, portal.recordIndex));
    filling.bounds = world_.meshes[filling.mesh].bounds;
    filling.block = portal.block;
    filling.object = object;
    if (door.leafCount > 0 && world_.leaves[door.firstLeaf].body.partCount > 0) {
        // What little shows of it beside the leaf looks like the leaf.
        const Instance& leaf = world_.movingParts[world_.leaves[door.firstLeaf].body.firstPart];
        filling.record = leaf.record;
        filling.firstMaterial = leaf.firstMaterial;
    } else {
        filling.firstMaterial = plainMaterial(Vec4f(0.12f, 0.09f, 0.07f, 1.0f), SurfaceClass::Opaque);
    }
    world_.movingParts.push_back(filling);
    return static_cast<std::uint32_t>(world_.movingParts.size() - 1);
}

std::uint32_t Assembly::plainMaterial(const Vec4f& colour, SurfaceClass surfaces) {
    Material material;
    material.colour = colour;
    material.surfaceClass = surfaces;
    material.flags = surfaces == SurfaceClass::Blended ? Material::kAlpha : 0;
    world_.materials.push_back(material);
    world_.materialRefs.push_back(static_cast<std::uint32_t>(world_.materials.size() - 1));
    return static_cast<std::uint32_t>(world_.materialRefs.size() - 1);
}

void Assembly::addVillagers(const MovingEntries& moving) {
    for (std::size_t i = 0; i < moving.villagers.size(); ++i) {
        const VillagerEntry& entry = moving.villagers[i];
        const auto route = std::find_if(moving.routes.begin(), moving.routes.end(),
                                        [&](const RouteEntry& r) { return r.name == entry.route; });
        if (route == moving.routes.end()) {
            world_.findings.push_back(
                {0, "world.json: villager \"" + entry.name + "\" walks a route that is not there"});
            continue;
        }
        Villager villager;
        villager.name = entry.name;
        villager.speed = entry.speed;
        villager.start = entry.start;
        villager.route = addRoute(*route);
        if (villager.route == kNone)
            continue;
        villager.body = addBody(entry.model, InstanceKind::Dynamic, movingObject(MovingThing::Villager, i),
                                dressOf(entry.model, entry.clothing, records_));
        world_.villagers.push_back(std::move(villager));
        addSources(static_cast<std::uint32_t>(world_.villagers.size() - 1), entry.model, entry.play);
    }
}

/// Routes with a point in a cell or on ground that is not loaded are left out.
std::uint32_t Assembly::addRoute(const RouteEntry& entry) {
    Route route;
    route.firstPoint = static_cast<std::uint32_t>(world_.routePoints.size());
    route.pointCount = static_cast<std::uint32_t>(entry.points.size());
    route.loop = entry.loop;
    std::vector<RoutePoint> points;
    for (const RouteEntry::Point& point : entry.points) {
        const SpaceIndex space = point.cell == 0 ? kOutside : findCell(world_, point.cell);
        if (space == kNone || (space == kOutside && findBlock(world_, blockAt(point.position)) == nullptr))
            return kNone;
        if (!points.empty())
            route.length += glm::length(point.position - points.back().position) * (entry.loop ? 1.0 : 2.0);
        points.push_back({point.position, space});
    }
    if (entry.loop)
        route.length += glm::length(points.front().position - points.back().position);
    if (!(route.length > 0.0))
        return kNone;
    world_.routePoints.insert(world_.routePoints.end(), points.begin(), points.end());
    world_.routes.push_back(route);
    return static_cast<std::uint32_t>(world_.routes.size() - 1);
}

std::uint32_t Assembly::addSprite(std::uint32_t firstMaterial, std::uint32_t key) {
    const Material& material = world_.materials[world_.materialRefs[firstMaterial]];
    const SurfaceList surfaces = listOf(material.surfaceClass, (material.flags & Material::kSplit) != 0);
    Instance sprite;
    sprite.kind = InstanceKind::Dynamic;
    sprite.mesh =
        arena_.add(spriteMesh(surfaces, Vec2f(-0.5f), Vec2f(0.5f)), contentKey(MeshSource::Sprite, key));
    sprite.bounds = world_.meshes[sprite.mesh].bounds;
    sprite.object = movingObject(MovingThing::Sprite, key);
    sprite.firstMaterial = firstMaterial;
    world_.movingParts.push_back(sprite);
    return static_cast<std::uint32_t>(world_.movingParts.size() - 1);
}

void Assembly::addEmitter(const EmitterEntry& entry) {
    Emitter emitter;
    emitter.name = entry.name;
    emitter.position = entry.position;
    if (!entry.attachedTo.empty()) {
        const auto found = std::find_if(world_.villagers.begin(), world_.villagers.end(),
                                        [&](const Villager& v) { return v.name == entry.attachedTo; });
        if (found == world_.villagers.end())
            return;
        emitter.villager = static_cast<std::uint32_t>(found - world_.villagers.begin());
    } else {
        emitter.space = entry.cell == 0 ? kOutside : findCell(world_, entry.cell);
        const bool there = emitter.space != kNone && (emitter.space != kOutside ||
                                                      findBlock(world_, blockAt(entry.position)) != nullptr);
        if (!there)
            return;
    }
    emitter.rate = entry.rate;
    emitter.life = entry.life;
    emitter.velocity = entry.velocity;
    emitter.acceleration = entry.acceleration;
    emitter.spread = entry.spread;
    emitter.radius = entry.radius;
    std::copy(entry.size.begin(), entry.size.end(), emitter.size);
    std::copy(entry.alpha.begin(), entry.alpha.end(), emitter.alpha);
    emitter.seed = entry.seed;
    emitter.reach = entry.radius +
                    (glm::length(entry.velocity) + std::sqrt(3.0) * entry.spread) * entry.life +
                    0.5 * glm::length(entry.acceleration) * entry.life * entry.life +
                    std::max(entry.size[0], entry.size[1]);
    const dat::RecordId surfaces[] = {entry.surface};
    emitter.sprite =
        addSprite(materialRun(surfaces, {true}), static_cast<std::uint32_t>(world_.emitters.size()));
    world_.emitters.push_back(std::move(emitter));
}

void Assembly::addMoving(const MovingEntries& moving) {
    for (std::size_t i = 0; i < moving.doors.size(); ++i)
        addDoor(moving.doors[i], i);
    addVillagers(moving);
    for (const EmitterEntry& entry : moving.emitters)
        addEmitter(entry);
    if (region_ != nullptr)
        world_.rainDrop =
            addSprite(plainMaterial(Vec4f(0.75f, 0.8f, 0.88f, 0.35f), SurfaceClass::Blended), kNone);
    if (moving.player != 0)
        addPlayer(moving.player, dressOf(moving.player, moving.playerClothing, records_));
}

/// By portal: shut when every opaque door is closed.
std::vector<std::uint8_t> Assembly::allShut() const {
    std::vector<std::uint8_t> shut(world_.portals.size(), 0);
    for (const Door& door : world_.doors) {
        if (!door.opaque)
            continue;
        shut[door.portal] = 1;
        if (door.reciprocal != kNone)
            shut[door.reciprocal] = 1;
    }
    return shut;
}

} // namespace limen::world
