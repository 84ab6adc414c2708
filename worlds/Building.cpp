#include "worlds/Building.h"

#include "core/Assert.h"
#include "worlds/Bsp.h"
#include "worlds/Sight.h"

#include <map>
#include <set>

namespace limen::worlds {

namespace {

constexpr std::uint16_t kNowhere = 0xFFFE; ///< no such cell

using PointSet = std::set<std::array<double, 3>>;
PointSet pointSet(const Face& face) {
    PointSet out;
    for (const Vec3& p : face.points)
        out.insert({p.x, p.y, p.z});
    return out;
}

std::vector<const Face*> portalsOf(const std::vector<Face>& faces) {
    std::vector<const Face*> out;
    for (const Face& face : faces)
        if (face.portal)
            out.push_back(&face);
    return out;
}

/// Pairs portal faces with the same points. What no other cell has leads outside.
std::vector<std::vector<PortalLink>> linkCells(const std::vector<CellPlan>& cells) {
    std::map<PointSet, std::vector<PortalLink>> byPoints;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        std::uint16_t k = 0;
        for (const Face* portal : portalsOf(cells[c].faces))
            byPoints[pointSet(*portal)].push_back({static_cast<std::uint16_t>(c), k++});
    }
    std::vector<std::vector<PortalLink>> links;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        std::vector<PortalLink> own;
        for (const Face* portal : portalsOf(cells[c].faces)) {
            PortalLink link{dat::kOutdoors, dat::kNoPortal};
            for (const PortalLink& there : byPoints.at(pointSet(*portal)))
                link = there.cell == c ? link : there;
            own.push_back(link);
        }
        links.push_back(std::move(own));
    }
    return links;
}

std::vector<std::uint16_t> reachable(const std::vector<std::vector<PortalLink>>& links, std::uint16_t from) {
    std::vector<std::uint16_t> order{from};
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (const PortalLink& link : links[order[i]])
            if (link.cell != dat::kOutdoors &&
                std::find(order.begin(), order.end(), link.cell) == order.end())
                order.push_back(link.cell);
    }
    std::sort(order.begin(), order.end());
    return order;
}

/// A cell's shape; polygon ids are face indices.
dat::CellStruct shapeOf(const CellPlan& cell, EncodedMesh& mesh) {
    dat::CellStruct shape;
    for (std::size_t i = 0; i < cell.faces.size(); ++i)
        if (cell.faces[i].portal)
            shape.portalPolygons.push_back(static_cast<std::uint16_t>(i));
    shape.cellBsp = buildCellBsp(cell.faces);
    PhysicsMesh physics = physicsOf(cell.faces, mesh.polygons);
    shape.physicsPolygons = std::move(physics.polygons);
    shape.physicsBsp = std::move(physics.tree);
    shape.drawingBsp = buildDrawingBsp(cell.faces);
    shape.vertexArray = std::move(mesh.vertexArray);
    shape.polygons = std::move(mesh.polygons);
    return shape;
}

SightMap sightMapOf(const std::vector<CellPlan>& cells, const std::vector<std::vector<PortalLink>>& links) {
    SightMap map;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        SightMap::Cell cell;
        const std::vector<const Face*> portals = portalsOf(cells[c].faces);
        for (const Face& face : cells[c].faces)
            cell.planes.push_back(planeOf(face.points));
        for (std::size_t k = 0; k < portals.size(); ++k) {
            const bool outside = links[c][k].cell == dat::kOutdoors;
            cell.portals.push_back({portals[k]->points, outside ? SightMap::kOutside : links[c][k].cell});
        }
        map.cells.push_back(std::move(cell));
    }
    return map;
}

} // namespace

namespace {

/// The exit portal that has the same points as a building's opening.
PortalLink exitBehind(const Face& opening, const std::vector<CellPlan>& cells,
                      const std::vector<std::vector<PortalLink>>& links) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::vector<const Face*> portals = portalsOf(cells[c].faces);
        for (std::size_t k = 0; k < portals.size(); ++k)
            if (links[c][k].cell == dat::kOutdoors && pointSet(*portals[k]) == pointSet(opening))
                return {static_cast<std::uint16_t>(c), static_cast<std::uint16_t>(k)};
    }
    return {kNowhere, dat::kNoPortal};
}

