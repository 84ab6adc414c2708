#include "worlds/records/CellPlan.h"

#include "core/Assert.h"
#include "worlds/records/Seams.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace limen::worlds {

namespace {

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

/// Exterior (if any) and cells get the same vertices along the openings they share.
void joinAtPortals(BuildingPlan& plan) {
    std::vector<std::vector<Face>*> meshes;
    if (!plan.exterior.faces().empty())
        meshes.push_back(&plan.exterior.faces());
    for (CellPlan& cell : plan.cells)
        meshes.push_back(&cell.faces);
    closePortalSeams(meshes);
}

/// Pairs portal faces of cells. A portal face that no other cell has leads outside.
void linkCells(std::vector<CellPlan>& cells) {
    std::map<PointSet, std::vector<CellLink>> byPoints;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        std::uint16_t k = 0;
        for (const Face* portal : portalsOf(cells[c].faces))
            byPoints[pointSet(*portal)].push_back({c, k++});
    }
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        for (const Face* portal : portalsOf(cells[c].faces)) {
            CellLink link;
            for (const CellLink& there : byPoints.at(pointSet(*portal)))
                link = there.cell == c ? link : there;
            cells[c].links.push_back(link);
        }
    }
}

/// The portal that has the same points as an opening of the exterior.
BuildingPlan::Exit exitBehind(const Face& opening, const std::vector<CellPlan>& cells) {
    const PointSet points = pointSet(opening);
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const std::vector<const Face*> portals = portalsOf(cells[c].faces);
        for (std::uint16_t k = 0; k < portals.size(); ++k)
            if (cells[c].links[k].cell == CellLink::kOutside && pointSet(*portals[k]) == points)
                return {c, k};
    }
    LIMEN_ASSERT(false, "a building portal has no cell behind it");
    return {};
}

std::size_t countExits(const std::vector<CellPlan>& cells) {
    std::size_t exits = 0;
    for (const CellPlan& cell : cells) {
        exits += static_cast<std::size_t>(
            std::count_if(cell.links.begin(), cell.links.end(),
                          [](const CellLink& l) { return l.cell == CellLink::kOutside; }));
    }
    return exits;
}

} // namespace

BuildingPlan linkedByPoints(BuildingPlan plan) {
    joinAtPortals(plan);
    linkCells(plan.cells);
    for (const Face* opening : portalsOf(plan.exterior.faces()))
        plan.exits.push_back(exitBehind(*opening, plan.cells));
    LIMEN_ASSERT(countExits(plan.cells) == plan.exits.size(),
                 "a cell's opening leads to no other cell and not outside");
    return plan;
}

BuildingPlan withClosedSeams(BuildingPlan plan) {
    closeSeams(plan.exterior.faces(), finestGrid(plan.exterior.faces()));
    for (CellPlan& cell : plan.cells)
        closeSeams(cell.faces, finestGrid(cell.faces));
    return plan;
}

BuildingPlan withRoundedCorners(BuildingPlan plan, double grid) {
    plan = withClosedSeams(std::move(plan));
    joinAtPortals(plan); // both polygons of a pair get the same corners
    roundCorners(plan.exterior.faces(), grid);
    for (CellPlan& cell : plan.cells)
        roundCorners(cell.faces, grid);
    return plan;
}

Neighbours neighboursOf(const std::vector<CellPlan>& cells) {
    Neighbours out;
    for (const CellPlan& cell : cells) {
        std::vector<std::uint32_t> next;
        for (const CellLink& link : cell.links)
            if (link.cell != CellLink::kOutside)
                next.push_back(link.cell);
        out.push_back(std::move(next));
    }
    return out;
}

std::vector<std::uint32_t> cellsWithin(const Neighbours& neighbours, std::uint32_t cell, std::size_t steps) {
    LIMEN_ASSERT(cell < neighbours.size(), "a cell of the plan");
    std::vector<std::uint32_t> found{cell};
    std::size_t begin = 0;
    for (std::size_t step = 0; step < steps && begin < found.size(); ++step) {
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

} // namespace limen::worlds
