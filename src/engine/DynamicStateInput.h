#pragma once

#include "engine/FrameReport.h"
#include "motion/DynamicStateBuilder.h"

namespace limen::engine {

/// What the world is like in a frame: a moment's input, which looks into `eye`. Weather falls while the player is outside.
[[nodiscard]] motion::DynamicStateInput dynamicsInput(const world::World& world, const FrameEye& eye);

} // namespace limen::engine
