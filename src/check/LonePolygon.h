#pragma once

#include "check/PolygonTable.h"
#include "reference/Picture.h"

#include <span>

// The freedom of a rasteriser with one polygon at one pixel, without regard to the rest of the world.
namespace limen::check {

/// True if a ray within kSnapTolerance of a place of the picture meets the polygon, from either side, and the
/// plane of one of its triangles is nearer than view depth `shown` on such a ray. `shown`: metres; infinity
/// and NaN: every depth is nearer. The rasteriser snaps corners, so a polygon seen edge-on may cover a centre
/// that it does not contain; the depth that its plane has there may be far nearer than the polygon.
[[nodiscard]] bool coversEdgeOn(std::span<const Triangle> polygon, const reference::Camera& camera, double x,
                                double y, double shown);

/// Pixels by which floats may move the polygon's outline at a place of the picture, at most kSnapTolerance; 0
/// where no part of it is that near. Edges are computed from corners in pixels times depth, relative to the
/// eye. Transforming them to the window rounds each by up to 4e-7 of the farthest one's distance. That is
/// about 1e-5 of a pixel where the polygon is as far as its corners, and more where it is nearer: a
/// thousandth at a hand's breadth from an edge of 2 m.
[[nodiscard]] double outlineRounding(std::span<const Triangle> polygon, const reference::Camera& camera,
                                     double x, double y);

/// True if a rasteriser may give the polygon view depth `drawn` (metres) at the pixel's centre.
///
/// Why there is a range. Inverse depth is affine over the screen. Where the snapped triangle contains the
/// centre p, p = sum l_i v'_i with l_i >= 0. So the depth drawn there is that of the true triangle's plane at
/// sum l_i v_i, which is no farther from p than the corners were moved: 1/512 pixel by rounding, and more for
/// corners far outside the picture, whose coordinates are themselves floats. kSnapTolerance, 1/128 pixel,
/// covers both. So the inverse depth must be one that the plane has within 1/128 pixel of p. Three errors are
/// added: kDepthShareTolerance of the depth; the float rounding of transformed corners (4e-7 of the farthest
/// corner's distance, and kBlockFloatTolerance); and the rounding of the depth itself, 2^-22 of the plane's
/// largest inverse depth in the picture, because the rasteriser evaluates it from one corner of the picture.
[[nodiscard]] bool mayHaveDepth(std::span<const Triangle> polygon, const reference::Camera& camera, int x,
                                int y, double drawn);

} // namespace limen::check
