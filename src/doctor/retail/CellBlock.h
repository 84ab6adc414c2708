#pragma once

#include "dat/Archive.h"

namespace limen::doctor {

/// Sums over the cells of one landblock.
struct CellBlock {
    double cells = 0, things = 0;
    double portalsOutdoors = 0;
    double untextured = 0; ///< polygons whose surface has no picture
    double untexturedThatAreNoPortals = 0;
};

/// Reads all cells of a landblock: those from 0x0100 on, as far as ids follow one another. Damaged cells are left out.
/// `block`: X << 8 | Y.
[[nodiscard]] CellBlock readCellBlock(const dat::Archive& archive, std::uint32_t block);

} // namespace limen::doctor
