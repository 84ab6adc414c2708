#include "world/block/PortalLinks.h"

#include "geometry/ConvexPolygon.h"
#include "world/PolygonDistance.h"
#include "world/records/Records.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Cells by low word.
class CellLookup {
public:
    explicit CellLookup(const BlockContent& block) {
        for (std::uint32_t i = 0; i < block.cells.size(); ++i)
            byWord_.emplace(static_cast<std::uint16_t>(block.cells[i].id & 0xFFFF), i);
    }
    [[nodiscard]] std::uint32_t find(std::uint16_t word) const {
        const auto found = byWord_.find(word);
        return found == byWord_.end() ? kNone : found->second;
    }

private:
    std::unordered_map<std::uint16_t, std::uint32_t> byWord_;
};

std::string nameOf(const PortalContent& portal) {
    return "portal " + std::to_string(portal.recordIndex);
}

bool sameOpening(const PortalContent& a, const PortalContent& b, double tolerance) {
    return !a.points.empty() && !b.points.empty() && samePolygon(a.corners, b.corners, tolerance);
}

/// The portal of `cell` by its index in the record's list, or kNone.
std::uint32_t portalOf(const BlockContent& block, std::uint32_t cell, std::uint16_t index) {
    const CellContent& content = block.cells[cell];
    return index < content.portalCount ? content.firstPortal + index : kNone;
}

void resolveDestinations(BlockContent& block) {
    const CellLookup lookup(block);
    for (PortalContent& portal : block.portals) {
        if (portal.otherCell == dat::kOutdoors)
            portal.destination = kOutdoorSpace;
        else
            portal.destination = lookup.find(portal.otherCell);
        if (portal.destination == kNone)
            note(block.findings, block.cells[portal.space].id,
                 nameOf(portal) + " leads to a cell that does not exist");
        if (portal.points.empty())
            portal.destination = kNone;
    }
}

/// True if each names the other.
bool isMutual(const BlockContent& block, std::uint32_t p, std::uint32_t q) {
    const PortalContent& a = block.portals[p];
    const PortalContent& b = block.portals[q];
    return p != q && b.destination == a.space && b.otherPortal == a.recordIndex;
}

void pair(BlockContent& block, std::uint32_t p, std::uint32_t q) {
    LIMEN_ASSERT(p != q && block.portals[p].reciprocal == kNone && block.portals[q].reciprocal == kNone,
                 "a portal has one way back");
    block.portals[p].reciprocal = q;
    block.portals[q].reciprocal = p;
}

void pairNamed(BlockContent& block) {
    for (std::uint32_t p = 0; p < block.portals.size(); ++p) {
        const PortalContent& portal = block.portals[p];
        if (portal.destination >= kOutdoorSpace || portal.reciprocal != kNone)
            continue;
        const std::uint32_t q = portalOf(block, portal.destination, portal.otherPortal);
        if (q != kNone && block.portals[q].reciprocal == kNone && isMutual(block, p, q))
            pair(block, p, q);
    }
}

/// The unpaired portal of the destination that leads back through the same opening, or kNone.
std::uint32_t findByGeometry(const BlockContent& block, std::uint32_t p) {
    const PortalContent& portal = block.portals[p];
    const CellContent& cell = block.cells[portal.destination];
    for (std::uint32_t q = cell.firstPortal; q < cell.firstPortal + cell.portalCount; ++q) {
        const PortalContent& other = block.portals[q];
        if (q != p && other.reciprocal == kNone && other.destination == portal.space &&
            sameOpening(portal, other, kOpeningTolerance))
            return q;
    }
    return kNone;
}

void pairByGeometry(BlockContent& block) {
    for (std::uint32_t p = 0; p < block.portals.size(); ++p) {
        const PortalContent& portal = block.portals[p];
        if (portal.destination >= kOutdoorSpace || portal.reciprocal != kNone ||
            portal.otherPortal == dat::kNoPortal)
            continue;
        const std::uint32_t q = findByGeometry(block, p);
        note(block.findings, block.cells[portal.space].id,
             nameOf(portal) + " names a way back that does not lead back" +
                 (q == kNone ? "; it is one-way" : "; another with the same opening is taken"));
        if (q != kNone)
            pair(block, p, q);
    }
}

/// True if each one's corners are among the vertices of the other. Of one bent polygon the hulls from both sides can have
/// different corners.
bool haveTheSameCorners(const PortalContent& a, const PortalContent& b) {
    const auto areAmong = [](const std::vector<Vec3>& corners, const std::vector<Vec3>& points) {
        return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
            return std::any_of(points.begin(), points.end(), [&](const Vec3& point) {
                return glm::length(point - corner) <= kExactTolerance;
            });
        });
    };
    return !a.points.empty() && !b.points.empty() && areAmong(a.corners, b.points) &&
           areAmong(b.corners, a.points);
}

void judgeExactness(BlockContent& block) {
    for (std::uint32_t p = 0; p < block.portals.size(); ++p) {
        const std::uint32_t q = block.portals[p].reciprocal;
        if (q == kNone || q < p)
            continue;
        PortalContent& a = block.portals[p];
        PortalContent& b = block.portals[q];
        LIMEN_ASSERT(b.reciprocal == p, "the way back of a way back is the portal itself");
        const bool flagged = (a.flags & b.flags & dat::CellPortal::kExactMatch) != 0;
        const bool same = (sameOpening(a, b, kExactTolerance) || haveTheSameCorners(a, b)) &&
                          glm::dot(a.plane.n, b.plane.n) < 0.0;
        if (flagged && !same)
            note(block.findings, block.cells[a.space].id,
                 nameOf(a) + " is flagged an exact match, but its way back has another polygon");
        a.exact = b.exact = flagged && same;
    }
}

