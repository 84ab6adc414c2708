// The tolerances that more than one part of the program must agree on, each with its unit, its space and its
// reason. Read by C++ (src/geometry/Tolerances.h) and by GLSL. A guard against rounding that only one file
// needs stays in that file. tests/architecture/TolerancesTest.cpp finds copies.
#ifdef __cplusplus
#define LIMEN_TOLERANCE inline constexpr double
namespace limen {
#else
#define LIMEN_TOLERANCE const float
#endif

// ---- The world: metres in world space -------------------------------------------------------------------------------

// A surface this near to a portal's plane is met from both sides, and a shut filling is met before everything else
// there. An eye this far past a portal's plane may still be said to be before it. The ownership stage clips openings
// with the same margin, so that rounding removes nothing from an opening that touches the plane. The point-in-cell test
// uses the same distance at the planes of a cell's BSP tree. Source: docs/ray-rule.md#tolerances;
// docs/formats/cells.md#point-in-cell.
LIMEN_TOLERANCE kInPlaneTolerance = 0.0002;

// An eye this near to the plane of a portal or a wall is in the plane; of a portal, plus the distance of its corners
// from the plane. Four corners of one polygon, in floats of a few metres, are this far off one plane. Source:
// docs/ray-rule.md#tolerances.
LIMEN_TOLERANCE kEyeInPlaneTolerance = 5.0e-7;

// Two vertices at most this far apart are one vertex, and a vertex this near to an edge is on the edge. The
// files store floats in local frames, so copies of one corner differ by hundredths of a millimetre. Real
// details are centimetres apart.
LIMEN_TOLERANCE kWeldTolerance = 0.0002;

// A ray or a movement that slips between two polygons by no more than this belongs to the nearer polygon. A
// narrower gap is a rounding of the data: the loader welds corners that are this near.
LIMEN_TOLERANCE kGapTolerance = kWeldTolerance;

// Two cells that overlap by no more than this count as disjoint and may share a zone. Within a zone depth
// alone decides, so a hidden cell may reach this far through the wall before it. The fragment shader moves it
// back behind the wall by no more than this distance (docs/ray-rule.md#spaces-portals-fillings). Cells that overlap more
// stay apart, which is slower and exact.
LIMEN_TOLERANCE kOverlapTolerance = 0.0001;

// Metres that kInPlaneTolerance grows, for a fragment, with each metre of distance from the eye: float positions and
// interpolation lose precision in proportion to the distance.
LIMEN_TOLERANCE kEntryPlaneToleranceSlope = 4.0e-7;

// ---- The view -------------------------------------------------------------------------------------------------------

// Metres of view depth: 19 nanometres. Nearer surfaces are not drawn and not met, and float positions are no more
// accurate than this; portals are met at any distance. 2 cm times a power of two: depths lose no precision. This is the
// default of every picture, drawn or traced. Source: docs/decisions/0163-a-near-plane-of-nanometres.md.
LIMEN_TOLERANCE kDefaultNearPlane = 0.02 / 1048576.0;

// Metres of view depth. A corner nearer than this, or behind the eye, has no place on the screen that floats hold to
// a part of a pixel. So nothing is decided by its place, and nearer ends of lines are cut.
LIMEN_TOLERANCE kNearestPlace = 0.02;

// Depths that differ by no more than this share are equal. It covers the float arithmetic of the depth
// buffer.
LIMEN_TOLERANCE kDepthShareTolerance = 1.0e-4;

// ---- The picture: pixels --------------------------------------------------------------------------------------------

// The distance on the screen between a fragment and the point of the true triangle that it stands for.
// Rasterisers snap corners to 1/256 of a pixel each way; twice that also covers corners far outside the
// picture, whose screen coordinates are rounded floats.
LIMEN_TOLERANCE kSnapTolerance = 1.0 / 128.0;

// ---- Surfaces: shares of full opacity -------------------------------------------------------------------------------

// A cut-out surface counts where the alpha of its texel is at least this: 200 of 255, and 100 of 255 if its picture
// has a palette. Half a step less, because drivers round differently. Source: docs/ray-rule.md#the-rule.
LIMEN_TOLERANCE kCutOutAlpha = 199.5 / 255.0;
LIMEN_TOLERANCE kCutOutAlphaIndexed = 99.5 / 255.0;

#ifdef __cplusplus
} // namespace limen
#endif
#undef LIMEN_TOLERANCE
