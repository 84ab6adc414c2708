#pragma once

#include "worlds/records/CellPlan.h"
#include "worlds/shapes/Panel.h"

namespace limen::worlds {

/// The upper border of an upright hole, from left to right in wall coordinates. The hole extends down to the
/// wall's foot.
using HoleTop = std::vector<Vec2>;
[[nodiscard]] HoleTop rectangleTop(const Rect& rect);
/// A half circle on upright sides, with `segments` edges.
[[nodiscard]] HoleTop archTop(double middle, double radius, double springing, int segments);

/// A wall with a hole on the West or East side of a room, at x = `at`, from z = `foot` up to `outline` (left
/// to right, in y and z).
struct ArchWall {
    Side side = Side::West;
    double at = 0.0, foot = 0.0;
    std::vector<Vec2> outline;
    HoleTop hole;
    Material material = Material::InnerPlaster;
};
[[nodiscard]] std::vector<Face> wallFaces(const ArchWall& wall);
/// The hole as a portal with the orientation of the wall.
[[nodiscard]] Face holePortal(const ArchWall& wall);

/// The cell inside a wall, between x = `from` and `to`, with its two portals.
[[nodiscard]] CellPlan archedPassage(const char* name, double from, double to, double foot,
                                     const HoleTop& hole, Material walls, Material floor);

} // namespace limen::worlds
