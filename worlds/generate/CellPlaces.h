#pragma once

#include "worlds/generate/WorldNotes.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// The cells of a plan in the world, and the first part of their places' names.
struct PlacedCells {
    const char* name = "";
    dat::BlockCoord block;
    Placement at;
    dat::RecordId first = 0; ///< the others follow in the plan's order
};

/// Adds a place in each cell, NAME.INDEX, or in every n-th so that there are at most 96. It looks at the cell's first
/// opening, or east if it has none.
void notePlaces(const PlacedCells& placed, const std::vector<CellPlan>& cells, WorldNotes& notes);

} // namespace limen::worlds
