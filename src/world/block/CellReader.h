#pragma once

#include "world/block/BlockContent.h"
#include "world/mesh/BakedGeometry.h"

namespace limen::world {

/// A cell whose polygons are read, but not baked.
struct CellDraft {
    dat::EnvCell record;
    const dat::CellStruct* shape = nullptr; ///< owned by Records
    std::vector<std::uint32_t>
        polygons; ///< BakedGeometry handles of drawn polygons, drawn portal polygons included
    std::vector<std::uint32_t>
        portals; ///< BakedGeometry handles by portal of the record; kNone: no such polygon
};

/// The shape that a cell names, or null. Valid until `records` drops its environments.
[[nodiscard]] const dat::CellStruct* findShape(const dat::EnvCell& cell, Records& records);

/// The ids of a cell's surfaces, by slot.
[[nodiscard]] std::vector<dat::RecordId> surfaceIds(const dat::EnvCell& cell);

/// Reads the cell's shape and adds its polygons to `geometry`. No value, and a finding, if there is no usable
/// polygon.
[[nodiscard]] std::optional<CellDraft> draftCell(dat::EnvCell record, Records& records,
                                                 BakedGeometry& geometry, std::vector<Finding>& findings);

/// Appends the cell and its portals to `block`. The portals are not linked yet. Requires: `geometry` is
/// baked.
void finishCell(const CellDraft& draft, const BakedGeometry& geometry, Records& records, BlockContent& block);

} // namespace limen::world
