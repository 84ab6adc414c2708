#pragma once

#include "geometry/Vec.h"

#include <span>
#include <vector>

// The exact boundary of an opening. The walls around it may have vertices on its edges, which rounding or
// welding moves by up to a fraction of a millimetre, and its corners are as far off its plane. From an eye a
// centimetre away that is more than a pixel. A region that excluded a bulge, or had a dent, would lack pixels
// that the opening owns.
namespace limen::visibility {

/// The convex hull of a nearly flat, nearly convex polygon as seen from the eye, eye-relative: the polygon
/// without the vertices that are, on the screen, inside the others. The polygon is counter-clockwise from the
/// eye. If it is bent around the eye, the part that no ray through its plane meets is clipped off instead.
/// `out` is overwritten; `swap` is scratch.
void hullSeenFrom(const Vec3& eye, std::span<const Vec3> polygon, const Vec3& normal, std::vector<Vec3>& out,
                  std::vector<Vec3>& swap);

} // namespace limen::visibility
