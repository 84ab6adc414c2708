#pragma once

#include "engine/FrameReport.h"
#include "check/View.h"

namespace limen::engine {

/// A view in the terms of `limen shot` as the eye of a frame of a loaded world. Doors and cells that are not loaded are left out.
[[nodiscard]] FrameEye eyeOf(const check::View& view, const world::World& world, world::SpaceIndex root);

/// An eye in the terms of `limen shot`, about what it sees. Its kind is not set.
[[nodiscard]] check::View viewOf(const FrameEye& eye, const world::World& world);

} // namespace limen::engine
