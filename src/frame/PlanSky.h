#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "world/World.h"

#include <span>
#include <vector>

namespace limen::frame {

/// Overwrites `placements` with the sky objects of a frame.
void placeSky(const world::World& world, const FrameView& frame,
              std::vector<world::SkyPlacement>& placements);

/// Some objects of the sky, and the clip set of their draws.
struct SkyShare {
    bool overLand = false; ///< those over everything outdoors, else those behind it
    std::uint32_t clipSet = 0;
};

/// Adds objects of the sky to the last batch, of Program::SkyObjects.
void addSkyObjects(const world::World& world, std::span<const world::SkyPlacement> placements,
                   const SkyShare& share, FramePlan& plan);

} // namespace limen::frame
