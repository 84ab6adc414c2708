#pragma once

#include "worlds/records/FaceMesh.h"

namespace limen::worlds {

/// A rectangle in the two coordinates of a wall (or floor).
struct Rect {
    double u0 = 0.0, v0 = 0.0, u1 = 0.0, v1 = 0.0;
};

/// `whole` without the holes, in upright strips. Holes may extend over the border; they must not overlap.
[[nodiscard]] std::vector<Rect> withoutHoles(const Rect& whole, const std::vector<Rect>& holes);

/// The six sides of an upright box, seen from inside.
enum class Side { West, East, South, North, Floor, Ceiling };
/// The coordinate of a side's plane: x, y or z.
[[nodiscard]] double planeOfSide(const Vec3& min, const Vec3& max, Side side);
/// The rectangle as four points in the side's plane (at x, y or z = `at`), counter-clockwise seen from inside
/// the box. u,v are (y,z) on West and East, (x,z) on South and North, (x,y) on Floor and Ceiling.
[[nodiscard]] std::vector<Vec3> rectOnSide(Side side, double at, const Rect& rect);

} // namespace limen::worlds
