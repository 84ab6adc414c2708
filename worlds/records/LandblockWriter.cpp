#include "worlds/records/LandblockWriter.h"

#include "core/Assert.h"
#include "worlds/records/Bsp.h"
#include "worlds/records/Sight.h"
#include "worlds/records/SolidTree.h"

#include <algorithm>
#include <limits>

namespace limen::worlds {

namespace {

bool leadsOutside(const CellPlan& cell) {
    return std::any_of(cell.links.begin(), cell.links.end(),
                       [](const CellLink& link) { return link.cell == CellLink::kOutside; });
}

SightMap sightMapOf(const std::vector<CellPlan>& cells) {
    SightMap map;
    for (const CellPlan& plan : cells) {
        SightMap::Cell cell;
        for (const Face& face : plan.faces) {
            cell.planes.push_back(planeOf(face.points));
            if (face.portal) {
                const std::uint32_t to = plan.links.at(cell.portals.size()).cell;
                cell.portals.push_back({face.points, to == CellLink::kOutside ? SightMap::kOutside : to});
            }
        }
        map.cells.push_back(std::move(cell));
    }
    return map;
}

std::vector<Furnishing> placedStatics(const CellPlan& cell, const Placement& at) {
    std::vector<Furnishing> out;
    for (const Furnishing& f : cell.statics)
        out.push_back({f.model, {place(at, f.at.origin), at.turn + f.at.turn}});
    return out;
}

std::vector<std::uint16_t> wordsOf(std::span<const std::uint32_t> cells, std::uint16_t firstCell) {
    std::vector<std::uint16_t> words;
    for (const std::uint32_t cell : cells)
        words.push_back(static_cast<std::uint16_t>(firstCell + cell));
    return words;
}

dat::CellPortal portalRecord(const CellLink& link, std::uint16_t firstCell, std::uint16_t polygon) {
    const bool outside = link.cell == CellLink::kOutside;
    dat::CellPortal record;
    record.flags = static_cast<std::uint16_t>((link.exact ? dat::CellPortal::kExactMatch : 0) |
                                              (link.insidePositive ? dat::CellPortal::kPortalSide : 0));
    record.polygonId = polygon;
    record.otherCellId = outside ? dat::kOutdoors : static_cast<std::uint16_t>(firstCell + link.cell);
    record.otherPortalId = link.portal;
    return record;
}

dat::EnvCell cellRecord(const PlacedCell& cell, std::uint16_t firstCell) {
    LIMEN_ASSERT(cell.shape.portalPolygons.size() == cell.links.size(),
                 "one link for each portal of the shape");
    dat::EnvCell record;
    record.environment = cell.shape.environment;
    record.cellStructure = cell.shape.structure;
    record.surfaces = cell.shape.surfaces;
    record.position = toFrame(cell.at);
    for (std::size_t k = 0; k < cell.links.size(); ++k)
        record.portals.push_back(portalRecord(cell.links[k], firstCell, cell.shape.portalPolygons[k]));
    record.visibleCells = wordsOf(cell.visible, firstCell);
    for (const Furnishing& f : cell.statics)
        record.statics.push_back({f.model, toFrame(f.at)});
    record.flags = (cell.seesOutside ? dat::EnvCell::kSeenOutside : 0u) |
                   (cell.statics.empty() ? 0u : dat::EnvCell::kHasStatics);
    return record;
}

} // namespace

LandblockWriter::LandblockWriter(ModelWriter& models, dat::BlockCoord coord, const CellRules& rules)
    : models_(models), rules_(rules),
      shapes_(rules.environmentPerPlan
                  ? ShapeLibrary(models.records(), std::numeric_limits<std::size_t>::max())
                  : ShapeLibrary(models.records())) {
    info_.id = dat::landBlockInfoId(coord);
}

void LandblockWriter::addObject(const Furnishing& object) {
    info_.objects.push_back({object.model, toFrame(object.at)});
}

void LandblockWriter::finish() {
    models_.records().landBlockInfos.push_back(std::move(info_));
}

std::vector<dat::RecordId> LandblockWriter::addCells(std::span<const PlacedCell> cells) {
    LIMEN_ASSERT(dat::kFirstCell + info_.numCells + cells.size() <= dat::kLastCell + 1u,
                 "too many cells for one landblock");
    const std::uint16_t firstCell = firstFreeCell();
    std::vector<dat::RecordId> ids;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        dat::EnvCell record = cellRecord(cells[c], firstCell);
        record.id = (info_.id & 0xFFFF0000u) | (firstCell + c);
        ids.push_back(record.id);
        models_.records().envCells.push_back(std::move(record));
    }
    info_.numCells += static_cast<std::uint32_t>(cells.size());
    return ids;
}

std::vector<dat::RecordId> LandblockWriter::add(const BuildingPlan& plan, const Placement& at) {
    const std::uint16_t firstCell = firstFreeCell();
    const Neighbours neighbours = neighboursOf(plan.cells);
    const std::vector<bool> daylight = cellsWithDaylight(plan.cells, neighbours);
    if (rules_.environmentPerPlan)
        shapes_.startEnvironment();
    std::vector<PlacedCell> placed;
    for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
        const CellPlan& cell = plan.cells[c];
        placed.push_back({store(cell), at, cell.links, placedStatics(cell, at),
                          cellsWithin(neighbours, c, rules_.listSteps), daylight[c]});
    }
    std::vector<dat::RecordId> ids = addCells(placed);
    if (!plan.exits.empty())
        addBuilding(plan, neighbours, firstCell, at);
    return ids;
}

std::vector<bool> LandblockWriter::cellsWithDaylight(const std::vector<CellPlan>& cells,
                                                     const Neighbours& neighbours) const {
    if (rules_.samplesDaylight)
        return cellsThatSeeOutside(sightMapOf(cells));
    std::vector<bool> out;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const std::vector<std::uint32_t> near = cellsWithin(neighbours, c, rules_.listSteps);
        out.push_back(std::any_of(near.begin(), near.end(),
                                  [&](std::uint32_t other) { return leadsOutside(cells[other]); }));
    }
    return out;
}

StoredShape LandblockWriter::store(const CellPlan& cell) {
    std::vector<bool> outward;
    for (const CellLink& link : cell.links)
        outward.push_back(!link.insidePositive);
    const bool chain = rules_.tree == CellRules::Tree::Chain;
    return shapes_.add(cell.faces, chain ? buildCellBsp(cell.faces) : buildSolidCellBsp(cell.faces, cell.eye),
                       outward);
}

void LandblockWriter::addBuilding(const BuildingPlan& plan, const Neighbours& neighbours,
                                  std::uint16_t firstCell, const Placement& at) {
    dat::Building building;
    building.model = models_.addMesh(plan.exterior);
    building.frame = toFrame(at);
    building.numLeaves = leafCount(models_.records().gfxObjs.back().drawingBsp);
    for (const BuildingPlan::Exit& exit : plan.exits) {
        dat::BuildingPortal portal;
        portal.flags = dat::CellPortal::kExactMatch | dat::CellPortal::kPortalSide;
        portal.otherCellId = static_cast<std::uint16_t>(firstCell + exit.cell);
        portal.otherPortalId = exit.portal;
        portal.stabs = wordsOf(cellsWithin(neighbours, exit.cell, rules_.listSteps), firstCell);
        building.portals.push_back(std::move(portal));
    }
    info_.buildings.push_back(std::move(building));
}

} // namespace limen::worlds
