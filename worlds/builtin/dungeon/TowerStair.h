#pragma once

#include "worlds/builtin/dungeon/Tower.h"

namespace limen::worlds {

/// The eight-sided openings in floors: metres from the middle to the sides, and half the length of a side.
inline constexpr double kHatch = 1.75, kHatchHalf = 0.75;

/// One turn of the stair: stone steps around a newel, with an iron rail. Its origin is the middle of a room's
/// floor.
[[nodiscard]] dat::RecordId addWindingStair(ModelWriter& writer);
/// A railing round a hatch, open to the east at the end of the stair.
[[nodiscard]] dat::RecordId addHatchRailing(ModelWriter& writer);
/// The newel's end above the roof, which supports the last steps.
[[nodiscard]] dat::RecordId addNewelEnd(ModelWriter& writer);

} // namespace limen::worlds
