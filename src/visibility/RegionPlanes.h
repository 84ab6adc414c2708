#pragma once

#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

// Regions for a rasteriser: clip planes, and triangles for the stencil buffer.
namespace limen::visibility {

/// At most `most` planes that bound the region: positive inside, through the eye, in the frame of `view.eye`. They are
/// the region's edges. If it has more, edges are left out one by one, each time the one that adds least of the screen,
/// so the planes never cut the region; without any (`most` 0) they bound nothing. Edges along the border of the
/// screen are left out first, as the screen cuts there anyway. The visit's entry plane is not among them. `out` is
/// overwritten. Cost: the cube of the corners.
LIMEN_API void clipPlanesOf(std::span<const Vec3> region, const View& view, std::size_t most,
                            std::vector<Plane>& out);

/// The region as a list of triangles, counter-clockwise: three positions (x, y, 0, w) in clip space for each. They
/// need no matrix. w may be 0, where a region reaches the plane of the eye; the hardware clips that. `out` is
/// overwritten. Cost: corners.
LIMEN_API void trianglesOf(std::span<const Vec3> region, std::vector<Vec4f>& out);

} // namespace limen::visibility
