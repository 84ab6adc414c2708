#pragma once

#include "check/Run.h"
#include "output/Picture.h"

namespace limen::output {

/// The verdict on each pixel as a colour. Red: wrong id; magenta: void; orange: edge-on; blue: wrong depth;
/// cyan: wrong layers; yellow: sliver; grey: unjudged; dark red: hole; dark green: by zone; nearly black:
/// agrees.
[[nodiscard]] Picture pictureOfVerdicts(std::uint32_t width, std::uint32_t height,
                                        const check::Comparison& comparison);

/// The panels of a finding: the drawn ids with the visits outlined, the traced ids, and the verdicts. Small
/// pictures are enlarged by an integer factor.
struct FindingPanels {
    Picture drawn, traced, verdicts;
};
[[nodiscard]] FindingPanels panelsOfFinding(const check::FindingPicture& finding);

/// One picture of a finding, with its three panels beside each other.
[[nodiscard]] Picture pictureOfFinding(const check::FindingPicture& finding);

} // namespace limen::output
