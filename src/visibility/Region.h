#pragma once

#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

// Regions: convex cones of directions from the eye, as polygons of homogeneous (x, y, w) vertices,
// counter-clockwise on the screen. An edge a→b is the plane through the eye with normal a × b, positive
// inside. There is no division by w, so a region may touch the eye plane.
namespace limen::visibility {

/// A cone with a smaller coneSize (twice its solid angle) contains no pixel centre of any practical picture:
/// a pixel of a view 16k wide and 60 degrees covers 4·10⁻⁹. Such cones result from rounding where two
/// openings share an edge.
inline constexpr double kEmptyCone = 1e-14;

/// The part of a polygon of eye-relative screen-space points (or of a region) on the positive side of the
/// plane through the eye with this normal.
void clipByEyePlane(std::span<const Vec3> polygon, const Vec3& normal, std::vector<Vec3>& out);

/// The part of `polygon` inside `region`; both in (x, y, w). Points of `polygon` may be behind the eye. The
/// result has unit vertices and is empty if it is narrower than kEmptyCone. `swap` is scratch.
void clipByRegion(std::span<const Vec3> polygon, std::span<const Vec3> region, std::vector<Vec3>& out,
                  std::vector<Vec3>& swap);

/// Makes every vertex unit length, removes repeated ones, and empties a region narrower than kEmptyCone.
void tidyRegion(std::vector<Vec3>& region);

/// The length of the sum of cross products of the unit vertices: for narrow cones twice the solid angle.
/// Shrinks with the region.
[[nodiscard]] double coneSize(std::span<const Vec3> region);

/// The smallest rectangle, NDC, that contains the region, clamped to the screen.
[[nodiscard]] Rect boundsOf(std::span<const Vec3> region);

} // namespace limen::visibility
