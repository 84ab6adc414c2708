#pragma once

#include "picture/PictureWorld.h"

#include <string>

namespace limen::test {

/// A multisampled picture shaded flat by id, held against the ray rule.
///
/// A pixel is right if its colour is a mean of colours of ids, one for each sample, that rays near the sample meet: the
/// ray through the sample itself or one of those around it within the reach of the rasteriser's rounding (corners are
/// snapped to 1/256 of a pixel, so an edge may pass on the other side of a sample that it comes within 1/128 of a pixel
/// of). Where surfaces meet at an edge within that reach, the rasteriser's depths may order them either way: a polygon
/// counts as well that such a ray meets, alone in the world, no further than what the sample's ray met. Colours are
/// compared to within the rounding of a mean; where all those rays meet the same, exactly.
struct SampledComparison {
    std::size_t pixels = 0;
    std::size_t mixed = 0;   ///< the rays through its samples meet different ids
    std::size_t snapped = 0; ///< right only by a ray beside a sample
    std::size_t tied = 0;    ///< right only by a polygon that ends where another begins
    std::size_t wrong = 0;
    std::string first; ///< the first wrong one

    SampledComparison& operator+=(const SampledComparison& other);
};

/// `picture`: by PictureWorld::shootSampled, of the moment that is set.
[[nodiscard]] SampledComparison compareSampled(const PictureWorld& pictures, const Picture& picture);

} // namespace limen::test
