#pragma once

#include "check/PolygonTable.h"
#include "reference/Picture.h"

#include <span>

// What a rasteriser may make of one polygon at one pixel, the rest of the world aside.
namespace limen::check {

/// True if a ray within 1/128 of a pixel of a place of the picture meets the polygon, from either side, while the plane of one of
/// its triangles lies before view depth `shown` (metres; infinite and NaN: anything is before it) on such a ray. The
/// rasteriser snaps corners to 1/256 of a pixel, so a polygon seen edge-on may cover a centre that it does not contain;
/// the depth it takes there from its plane may lie far before the polygon.
[[nodiscard]] bool coversEdgeOn(std::span<const Triangle> polygon, const reference::Camera& camera, double x,
                                double y, double shown);

/// Pixels by which floats may move the polygon's outline at a place of the picture, 1/128 at most; 0 where no part of it is
/// as near as that. Edges are told from corners in pixels times depth, relative to the eye; turning them to the window rounds each
/// by up to 4e-7 of the farthest one's distance. That is some 1e-5 of a pixel where the polygon is as far as its corners, and
/// the more the nearer it comes at this place: a thousandth at a hand's breadth from an edge of 2 m.
[[nodiscard]] double outlineRounding(std::span<const Triangle> polygon, const reference::Camera& camera,
                                     double x, double y);

/// True if a rasteriser may give the polygon view depth `drawn` (metres) at the pixel's centre.
///
/// Why there is a range at all. Inverse depth is affine over the screen. Where the snapped triangle contains the centre
/// p, p = sum l_i v'_i with l_i >= 0, so the depth drawn there is that of the true triangle's plane at sum l_i v_i,
/// which is no farther from p than the corners were moved: 1/512 pixel by rounding, more for corners far outside the
/// picture, whose coordinates are themselves floats; 1/128 pixel covers both. So the inverse depth must be one that the
/// plane takes within 1/128 pixel of p. On top come: 1e-4 of the depth; the floats that corners are transformed in
/// (4e-7 of the farthest corner's distance, and 0.02 mm, the spacing of floats in a landblock); and the rounding of the
/// depth itself, 2^-22 of the largest inverse depth that the plane takes in the picture, because the rasteriser
/// evaluates it from one corner of it.
[[nodiscard]] bool mayHaveDepth(std::span<const Triangle> polygon, const reference::Camera& camera, int x,
                                int y, double drawn);

} // namespace limen::check
