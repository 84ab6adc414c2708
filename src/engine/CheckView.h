#pragma once

#include "check/View.h"
#include "engine/FrameRequest.h"

#include <string>

namespace limen::engine {

/// Converts a view of a check into a frame of a loaded world. Doors, and a body in a cell, that are not
/// loaded are left out.
[[nodiscard]] FrameRequest requestOf(const check::View& view, const world::World& world,
                                     world::SpaceIndex root);

/// Converts a frame into the view of a check. The kind of the view is not set.
[[nodiscard]] check::View viewOf(const FrameRequest& request, const world::World& world);

/// "" or " --readings=NAME=VALUE,...", for command lines.
[[nodiscard]] std::string readingsOption(const world::Readings& readings);

/// The command line that draws this frame again. It names the root, because the eye's position alone can be
/// ambiguous. `datOption` is "" or " --dat DIR".
[[nodiscard]] std::string reproduction(const world::World& world, const FrameRequest& request,
                                       const std::string& datOption);

} // namespace limen::engine
