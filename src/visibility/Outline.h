#pragma once

#include "geometry/Vec.h"

#include <span>
#include <vector>

// What an opening really ends at. The walls around it may have vertices on its edges, moved by rounding or by welding up to
// a fraction of a millimetre off them; seen from a centimetre away that is a pixel and more. Regions that left out what
// bulges would lack pixels that the opening's outline owns.
namespace limen::visibility {

struct OutlineVertex {
    Vec3 at{0.0};
    bool isCorner = false; ///< of the convex polygon; else one that lies on its edges, or nearly
};

/// Marks the polygon's corners in its outline, and lets it begin with the first of them. Both run the same way round.
/// Empty if some corner is not among the outline's vertices, bit by bit and in order, or if there are no others.
[[nodiscard]] std::vector<OutlineVertex> markCorners(std::span<const Vec3> corners,
                                                     std::span<const Vec3> outline);

/// The smallest convex polygon that holds all of the outline, as seen from an eye that the polygon faces: the corners, and
/// of the vertices between them those that bulge. Eye-relative. `out` is overwritten.
void hullSeenFrom(const Vec3& eye, std::span<const OutlineVertex> outline, std::vector<Vec3>& out);

} // namespace limen::visibility
