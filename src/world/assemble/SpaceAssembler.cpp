#include "world/assemble/SpaceAssembler.h"

namespace limen::world {
namespace {

/// Until finish(), the n-th portal of the outside has the index kOutdoorPortalMark + n.
constexpr PortalIndex kOutdoorPortalMark = 0x80000000u;

Plane toGlobal(const Plane& plane, const Vec3& origin) {
    return {plane.n, plane.d - glm::dot(plane.n, origin)};
}

bool isBefore(dat::BlockCoord a, dat::BlockCoord b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

} // namespace

SpaceAssembler::SpaceAssembler(World& world) : world_(world) {
    LIMEN_ASSERT(world.spaces.empty() && world.zones.empty(), "the world is new");
    Space outside;
    outside.zone = kOutsideZone;
    outside.seenOutside = true;
    world_.spaces.push_back(outside);
    world_.zones.push_back({0, 1});
    world_.zoneSpaces.push_back(kOutside);
}

JoiningBlock SpaceAssembler::add(const BlockContent& content) {
    addBlock(content);
    JoiningBlock block{content, static_cast<std::uint32_t>(world_.blocks.size() - 1),
                       static_cast<SpaceIndex>(world_.spaces.size()), world_.blocks.back().origin()};
    addCells(block);
    addZones(block);
    addPortals(block);
    return block;
}

void SpaceAssembler::addBlock(const BlockContent& content) {
    LIMEN_ASSERT(world_.blocks.empty() || isBefore(world_.blocks.back().coord, content.coord),
                 "blocks are added in ascending order");
    Block block;
    block.coord = content.coord;
    block.isFar = content.isFar;
    block.hasTerrain = content.ground.has_value();
    block.heightIndices = content.heightIndices;
    if (content.ground)
        block.heights.assign(content.ground->heights.begin(), content.ground->heights.end());
    world_.blocks.push_back(std::move(block));
}

void SpaceAssembler::addCells(const JoiningBlock& block) {
    for (const CellContent& cell : block.content.cells) {
        LIMEN_ASSERT(cell.id > world_.spaces.back().cellId, "cells are in ascending order");
        Space space;
        space.cellId = cell.id;
        space.block = block.index;
        space.origin = cell.origin + block.origin;
        space.seenOutside = cell.seenOutside;
        space.ofBuilding = cell.ofBuilding;
        if (!cell.shape.bounds.empty())
            space.bounds = {cell.shape.bounds.min + block.origin, cell.shape.bounds.max + block.origin};
        space.firstBspNode = static_cast<std::uint32_t>(world_.cellBspNodes.size());
        space.bspNodeCount = static_cast<std::uint32_t>(cell.bsp.size());
        for (const CellBspNode& node : cell.bsp)
            world_.cellBspNodes.push_back({toGlobal(node.plane, block.origin), node.positive, node.negative});
        world_.spaces.push_back(space);
    }
}

void SpaceAssembler::addZones(const JoiningBlock& block) {
    for (const std::vector<std::uint32_t>& cells : block.content.zones) {
        const auto zone = static_cast<ZoneIndex>(world_.zones.size());
        world_.zones.push_back(
            {static_cast<std::uint32_t>(world_.zoneSpaces.size()), static_cast<std::uint32_t>(cells.size())});
        for (const std::uint32_t cell : cells) {
            const SpaceIndex space = block.spaceOf(cell);
            LIMEN_ASSERT(world_.spaces[space].zone == kNone, "a cell is in one zone");
            world_.zoneSpaces.push_back(space);
            world_.spaces[space].zone = zone;
        }
    }
    for (SpaceIndex space = block.firstSpace; space < world_.spaces.size(); ++space)
        LIMEN_ASSERT(world_.spaces[space].zone != kNone, "every cell is in a zone");
}

Portal SpaceAssembler::portalOf(const JoiningBlock& block, const PortalContent& content) {
    Portal portal;
    portal.space = block.spaceOf(content.space);
    portal.destination = block.spaceOf(content.destination);
    portal.firstVertex = static_cast<std::uint32_t>(world_.portalVertices.size());
    portal.vertexCount = static_cast<std::uint32_t>(content.points.size());
    for (const Vec3& p : content.points)
        world_.portalVertices.push_back(block.origin + p);
    portal.firstCorner = static_cast<std::uint32_t>(world_.portalCorners.size());
    portal.cornerCount = static_cast<std::uint32_t>(content.corners.size());
    for (const Vec3& p : content.corners)
        world_.portalCorners.push_back(block.origin + p);
    portal.plane = toGlobal(content.plane, block.origin);
    portal.block = block.index;
    portal.recordIndex = content.recordIndex;
    portal.polygonId = content.polygonId;
    portal.exact = content.exact;
    portal.walled = content.walled;
    portal.part = content.part;
    portal.partCount = content.partCount;
    return portal;
}

void SpaceAssembler::addPortals(const JoiningBlock& block) {
    const std::uint32_t firstOutdoor = block.content.firstOutdoorPortal;
    const auto cellBase = static_cast<PortalIndex>(world_.portals.size());
    const auto outdoorBase = kOutdoorPortalMark + static_cast<PortalIndex>(outdoorPortals_.size());
    const auto globalIndex = [&](std::uint32_t local) {
        if (local == kNone)
            return kNone;
        return local < firstOutdoor ? cellBase + local : outdoorBase + (local - firstOutdoor);
    };
    const auto firstWhole = static_cast<std::uint32_t>(world_.wholes.size());
    for (const PortalContent& whole : block.content.wholes)
        world_.wholes.push_back(portalOf(block, whole));
    for (std::size_t i = 0; i < block.content.portals.size(); ++i) {
        const PortalContent& content = block.content.portals[i];
        LIMEN_ASSERT((content.space == kOutdoorSpace) == (i >= firstOutdoor),
                     "the outside's portals come last");
        Portal portal = portalOf(block, content);
        portal.reciprocal = globalIndex(content.reciprocal);
        if (content.whole != kNone)
            portal.whole = firstWhole + content.whole;
        (content.space == kOutdoorSpace ? outdoorPortals_ : world_.portals).push_back(portal);
    }
    for (std::uint32_t cell = 0; cell < block.content.cells.size(); ++cell) {
        Space& space = world_.spaces[block.spaceOf(cell)];
        space.firstPortal = cellBase + block.content.cells[cell].firstPortal;
        space.portalCount = block.content.cells[cell].portalCount;
        LIMEN_ASSERT(space.firstPortal + space.portalCount <= world_.portals.size(),
                     "a cell's portals are a run of the block's");
    }
}

void SpaceAssembler::finish() {
    const auto count = static_cast<PortalIndex>(outdoorPortals_.size());
    world_.portals.insert(world_.portals.begin(), outdoorPortals_.begin(), outdoorPortals_.end());
    outdoorPortals_.clear();
    for (Portal& portal : world_.portals) {
        if (portal.reciprocal == kNone)
            continue;
        portal.reciprocal = portal.reciprocal >= kOutdoorPortalMark ? portal.reciprocal - kOutdoorPortalMark
                                                                    : portal.reciprocal + count;
        LIMEN_ASSERT(portal.reciprocal < world_.portals.size(), "a way back is a portal");
    }
    for (Space& space : world_.spaces)
        space.firstPortal += count;
    world_.spaces[kOutside].firstPortal = 0;
    world_.spaces[kOutside].portalCount = count;
    for (PortalIndex p = 0; p < world_.portals.size(); ++p)
        LIMEN_ASSERT(world_.portals[p].reciprocal == kNone ||
                         world_.portals[world_.portals[p].reciprocal].reciprocal == p,
                     "the way back of a way back is the portal itself");
}

} // namespace limen::world
