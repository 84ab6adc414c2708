#pragma once

#include "check/Comparison.h"

namespace limen::check {

/// The colour, R,G,B, of an id in a flat picture. Several ids may have one colour.
using IdColour = std::array<std::uint8_t, 3> (*)(std::uint32_t id);

/// Compares a multisampled picture, shaded flat by id, with pictures traced through each of its samples.
///
/// A pixel agrees if its colour is the mean of the colours of the ids that the rays through its samples meet.
/// It is a *sliver* if its colour is a mean of ids, each of which is met within 1e-4 of a pixel of its
/// sample: pictures are drawn with exact outlines, whose corners are rounded by less. Near the eye corners
/// are rounded by more, in pixels. There the search extends as far as floats may move the outlines of
/// polygons near the sample (Retracer::outlineRounding). It is *edge_on*, and so wrong, if its colour needs a
/// polygon that no such ray meets, but that passes within 1/128 of a pixel of a sample and is no farther
/// there than the surface that the sample's ray meets. Colours are compared up to the rounding of a mean, and
/// exactly where all rays meet the same id.
///
/// `traced`: by sample, in the order of drawn.samples, of the drawn size. Overwrites `result`.
void compareSampled(const DrawnImages& drawn, std::span<const reference::Picture> traced, IdColour colourOf,
                    Retracer& retracer, Comparison& result);

} // namespace limen::check
