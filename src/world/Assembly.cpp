#include "world/Assembly.h"

#include <algorithm>

// Joining whole blocks. What becomes of single meshes and objects is in AssemblyObjects.cpp.
namespace limen::world {
namespace {

/// Until the number of outdoor portals is known, indices of outdoor portals count down from here.
constexpr PortalIndex kOutdoorPortalMark = 0x80000000u;

Plane toGlobal(const Plane& plane, const Vec3& origin) {
    return {plane.n, plane.d - glm::dot(plane.n, origin)};
}

} // namespace

Assembly::Assembly(Records& records, Models& models, const dat::Region* region, LoadCache* cache)
    : records_(records), models_(models), region_(region), materials_(records, world_, cache), arena_(world_),
      cycles_(records, world_), starts_(records) {
    Space outside;
    outside.zone = kOutsideZone;
    outside.seenOutside = true;
    world_.spaces.push_back(outside);
    world_.zones.push_back({0, 1});
    world_.zoneSpaces.push_back(kOutside);
}

SpaceIndex Assembly::spaceOf(std::uint32_t local) const {
    if (local == kOutdoorSpace)
        return kOutside;
    return local == kNone ? kNone : firstSpace_ + local;
}

void Assembly::add(const BlockContent& block) {
    Block resident;
    resident.coord = block.coord;
    resident.isFar = block.isFar;
    resident.hasTerrain = block.ground.has_value();
    resident.heightIndices = block.heightIndices;
    if (block.ground)
        resident.heights.assign(block.ground->heights.begin(), block.ground->heights.end());
    records_.say(block.said);
    block_ = static_cast<std::uint32_t>(world_.blocks.size());
    world_.blocks.push_back(std::move(resident));
    addSpaces(block);
    addPortals(block);
    addTerrain(block);
    addExteriors(block);
    addShells(block);
    addObjects(block);
    world_.findings.insert(world_.findings.end(), block.findings.begin(), block.findings.end());
}

void Assembly::addSpaces(const BlockContent& block) {
    firstSpace_ = static_cast<SpaceIndex>(world_.spaces.size());
    const Vec3 origin = world_.blocks[block_].origin();
    for (const CellContent& cell : block.cells) {
        Space space;
        space.cellId = cell.id;
        space.block = block_;
        space.seenOutside = cell.seenOutside;
        space.ofBuilding = cell.ofBuilding;
        if (!cell.shape.bounds.empty())
            space.bounds = {cell.shape.bounds.min + origin, cell.shape.bounds.max + origin};
        space.firstBspNode = static_cast<std::uint32_t>(world_.cellBspNodes.size());
        space.bspNodeCount = static_cast<std::uint32_t>(cell.bsp.size());
        for (const CellBspNode& node : cell.bsp)
            world_.cellBspNodes.push_back({toGlobal(node.plane, origin), node.positive, node.negative});
        world_.spaces.push_back(space);
    }
    for (const std::vector<std::uint32_t>& members : block.zones) {
        const auto zone = static_cast<ZoneIndex>(world_.zones.size());
        world_.zones.push_back({static_cast<std::uint32_t>(world_.zoneSpaces.size()),
                                static_cast<std::uint32_t>(members.size())});
        for (const std::uint32_t cell : members) {
            world_.zoneSpaces.push_back(spaceOf(cell));
            world_.spaces[spaceOf(cell)].zone = zone;
        }
    }
}

void Assembly::addPortals(const BlockContent& block) {
    const Vec3 origin = world_.blocks[block_].origin();
    const auto cellBase = static_cast<PortalIndex>(world_.portals.size());
    const auto outdoorBase = kOutdoorPortalMark + static_cast<PortalIndex>(outdoorPortals_.size());
    const auto globalIndex = [&](std::uint32_t local) {
        if (local == kNone)
            return kNone;
        return local < block.firstOutdoorPortal ? cellBase + local
                                                : outdoorBase + (local - block.firstOutdoorPortal);
    };
    for (const PortalContent& content : block.portals) {
        Portal portal;
        portal.space = spaceOf(content.space);
        portal.destination = spaceOf(content.destination);
        portal.reciprocal = globalIndex(content.reciprocal);
        portal.firstVertex = static_cast<std::uint32_t>(world_.portalVertices.size());
        portal.vertexCount = static_cast<std::uint32_t>(content.points.size());
        for (const Vec3& p : content.points)
            world_.portalVertices.push_back(origin + p);
        portal.firstCorner = static_cast<std::uint32_t>(world_.portalCorners.size());
        portal.cornerCount = static_cast<std::uint32_t>(content.corners.size());
        for (const Vec3& p : content.corners)
            world_.portalCorners.push_back(origin + p);
        portal.plane = toGlobal(content.plane, origin);
        portal.block = block_;
        portal.recordIndex = content.recordIndex;
        portal.polygonId = content.polygonId;
        portal.exact = content.exact;
        (content.space == kOutdoorSpace ? outdoorPortals_ : world_.portals).push_back(portal);
    }
    for (std::uint32_t cell = 0; cell < block.cells.size(); ++cell) {
        Space& space = world_.spaces[spaceOf(cell)];
        space.firstPortal = cellBase + block.cells[cell].firstPortal;
        space.portalCount = block.cells[cell].portalCount;
    }
}

void Assembly::gatherOutdoorPortals() {
    const auto count = static_cast<PortalIndex>(outdoorPortals_.size());
    world_.portals.insert(world_.portals.begin(), outdoorPortals_.begin(), outdoorPortals_.end());
    for (Portal& portal : world_.portals) {
        if (portal.reciprocal == kNone)
            continue;
        portal.reciprocal = portal.reciprocal >= kOutdoorPortalMark ? portal.reciprocal - kOutdoorPortalMark
                                                                    : portal.reciprocal + count;
    }
    for (Space& space : world_.spaces)
        space.firstPortal += count;
    world_.spaces[kOutside].firstPortal = 0;
    world_.spaces[kOutside].portalCount = count;
}

void Assembly::findMembers() {
    const Membership membership(world_);
    std::vector<SpaceIndex> reached;
    for (Instance& instance : world_.instances) {
        instance.firstMember = static_cast<std::uint32_t>(world_.members.size());
        instance.memberCount = 1;
        world_.members.push_back(instance.placedIn);
    }
    const std::vector<std::uint8_t> shut = allShut();
    std::vector<SpaceIndex> reachedShut;
    for (const Group& group : objects_) {
        const SpaceIndex placedIn = world_.instances[group.first].placedIn;
        membership.reach(placedIn, group.bounds, {}, reached);
        if (reached.size() == 1)
            continue;
        // Shutting doors only takes spaces away, so what is the same with all shut is the same always.
        membership.reach(placedIn, group.bounds, shut, reachedShut);
        if (reachedShut.size() != reached.size())
            world_.looseObjects.push_back({group.first, group.count, group.bounds});
        const auto first = static_cast<std::uint32_t>(world_.members.size());
        world_.members.insert(world_.members.end(), reached.begin(), reached.end());
        for (InstanceIndex i = group.first; i < group.first + group.count; ++i)
            world_.instances[i].setMembers(first, reached.size());
    }
}

void Assembly::listInstances() {
    std::vector<std::vector<InstanceIndex>> bySpace(world_.spaces.size());
    std::vector<std::uint8_t> loose(world_.instances.size(), 0); // the moment lists these
    for (const LooseObject& object : world_.looseObjects)
        std::fill_n(loose.begin() + object.firstInstance, object.instanceCount, std::uint8_t{1});
    for (InstanceIndex i = 0; i < world_.instances.size(); ++i) {
        const Instance& instance = world_.instances[i];
        if (loose[i] != 0)
            continue;
        for (std::uint32_t m = 0; m < instance.memberCount; ++m) {
            std::vector<InstanceIndex>& list = bySpace[world_.members[instance.firstMember + m]];
            if (instance.kind == InstanceKind::Shell)
                list.insert(list.begin(), i);
            else
                list.push_back(i);
        }
    }
    for (std::size_t i = 0; i < world_.spaces.size(); ++i) {
        world_.spaces[i].firstInstance = static_cast<std::uint32_t>(world_.spaceInstances.size());
        world_.spaces[i].instanceCount = static_cast<std::uint32_t>(bySpace[i].size());
        world_.spaceInstances.insert(world_.spaceInstances.end(), bySpace[i].begin(), bySpace[i].end());
    }
}

void Assembly::numberPolygons() {
    for (Instance& instance : world_.instances) {
        instance.idBase = world_.idEnd;
        world_.idEnd += world_.meshes[instance.mesh].polygonCount;
    }
    for (Instance& part : world_.movingParts) {
        part.idBase = world_.idEnd;
        world_.idEnd += world_.meshes[part.mesh].polygonCount;
    }
    world_.spriteIds = world_.idEnd;
    world_.idEnd += kMostSprites;
}

World Assembly::finish(const MovingEntries& moving) {
    gatherOutdoorPortals();
    addMoving(moving);
    addWeather();
    findMembers();
    findAloneness();
    listInstances();
    numberPolygons();
    lightSpaces(lamps_, world_);
    addSky();
    world_.findings.insert(world_.findings.end(), records_.findings().begin(), records_.findings().end());
    return std::move(world_);
}

} // namespace limen::world
