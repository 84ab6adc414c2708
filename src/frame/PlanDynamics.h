#pragma once

#include "frame/DynamicPieces.h"
#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "frame/Selection.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <span>

namespace limen::frame {

/// Appends the selected dynamic instances to the plan's, and makes `pieces` theirs. Before the plan has records
/// of its own.
void planDynamics(const world::World& world, const FrameView& frame, const world::DynamicState& dynamics,
                  std::span<const SelectedDynamic> selected, DynamicPieces& pieces, FramePlan& plan);

} // namespace limen::frame
