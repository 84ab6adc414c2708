#pragma once

#include "dat/Ids.h"
#include "worlds/Models.h"
#include "worlds/Panel.h"

#include <string>

namespace limen::worlds {

/// A model standing somewhere, in the coordinates of the building (or landblock) that lists it.
struct Furnishing {
    dat::RecordId model = 0;
    Placement at;
};

/// A cell in its building's coordinates: a closed shell, convex as a rule, that looks inwards. Its portals are its portal
/// faces, in order; each either matches, point for point, a portal face of another cell of the plan, or leads
/// outside.
struct CellPlan {
    std::string name;
    std::vector<Face> faces;
    std::vector<Furnishing> statics;
};

/// An opening in one side of a box-shaped room.
struct Opening {
    Side side = Side::South;
    Rect rect;
};

/// A box-shaped room and the pictures on its sides.
struct RoomSpec {
    std::string name{};
    Vec3 min{0.0}, max{0.0};
    Material floor = Material::Planks, walls = Material::InnerPlaster, ceiling = Material::Planks;
};
/// The closed shell of a room: its sides without the openings, and a portal face for each opening, in their
/// order.
[[nodiscard]] CellPlan roomWithOpenings(const RoomSpec& room, const std::vector<Opening>& openings);

/// A building: an exterior whose portal faces (outward) match portal faces of cells that no other cell
/// matches.
struct BuildingPlan {
    std::string name;
    MeshBuilder exterior;
    std::vector<CellPlan> cells;
};

/// Where a portal of a plan leads: a cell of the plan and the index of the portal there that leads back, or
/// dat::kOutdoors and dat::kNoPortal.
struct PortalLink {
    std::uint16_t cell = dat::kOutdoors;
    std::uint16_t portal = dat::kNoPortal;
};

/// One landblock being furnished.
class BlockBuilder {
public:
    BlockBuilder(ModelSink& sink, dat::BlockCoord coord);

    void addObject(const Furnishing& object);
    /// Adds exterior and cells. All of them share one frame, so that points that agree in the plan agree to
    /// the bit in the world. Returns the cells' ids in the plan's order. Requires: every portal face finds
    /// its partner.
    std::vector<dat::RecordId> addBuilding(BuildingPlan plan, const Placement& at);
    /// Adds cells that no building leads to. Returns their ids in the plan's order. Requires: every portal face finds
    /// its partner.
    std::vector<dat::RecordId> addDungeon(std::vector<CellPlan> cells, const Placement& at);
    /// True if the block needs no LandBlockInfo.
    [[nodiscard]] bool empty() const {
        return info_.objects.empty() && info_.buildings.empty() && info_.numCells == 0;
    }
    /// Adds the LandBlockInfo to the records.
    void finish();

private:
    dat::EnvCell cellRecord(const CellPlan& cell, const std::vector<PortalLink>& links,
                            std::uint16_t firstCell, const Placement& at) const;
    std::vector<dat::RecordId> addCells(const std::vector<CellPlan>& cells,
                                        const std::vector<std::vector<PortalLink>>& links,
                                        const Placement& at);

    ModelSink& sink_;
    dat::LandBlockInfo info_;
};

} // namespace limen::worlds
