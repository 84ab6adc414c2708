#include "worlds/generate/BlockPlan.h"

#include "core/Assert.h"
#include "worlds/Bsp.h"

#include <algorithm>

namespace limen::worlds {

namespace {

/// Openings that lists of visible cells look through, and that daylight is taken to reach through.
constexpr std::size_t kListSteps = 3;

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours neighboursOf(const std::vector<PlannedCell>& cells) {
    Neighbours out;
    for (const PlannedCell& cell : cells) {
        std::vector<std::uint32_t> next;
        for (const PlannedPortal& portal : cell.portals)
            if (portal.cell != PlannedPortal::kOutside)
                next.push_back(portal.cell);
        out.push_back(std::move(next));
    }
    return out;
}

bool leadsOutside(const PlannedCell& cell) {
    return std::any_of(cell.portals.begin(), cell.portals.end(),
                       [](const PlannedPortal& p) { return p.cell == PlannedPortal::kOutside; });
}

std::vector<bool> outwardPortals(const PlannedCell& cell) {
    std::vector<bool> out;
    for (const PlannedPortal& portal : cell.portals)
        out.push_back(!portal.insidePositive);
    return out;
}

dat::CellPortal portalRecord(const PlannedPortal& portal, std::uint16_t firstCell, std::uint16_t polygon) {
    const bool outside = portal.cell == PlannedPortal::kOutside;
    dat::CellPortal record;
    record.flags = static_cast<std::uint16_t>((portal.exact ? dat::CellPortal::kExactMatch : 0) |
                                              (portal.insidePositive ? dat::CellPortal::kPortalSide : 0));
    record.polygonId = polygon;
    record.otherCellId = outside ? dat::kOutdoors : static_cast<std::uint16_t>(firstCell + portal.cell);
    record.otherPortalId = portal.portal;
    return record;
}

dat::Building buildingRecord(const CellsPlan& plan, const Neighbours& neighbours, std::uint16_t firstCell) {
    dat::Building building;
    for (const CellsPlan::Exit& exit : plan.exits) {
        dat::BuildingPortal portal;
        portal.flags = dat::CellPortal::kExactMatch | dat::CellPortal::kPortalSide;
        portal.otherCellId = static_cast<std::uint16_t>(firstCell + exit.cell);
        portal.otherPortalId = exit.portal;
        for (const std::uint32_t other : cellsWithin(neighbours, exit.cell, kListSteps))
            portal.stabs.push_back(static_cast<std::uint16_t>(firstCell + other));
        building.portals.push_back(std::move(portal));
    }
    return building;
}

} // namespace

std::vector<std::uint32_t> cellsWithin(const Neighbours& neighbours, std::uint32_t cell, std::size_t steps) {
    std::vector<std::uint32_t> found{cell};
    std::size_t begin = 0;
    for (std::size_t step = 0; step < steps; ++step) {
        const std::size_t end = found.size();
        for (; begin < end; ++begin) {
            for (const std::uint32_t next : neighbours[found[begin]])
                if (std::find(found.begin(), found.end(), next) == found.end())
                    found.push_back(next);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

PlanWriter::PlanWriter(ModelSink& sink, ShapeLibrary& shapes, dat::BlockCoord coord)
    : sink_(sink), shapes_(shapes) {
    info_.id = dat::landBlockInfoId(coord);
}

dat::RecordId PlanWriter::add(CellsPlan plan, const Placement& at) {
    const auto firstCell = static_cast<std::uint16_t>(dat::kFirstCell + info_.numCells);
    LIMEN_ASSERT(dat::kFirstCell + info_.numCells + plan.cells.size() <= dat::kLastCell + 1u,
                 "too many cells for one landblock");
    const Neighbours neighbours = neighboursOf(plan.cells);
    for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
        const PlannedCell& cell = plan.cells[c];
        const StoredShape shape = shapes_.add(cell.faces, cell.eye, outwardPortals(cell));
        LIMEN_ASSERT(shape.portalPolygons.size() == cell.portals.size(), "one portal face for each portal");
        dat::EnvCell record;
        record.id = (info_.id & 0xFFFF0000u) | (firstCell + c);
        record.environment = shape.environment;
        record.cellStructure = shape.structure;
        record.surfaces = shape.surfaces;
        record.position = toFrame(at);
        for (std::size_t k = 0; k < cell.portals.size(); ++k)
            record.portals.push_back(portalRecord(cell.portals[k], firstCell, shape.portalPolygons[k]));
        bool seesOutside = false;
        for (const std::uint32_t other : cellsWithin(neighbours, c, kListSteps)) {
            seesOutside = seesOutside || leadsOutside(plan.cells[other]);
            record.visibleCells.push_back(static_cast<std::uint16_t>(firstCell + other));
        }
        for (const Furnishing& f : cell.statics)
            record.statics.push_back({f.model, toFrame({place(at, f.at.origin), at.turn + f.at.turn})});
        record.flags = (seesOutside ? dat::EnvCell::kSeenOutside : 0u) |
                       (cell.statics.empty() ? 0u : dat::EnvCell::kHasStatics);
        sink_.records().envCells.push_back(std::move(record));
    }
    info_.numCells += static_cast<std::uint32_t>(plan.cells.size());
    if (!plan.exits.empty()) {
        closeSeams(plan.exterior.faces(), finestGrid(plan.exterior.faces()));
        dat::Building building = buildingRecord(plan, neighbours, firstCell);
        building.model = sink_.addMesh(plan.exterior);
        building.frame = toFrame(at);
        building.numLeaves = leafCount(sink_.records().gfxObjs.back().drawingBsp);
        info_.buildings.push_back(std::move(building));
    }
    return (info_.id & 0xFFFF0000u) | firstCell;
}

} // namespace limen::worlds