std::size_t countExits(const std::vector<std::vector<PortalLink>>& links) {
    std::size_t exits = 0;
    for (const std::vector<PortalLink>& own : links) {
        exits += static_cast<std::size_t>(std::count_if(
            own.begin(), own.end(), [](const PortalLink& l) { return l.cell == dat::kOutdoors; }));
    }
    return exits;
}

/// Exterior (if any) and cells get the same vertices along the openings they share.
void joinAtPortals(std::vector<CellPlan>& cells, MeshBuilder* exterior) {
    std::vector<std::vector<Face>*> meshes;
    if (exterior != nullptr)
        meshes.push_back(&exterior->faces());
    for (CellPlan& cell : cells)
        meshes.push_back(&cell.faces);
    closePortalSeams(meshes);
}

} // namespace

CellPlan roomWithOpenings(const RoomSpec& room, const std::vector<Opening>& openings) {
    struct Plane {
        Side side;
        double at;
        Rect rect;
        Material material;
    };
    const Vec3& a = room.min;
    const Vec3& b = room.max;
    const std::array<Plane, 6> sides{{{Side::West, a.x, {a.y, a.z, b.y, b.z}, room.walls},
                                      {Side::East, b.x, {a.y, a.z, b.y, b.z}, room.walls},
                                      {Side::South, a.y, {a.x, a.z, b.x, b.z}, room.walls},
                                      {Side::North, b.y, {a.x, a.z, b.x, b.z}, room.walls},
                                      {Side::Floor, a.z, {a.x, a.y, b.x, b.y}, room.floor},
                                      {Side::Ceiling, b.z, {a.x, a.y, b.x, b.y}, room.ceiling}}};
    CellPlan cell;
    cell.name = room.name;
    for (const Plane& plane : sides) {
        std::vector<Rect> holes;
        for (const Opening& opening : openings)
            if (opening.side == plane.side)
                holes.push_back(opening.rect);
        for (const Rect& rect : withoutHoles(plane.rect, holes))
            cell.faces.push_back(planarFace(rectOnSide(plane.side, plane.at, rect), plane.material));
    }
    for (const Opening& opening : openings) {
        const auto side = static_cast<std::size_t>(opening.side);
        cell.faces.push_back(portalFace(rectOnSide(opening.side, sides[side].at, opening.rect)));
    }
    closeSeams(cell.faces);
    return cell;
}

BlockBuilder::BlockBuilder(ModelSink& sink, dat::BlockCoord coord) : sink_(sink) {
    info_.id = dat::landBlockInfoId(coord);
}

void BlockBuilder::addObject(const Furnishing& object) {
    info_.objects.push_back({object.model, toFrame(object.at)});
}

void BlockBuilder::finish() {
    sink_.records().landBlockInfos.push_back(std::move(info_));
}

dat::EnvCell BlockBuilder::cellRecord(const CellPlan& cell, const std::vector<PortalLink>& links,
                                      std::uint16_t firstCell, const Placement& at) const {
    dat::EnvCell record;
    record.position = toFrame(at);
    for (const PortalLink& link : links) {
        const bool outside = link.cell == dat::kOutdoors;
        dat::CellPortal portal;
        portal.flags = dat::CellPortal::kExactMatch | dat::CellPortal::kPortalSide;
        portal.otherCellId = outside ? dat::kOutdoors : static_cast<std::uint16_t>(firstCell + link.cell);
        portal.otherPortalId = link.portal;
        record.portals.push_back(portal);
    }
    for (const Furnishing& f : cell.statics)
        record.statics.push_back({f.model, toFrame({place(at, f.at.origin), at.turn + f.at.turn})});
    record.flags = cell.statics.empty() ? 0u : dat::EnvCell::kHasStatics;
    return record;
}

