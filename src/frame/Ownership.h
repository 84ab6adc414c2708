#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

namespace limen::frame {

/// Fills `plan.visits`, `plan.ownershipVertices` and `plan.clipSets`: for every visit but the root, in tree
/// order, the triangles that write its number into the ownership target.
///
/// A visit is drawn as its portal's own polygon, from the very vertices that the walls around it use, so that
/// every pixel is either owned by what lies behind the opening or covered by the wall beside it. It is cut by
/// the edges of its *parent's* region, grown by 1/128 of a pixel (the parent's
/// own corners are snapped when it is drawn), and by the parent's entry plane; never by edges of
/// its own. What is behind an inexact pair, and one part of a split opening, are cut by the region that the flood found as
/// well; the hole around an inexact pair is drawn as if the pair were exact. An opening nearer to the eye than 5 cm is looked
/// for in the whole window; one in whose plane the eye lies is its region alone.
/// A shut opening is drawn like any other: of what lies in its plane its rays meet the filling first.
void planOwnership(const world::World& world, const world::DynamicState& dynamics, const FrameView& frame,
                   const visibility::VisibleSet& set, FramePlan& plan);

} // namespace limen::frame
