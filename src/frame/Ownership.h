#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

namespace limen::frame {

/// Fills `plan.visits`, `plan.ownershipVertices` and `plan.clipSets`: for every visit but the root, in tree
/// order, the triangles that write its number into the ownership target.
///
/// A visit is drawn as its portal's polygon, with the same vertices as the walls around it. So every pixel is
/// either owned by the space behind the opening or covered by the wall beside it. The polygon is clipped by
/// the edges of its *parent's* region, moved outwards by 1/128 of a pixel (the parent's corners are snapped
/// when it is drawn), and by the parent's entry plane; never by edges of its own region. Exceptions:
/// - The visit through an inexact pair, and a part of a split opening, are clipped by their own region as
///   well. The hole around an inexact pair is drawn as if the pair were exact.
/// - An opening nearer to the eye than 5 cm is drawn as one triangle around the window, and its outline
///   decides.
/// - For an opening whose plane contains the eye, its region alone decides.
/// - A closed opening is drawn like any other: its rays meet the filling before any other surface in its
///   plane.
void planOwnership(const world::World& world, const world::DynamicState& dynamics, const FrameView& frame,
                   const visibility::VisibleSet& set, FramePlan& plan);

} // namespace limen::frame
