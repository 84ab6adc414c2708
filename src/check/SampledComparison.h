#pragma once

#include "check/Comparison.h"

namespace limen::check {

/// The colour, R,G,B, that stands for an id in a flat picture. Ids may share one.
using IdColour = std::array<std::uint8_t, 3> (*)(std::uint32_t id);

/// Holds a multisampled picture, shaded flat by id, against pictures traced through each of its samples.
///
/// A pixel agrees if its colour is the mean of the colours of what the rays through its samples meet. It is a *sliver* if its
/// colour is a mean of ids of which each is met within 1e-4 of a pixel of its sample: pictures are drawn with exact outlines,
/// whose corners are rounded by less. Near the eye they are rounded by more, in pixels: there rays as far from the sample are
/// asked as floats may move the outlines of the polygons that pass it (Retracer::outlineRounding). It is *edge_on*, and so
/// wrong, if it takes a polygon that is met nowhere there, but passes within 1/128 of a pixel of a sample and lies no farther
/// there than what the sample's ray meets. Colours are compared to within the rounding of a mean; where all rays meet the
/// same, exactly.
///
/// `traced`: by sample, in the order of drawn.samples, of the drawn size. `result` is overwritten.
void compareSampled(const DrawnImages& drawn, std::span<const reference::Picture> traced, IdColour colourOf,
                    Retracer& retracer, Comparison& result);

} // namespace limen::check
