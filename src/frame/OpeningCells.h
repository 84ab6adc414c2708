#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"

namespace limen::frame {

/// Rectangles of FramePlan::rects that contain the openings of the root, two pixels around them included; none if none is in
/// the picture. Beside them every ray of an eye outside stays in the root, so there is no void. The rectangles consist of cells
/// of a grid of 16 by 16, and do not overlap. Adds them to the plan.
[[nodiscard]] RectRun rectsOfOpenings(const FrameView& frame, const visibility::VisibleSet& set,
                                      FramePlan& plan);

/// The share of the picture that rectangles of the plan have, 0..1, if they do not overlap.
[[nodiscard]] double shareOf(const RectRun& rects, const FramePlan& plan);

} // namespace limen::frame
