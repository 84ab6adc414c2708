#pragma once

#include "check/Run.h"
#include "output/Picture.h"

namespace limen::output {

/// What was said of each pixel of a picture: red: wrong id, magenta: void, orange: edge-on, blue: wrong depth, cyan: wrong layers;
/// slivers yellow, what is not judged grey, holes dark red, what is right nearly black.
[[nodiscard]] Picture pictureOfVerdicts(std::uint32_t width, std::uint32_t height,
                                        const check::Comparison& comparison);

/// A finding for people, in one picture: the drawn ids with the visits outlined, the traced ids, and the verdicts. Small
/// pictures are enlarged by a whole factor.
[[nodiscard]] Picture pictureOfFinding(const check::FindingPicture& finding);

} // namespace limen::output
