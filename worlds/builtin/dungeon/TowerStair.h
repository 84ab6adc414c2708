#pragma once

#include "worlds/builtin/dungeon/Tower.h"

namespace limen::worlds {

/// The eight-sided openings that the stair rises through: from the middle to the sides, and half a side.
inline constexpr double kHatch = 1.75, kHatchHalf = 0.75;

/// One turn of the stair: stone steps around a newel, with an iron rail; stands at the middle of a room's floor.
[[nodiscard]] dat::RecordId addWindingStair(ModelWriter& sink);
/// A railing round a hatch, open to the east, where one steps off.
[[nodiscard]] dat::RecordId addHatchRailing(ModelWriter& sink);
/// The newel's end above the roof, so that the last steps have something to hold.
[[nodiscard]] dat::RecordId addNewelEnd(ModelWriter& sink);

} // namespace limen::worlds
