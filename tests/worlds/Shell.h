#pragma once

#include "worlds/BuiltIn.h"

namespace limen::worlds::test {

/// The winding number of a closed, inward-looking shell around a point in block coordinates: 1 inside, 0
/// outside. Sums the solid angles of triangles. ref: A. van Oosterom, J. Strackee, The Solid Angle of a Plane
/// Triangle, 1983.
[[nodiscard]] double windingAround(const dat::EnvCell& cell, const Vec3& point);

/// The distance (metres) to the nearest plane of a polygon of the shell.
[[nodiscard]] double distanceToPlanes(const dat::EnvCell& cell, const Vec3& point);

[[nodiscard]] inline dat::BlockCoord blockOf(std::uint32_t id) {
    return {static_cast<int>(id >> 24), static_cast<int>(id >> 16 & 0xFF)};
}
/// Converts global metres to metres of a landblock.
[[nodiscard]] inline Vec3 inBlock(dat::BlockCoord block, const Vec3& global) {
    return global - Vec3(block.x * 192.0, block.y * 192.0, 0.0);
}
/// The cell behind a portal, or null for the outside.
[[nodiscard]] inline const dat::EnvCell* behind(const dat::EnvCell& cell, const dat::CellPortal& portal) {
    return portal.otherCellId == dat::kOutdoors ? nullptr
                                                : findCell((cell.id & 0xFFFF0000u) | portal.otherCellId);
}

/// False for a cell that is not convex; its tree contains more than the cell.
[[nodiscard]] bool isConvex(const dat::EnvCell& cell);

} // namespace limen::worlds::test
