#pragma once

#include "app/Picture.h"
#include "check/Run.h"

namespace limen::app {

/// A finding for people, in one picture: the drawn ids with the visits outlined, the traced ids, and where they differ
/// (red: wrong id, magenta: void, orange: edge-on, blue: wrong depth, cyan: wrong layers; slivers yellow, what is not
/// judged grey, holes dark red). Small pictures are enlarged by a whole factor.
[[nodiscard]] Picture pictureOfFinding(const check::FindingPicture& finding);

} // namespace limen::app
