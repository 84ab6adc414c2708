#pragma once

#include "engine/places/Viewpoints.h"

namespace limen::engine {

/// Way points of a walk that begins at a place: outdoors from door to door of the block's buildings, through
/// the doors into their rooms and back; then through the rooms of a dungeon. Successive points are joined by
/// free lines, except jumps (world::isJump). In a world of land alone: a round on the ground. Empty without a
/// start.
[[nodiscard]] std::vector<world::Place> makeTour(Shapes& shapes, const std::optional<world::Place>& start,
                                                 const std::optional<world::Place>& dungeon);

} // namespace limen::engine
