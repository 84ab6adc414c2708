#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"

namespace limen::frame {

/// The picture as two sets of rectangles of FramePlan::rects, which do not overlap and cover it together.
struct SkyParts {
    RectRun open;   ///< touched by no opening of the root; no rectangle if there is no such part
    RectRun tested; ///< the rest
};

/// Splits the picture of an eye whose root is outside. In `open` every ray stays in the root, so a pixel without a surface
/// there shows the sky without the ownership test. The rectangles consist of cells of a grid of 16 by 16. Adds them to the plan.
[[nodiscard]] SkyParts splitSky(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);

} // namespace limen::frame
