#pragma once

#include "dat/Ids.h"
#include "worlds/records/FaceMesh.h"

#include <string>

namespace limen::worlds {

/// One placed model, in the coordinates of the plan (or landblock) that lists it.
struct Furnishing {
    dat::RecordId model = 0;
    Placement at;
};

/// The target of a planned cell's portal: a cell of the same plan and the index of the portal there that
/// leads back, or the outside.
struct CellLink {
    static constexpr std::uint32_t kOutside = 0xFFFFFFFFu;
    std::uint32_t cell = kOutside;
    std::uint16_t portal = dat::kNoPortal;
    bool exact = true;          ///< both cells have the same polygon
    bool insidePositive = true; ///< winding of the stored polygon, and the flag that goes with it
};

/// A cell in the coordinates of its plan: a closed shell whose faces look inwards. Its portals are its portal
/// faces, in order.
struct CellPlan {
    std::string name;
    std::vector<Face> faces;
    std::vector<Furnishing> statics;
    std::vector<CellLink> links; ///< one for each portal face; linkedByPoints fills them
    Vec3 eye{0.0}; ///< a point inside, for place names and for trees of cells that are not convex
};

/// A building, or a dungeon if nothing leads outside.
struct BuildingPlan {
    std::string name;
    FaceMesh exterior; ///< its portal faces, which look outwards, are `exits`; empty for a dungeon
    std::vector<CellPlan> cells;
    struct Exit {
        std::uint32_t cell = 0;
        std::uint16_t portal = 0;
    };
    std::vector<Exit> exits; ///< linkedByPoints fills them
};

/// Links portal faces that have the same points: of two cells, or of one cell and the exterior. Exterior and
/// cells get the same vertices along the openings they share. Requires: the meshes' own seams are closed on
/// kBuiltGrid; every portal face has exactly one partner.
[[nodiscard]] BuildingPlan linkedByPoints(BuildingPlan plan);

/// Closes the seams of each mesh on the finest grid that its floats hold. For plans that are linked by index.
[[nodiscard]] BuildingPlan withClosedSeams(BuildingPlan plan);
/// The same, and then rounds all corners to multiples of `grid` metres (roundCorners).
[[nodiscard]] BuildingPlan withRoundedCorners(BuildingPlan plan, double grid);

/// For each cell, the cells that its portals lead to.
using Neighbours = std::vector<std::vector<std::uint32_t>>;
[[nodiscard]] Neighbours neighboursOf(const std::vector<CellPlan>& cells);

/// The cells within `steps` openings of `cell`, itself included, ascending. For lists of visible cells.
inline constexpr std::size_t kAnyStep = static_cast<std::size_t>(-1);
[[nodiscard]] std::vector<std::uint32_t> cellsWithin(const Neighbours& neighbours, std::uint32_t cell,
                                                     std::size_t steps);

} // namespace limen::worlds
