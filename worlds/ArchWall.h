#pragma once

#include "worlds/Building.h"

namespace limen::worlds {

/// The upper border of an upright hole, from its left to its right side in wall coordinates; the hole reaches
/// down to the wall's foot.
using HoleTop = std::vector<Vec2>;
[[nodiscard]] HoleTop rectangleTop(const Rect& rect);
/// Half a circle over jambs, with `segments` edges.
[[nodiscard]] HoleTop archTop(double middle, double radius, double springing, int segments);

/// A wall on the West or East side of a room, at x = `at`, from its foot at z = `foot` up to `outline` (left to
/// right, in y and z), less the hole; then the hole as a portal.
struct ArchWall {
    Side side = Side::West;
    double at = 0.0, foot = 0.0;
    std::vector<Vec2> outline;
    HoleTop hole;
    Material material = Material::InnerPlaster;
};
[[nodiscard]] std::vector<Face> wallFaces(const ArchWall& wall);
/// The hole of the wall as a portal that looks the same way as the wall.
[[nodiscard]] Face holePortal(const ArchWall& wall);

/// The cell inside a wall from x = `from` to `to` that a hole goes through, with its two portals.
[[nodiscard]] CellPlan archedPassage(const char* name, double from, double to, double foot,
                                     const HoleTop& hole, Material walls, Material floor);

} // namespace limen::worlds