std::vector<dat::RecordId> BlockBuilder::addCells(const std::vector<CellPlan>& cells,
                                                  const std::vector<std::vector<PortalLink>>& links,
                                                  const Placement& at) {
    WorldRecords& records = sink_.records();
    const std::vector<bool> trace = cellsThatSeeOutside(sightMapOf(cells, links));
    const auto firstCell = static_cast<std::uint16_t>(dat::kFirstCell + info_.numCells);
    dat::Environment environment;
    environment.id = 0x0D000100u + static_cast<dat::RecordId>(records.environments.size());
    std::vector<dat::RecordId> ids;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        EncodedMesh mesh = encodeMesh(cells[c].faces);
        dat::EnvCell record = cellRecord(cells[c], links[c], firstCell, at);
        record.id = (info_.id & 0xFFFF0000u) | static_cast<dat::RecordId>(firstCell + c);
        record.environment = static_cast<std::uint16_t>(environment.id & 0xFFFF);
        record.cellStructure = static_cast<std::uint16_t>(c);
        record.flags |= trace[c] ? dat::EnvCell::kSeenOutside : 0u;
        for (const dat::RecordId surface : mesh.surfaces)
            record.surfaces.push_back(static_cast<std::uint16_t>(surface & 0xFFFF));
        for (const std::uint16_t other : reachable(links, static_cast<std::uint16_t>(c)))
            record.visibleCells.push_back(static_cast<std::uint16_t>(firstCell + other));
        dat::CellStruct shape = shapeOf(cells[c], mesh);
        for (std::size_t k = 0; k < record.portals.size(); ++k)
            record.portals[k].polygonId = shape.portalPolygons[k];
        ids.push_back(record.id);
        environment.cells.emplace_back(static_cast<std::uint32_t>(c), std::move(shape));
        records.envCells.push_back(std::move(record));
    }
    records.environments.push_back(std::move(environment));
    info_.numCells += static_cast<std::uint32_t>(cells.size());
    return ids;
}

std::vector<dat::RecordId> BlockBuilder::addBuilding(BuildingPlan plan, const Placement& at) {
    joinAtPortals(plan.cells, &plan.exterior);
    const std::vector<std::vector<PortalLink>> links = linkCells(plan.cells);
    const auto firstCell = static_cast<std::uint16_t>(dat::kFirstCell + info_.numCells);
    std::vector<dat::RecordId> ids = addCells(plan.cells, links, at);
    dat::Building building;
    building.model = sink_.addMesh(plan.exterior);
    building.frame = toFrame(at);
    building.numLeaves = leafCount(sink_.records().gfxObjs.back().drawingBsp);
    for (const Face* opening : portalsOf(plan.exterior.faces())) {
        const PortalLink inside = exitBehind(*opening, plan.cells, links);
        LIMEN_ASSERT(inside.cell != kNowhere, "a building portal has no cell behind it");
        dat::BuildingPortal portal;
        portal.flags = dat::CellPortal::kExactMatch | dat::CellPortal::kPortalSide;
        portal.otherCellId = static_cast<std::uint16_t>(firstCell + inside.cell);
        portal.otherPortalId = inside.portal;
        for (const std::uint16_t other : reachable(links, inside.cell))
            portal.stabs.push_back(static_cast<std::uint16_t>(firstCell + other));
        building.portals.push_back(std::move(portal));
    }
    LIMEN_ASSERT(countExits(links) == building.portals.size(),
                 "a cell's opening leads to no other cell and not outside");
    info_.buildings.push_back(std::move(building));
    return ids;
}

std::vector<dat::RecordId> BlockBuilder::addDungeon(std::vector<CellPlan> cells, const Placement& at) {
    joinAtPortals(cells, nullptr);
    const std::vector<std::vector<PortalLink>> links = linkCells(cells);
    LIMEN_ASSERT(countExits(links) == 0, "a cell's opening leads to no other cell");
    return addCells(cells, links, at);
}

} // namespace limen::worlds
