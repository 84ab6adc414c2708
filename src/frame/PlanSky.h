#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "world/World.h"

#include <span>
#include <vector>

namespace limen::frame {

/// Overwrites `placements` with the sky objects of a frame, but those that others cover. `space`: the space in which the eye's
/// rays begin, that of the first visit. An eye that has just passed an opening is not in the view's root.
void placeSky(const world::World& world, const FrameView& frame, world::SpaceIndex space,
              std::vector<world::SkyPlacement>& placements);

/// A rectangle of FramePlan::rects that contains all directions at or below an elevation with this sine; the whole window for 0
/// and more. Adds it to the plan, whose constants have the projection.
[[nodiscard]] RectRun plainSkyBelow(double sine, FramePlan& plan);

/// Some objects of the sky, and the clip set of their draws.
struct SkyShare {
    bool overLand = false; ///< those over everything outdoors, else those behind it
    std::uint32_t clipSet = 0;
};

/// Adds objects of the sky to the last batch, of Program::SkyObjects.
void addSkyObjects(const world::World& world, std::span<const world::SkyPlacement> placements,
                   const SkyShare& share, FramePlan& plan);

} // namespace limen::frame