/// The exit portal of a cell that a building portal belongs to: the named one, else the only exit without a
/// building, else kNone.
std::uint32_t exitFor(const BlockContent& block, std::uint32_t cell, std::uint16_t named, bool& asNamed) {
    const auto isFreeExit = [&](std::uint32_t p) {
        return block.portals[p].otherCell == dat::kOutdoors && block.portals[p].reciprocal == kNone;
    };
    const std::uint32_t exit = portalOf(block, cell, named);
    asNamed = exit != kNone && isFreeExit(exit);
    if (asNamed)
        return exit;
    std::uint32_t only = kNone;
    const CellContent& content = block.cells[cell];
    for (std::uint32_t p = content.firstPortal; p < content.firstPortal + content.portalCount; ++p) {
        if (!isFreeExit(p))
            continue;
        if (only != kNone)
            return kNone;
        only = p;
    }
    return only;
}

/// The portal of the outside through a cell's exit.
PortalContent outdoorPortal(const PortalContent& exit, std::uint32_t exitIndex, std::uint16_t recordIndex) {
    PortalContent portal = exit;
    portal.space = kOutdoorSpace;
    portal.destination = exit.points.empty() ? kNone : exit.space;
    portal.reciprocal = exitIndex;
    std::reverse(portal.points.begin(), portal.points.end());
    std::reverse(portal.corners.begin(), portal.corners.end());
    portal.plane = exit.plane.flipped();
    portal.recordIndex = recordIndex;
    portal.exact = true;
    portal.walled = false;
    return portal;
}

/// Whether the building's own polygon is an opaque surface in the opening, seen from outside.
bool isWalled(const PortalContent& portal, const BuildingDraft::PortalPolygon& own) {
    if (portal.points.empty() || !samePolygon(own.corners, portal.corners, kOpeningTolerance))
        return false;
    return glm::dot(planeOf(own.corners).n, portal.plane.n) > 0.0 ? own.opaqueFront : own.opaqueBack;
}

void separateWalled(BlockContent& block) {
    for (PortalContent& portal : block.portals) {
        if (!portal.walled || portal.reciprocal == kNone)
            continue;
        PortalContent& back = block.portals[portal.reciprocal];
        portal.reciprocal = back.reciprocal = kNone;
        portal.exact = back.exact = true;
    }
}

} // namespace

void linkCellPortals(BlockContent& block) {
    resolveDestinations(block);
    pairNamed(block);
    pairByGeometry(block);
    judgeExactness(block);
    block.firstOutdoorPortal = static_cast<std::uint32_t>(block.portals.size());
}

void linkBuilding(BlockContent& block, const dat::Building& building,
                  std::span<const BuildingDraft::PortalPolygon> ownPolygons, dat::RecordId record) {
    const CellLookup lookup(block);
    for (std::size_t i = 0; i < building.portals.size() && i < 0xFFFF; ++i) {
        const dat::BuildingPortal& named = building.portals[i];
        const std::string name =
            "building portal " + std::to_string(i) + " of model " + std::to_string(building.model & 0xFFFF);
        const std::uint32_t cell = lookup.find(named.otherCellId);
        if (cell == kNone) {
            note(block.findings, record, name + " leads to a cell that does not exist");
            continue;
        }
        bool asNamed = false;
        const std::uint32_t exit = exitFor(block, cell, named.otherPortalId, asNamed);
        if (!asNamed)
            note(block.findings, record,
                 name + " names no exit of its cell" +
                     (exit == kNone ? "; it is left out" : "; its only other one is taken"));
        if (exit == kNone)
            continue;
        const bool hasOwn = i < ownPolygons.size() && !ownPolygons[i].corners.empty();
        if (!hasOwn)
            note(block.findings, record, name + " has no polygon in the building's model");
        else if (!block.portals[exit].points.empty() &&
                 !samePolygon(ownPolygons[i].corners, block.portals[exit].corners, kOpeningTolerance))
            note(block.findings, record,
                 name + " has another polygon in the building's model than in the cell");
        LIMEN_ASSERT(block.portals[exit].reciprocal == kNone, "an exit leads through one building portal");
        block.portals[exit].reciprocal = static_cast<std::uint32_t>(block.portals.size());
        block.portals.push_back(outdoorPortal(block.portals[exit], exit, static_cast<std::uint16_t>(i)));
        block.portals.back().walled = hasOwn && isWalled(block.portals.back(), ownPolygons[i]);
    }
}

void finishBuildings(BlockContent& block) {
    std::vector<std::uint32_t> reached;
    const auto reach = [&](std::uint32_t cell) {
        if (cell < kOutdoorSpace && !block.cells[cell].ofBuilding) {
            block.cells[cell].ofBuilding = true;
            reached.push_back(cell);
        }
    };
    for (std::size_t p = block.firstOutdoorPortal; p < block.portals.size(); ++p)
        reach(block.portals[p].destination);
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const CellContent& cell = block.cells[reached[i]];
        for (std::uint32_t p = cell.firstPortal; p < cell.firstPortal + cell.portalCount; ++p)
            reach(block.portals[p].destination);
    }
    for (std::size_t p = 0; p < block.firstOutdoorPortal; ++p) {
        const PortalContent& portal = block.portals[p];
        if (portal.otherCell == dat::kOutdoors && portal.reciprocal == kNone)
            note(block.findings, block.cells[portal.space].id,
                 nameOf(portal) + " leads outside, but no building leads back");
    }
    separateWalled(block);
}

} // namespace limen::world
