#pragma once

#include "geometry/Vec.h"

#include <span>
#include <vector>

// What an opening really ends at. The walls around it may have vertices on its edges, moved by rounding or by welding up to
// a fraction of a millimetre off them, and its corners lie as far off its plane; seen from a centimetre away that is a pixel
// and more. Regions that left out what bulges, or had dents, would lack pixels that the opening owns.
namespace limen::visibility {

/// The convex hull of a nearly flat, nearly convex polygon as seen from the eye, eye-relative: its vertices but for those
/// that lie, on the screen, within the others. The polygon is counter-clockwise from the eye. Of one
/// that is bent around the eye what no ray through its plane meets is cut off instead. `out` is overwritten; `swap` is scratch.
void hullSeenFrom(const Vec3& eye, std::span<const Vec3> polygon, const Vec3& normal, std::vector<Vec3>& out,
                  std::vector<Vec3>& swap);

} // namespace limen::visibility
