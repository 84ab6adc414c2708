#pragma once

#include "worlds/BuiltIn.h"

namespace limen::worlds::test {

/// How often a closed, inward-looking shell winds around a point: 1 inside, 0 outside, by the solid angles of its
/// triangles (A. van Oosterom, J. Strackee, The Solid Angle of a Plane Triangle, 1983). Block coordinates.
[[nodiscard]] double windingAround(const dat::EnvCell& cell, const Vec3& point);

/// Distance (metres) to the nearest plane of a polygon of the shell.
[[nodiscard]] double distanceToPlanes(const dat::EnvCell& cell, const Vec3& point);

/// A cell's landblock.
[[nodiscard]] inline dat::BlockCoord blockOf(std::uint32_t id) {
    return {static_cast<int>(id >> 24), static_cast<int>(id >> 16 & 0xFF)};
}
/// Metres of the map to metres of a landblock.
[[nodiscard]] inline Vec3 inBlock(dat::BlockCoord block, const Vec3& global) {
    return global - Vec3(block.x * 192.0, block.y * 192.0, 0.0);
}
/// The cell that an opening leads to, or null: outside.
[[nodiscard]] inline const dat::EnvCell* behind(const dat::EnvCell& cell, const dat::CellPortal& portal) {
    return portal.otherCellId == dat::kOutdoors ? nullptr
                                                : findCell((cell.id & 0xFFFF0000u) | portal.otherCellId);
}

/// Cells that are not convex; their trees hold more than they do.
[[nodiscard]] bool isConvex(const dat::EnvCell& cell);

} // namespace limen::worlds::test
