#pragma once

#include "dat/records/Primitives.h"

#include <array>

// EnvCell, LandBlock, LandBlockInfo: docs/formats/cells.md, docs/formats/landscape.md.
LIMEN_API_BEGIN
namespace limen::dat {

struct CellPortal {
    static constexpr std::uint16_t kExactMatch = 1, kPortalSide = 2;
    std::uint16_t flags = 0;
    std::uint16_t polygonId = 0;
    std::uint16_t otherCellId = 0;   ///< low word; 0xFFFF = outdoors
    std::uint16_t otherPortalId = 0; ///< index into the neighbour's portals; 0xFFFF = none
};

struct EnvCell {
    static constexpr std::uint32_t kSeenOutside = 1, kHasStatics = 2, kHasWeenies = 4, kHasRestriction = 8;
    std::uint32_t id = 0;
    std::uint32_t flags = 0;
    std::vector<std::uint16_t> surfaces; ///< low words of Surface ids
    std::uint16_t environment = 0;       ///< low word of an Environment id
    std::uint16_t cellStructure = 0;     ///< key in that Environment
    Frame position;                      ///< landblock-relative
    std::vector<CellPortal> portals;
    std::vector<std::uint16_t> visibleCells; ///< low words, same block; a hint
    std::vector<Stab> statics;               ///< flags & kHasStatics; landblock-relative frames
    std::uint32_t restriction = 0;           ///< flags & kHasRestriction
};

struct LandBlock {
    std::uint32_t id = 0;
    std::uint32_t hasObjects = 0;
    std::array<std::uint16_t, 81> terrain{}; ///< index x*9 + y; bits 0-1 road, 2-6 type, 11-15 scenery
    std::array<std::uint8_t, 81> heights{};  ///< index into the Region's height table
    std::uint8_t padding = 0;
};

struct BuildingPortal {
    std::uint16_t flags = 0; ///< CellPortal flags
    std::uint16_t otherCellId = 0;
    std::uint16_t otherPortalId = 0;
    std::vector<std::uint16_t> stabs;
    std::array<std::uint8_t, 2> padding{}; ///< up to a multiple of four; the writer stores zeros
};

struct Building {
    std::uint32_t model = 0;
    Frame frame;
    std::uint32_t numLeaves = 0;
    std::vector<BuildingPortal> portals;
};

struct LandBlockInfo {
    std::uint32_t id = 0;
    std::uint32_t numCells = 0;
    std::vector<Stab> objects;
    std::vector<Building> buildings;
    std::uint16_t hasRestrictions = 0;
    std::uint16_t restrictionBuckets = 8;
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        restrictions; ///< (cell, object); stored iff hasRestrictions
};

} // namespace limen::dat
LIMEN_API_END
