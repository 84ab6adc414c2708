#pragma once

#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

// Regions: convex cones of directions from the eye, as polygons of homogeneous (x, y, w) vertices,
// counter-clockwise on the screen. An edge a→b is the plane through the eye with normal a × b, positive
// inside: nothing is ever divided by w, so a region may touch the eye plane.
namespace limen::visibility {

/// A cone narrower than this (length of the sum of cross products of unit vertices, twice its solid angle)
/// holds no pixel centre of any real picture: a pixel of a 16k-wide 60 degree view covers 4·10⁻⁹. It is what
/// rounding leaves where two openings share an edge.
inline constexpr double kEmptyCone = 1e-14;

/// Part of a polygon of eye-relative screen-space points (or of a region) on the positive side of the plane
/// through the eye with this normal.
void clipByEyePlane(std::span<const Vec3> polygon, const Vec3& normal, std::vector<Vec3>& out);

/// Part of `polygon` inside `region`; both in (x, y, w), `polygon` may be of points anywhere, also behind the
/// eye. The result has unit vertices and is empty if it is narrower than kEmptyCone. `swap` is scratch.
void clipByRegion(std::span<const Vec3> polygon, std::span<const Vec3> region, std::vector<Vec3>& out,
                  std::vector<Vec3>& swap);

/// Makes every vertex unit length, drops repeated ones, and empties what is narrower than kEmptyCone.
void tidyRegion(std::vector<Vec3>& region);

/// Twice the cone's solid angle for narrow cones; a measure of size that shrinks with the region.
[[nodiscard]] double coneSize(std::span<const Vec3> region);

/// The smallest rectangle of NDC that holds the region, within the screen.
[[nodiscard]] Rect boundsOf(std::span<const Vec3> region);

[[nodiscard]] Rect intersection(const Rect& a, const Rect& b);

} // namespace limen::visibility
