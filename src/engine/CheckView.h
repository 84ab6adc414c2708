#pragma once

#include "check/View.h"
#include "engine/FrameRequest.h"

#include <string>

namespace limen::engine {

/// A view of a check as a frame of a loaded world. Doors and cells that are not loaded are left out.
[[nodiscard]] FrameRequest requestOf(const check::View& view, const world::World& world,
                                     world::SpaceIndex root);

/// A frame as the view of a check. Its kind is not set.
[[nodiscard]] check::View viewOf(const FrameRequest& request, const world::World& world);

/// The command that draws this frame again, with its root named. `datOption` is "" or " --dat DIR".
[[nodiscard]] std::string reproduction(const world::World& world, const FrameRequest& request,
                                       const std::string& datOption);

} // namespace limen::engine
