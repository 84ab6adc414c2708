#pragma once

#include "world/BakedGeometry.h"
#include "world/BlockContent.h"

namespace limen::world {

/// A cell between reading its polygons and baking them.
struct CellDraft {
    dat::EnvCell record;
    const dat::CellStruct* shape = nullptr; ///< owned by Records
    std::vector<std::uint32_t> polygons;    ///< BakedGeometry handles of what is drawn
    std::vector<std::uint32_t> portals;     ///< by portal of the record; kNone: no such polygon
};

/// The shape that a cell names. Null if it does not exist. Lives as long as `records`.
[[nodiscard]] const dat::CellStruct* findShape(const dat::EnvCell& cell, Records& records);

/// Reads the cell's shape and adds its polygons to `geometry`. No value, and a finding, if it has none.
[[nodiscard]] std::optional<CellDraft> draftCell(dat::EnvCell record, Records& records,
                                                 BakedGeometry& geometry, std::vector<Finding>& findings);

/// After baking: the cell's mesh, tree and shape; its portals are appended to `block`, not yet linked.
void finishCell(const CellDraft& draft, const BakedGeometry& geometry, Records& records, BlockContent& block);

} // namespace limen::world
