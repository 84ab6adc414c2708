#pragma once

#include "world/World.h"

namespace limen::motion {

/// The space of a position without history (docs/ray-rule.md): the cell of a building whose volume contains it,
/// else outside. Dungeon cells are never guessed. If several cells claim it, the one with the smallest id is
/// taken and `ambiguous` is set.
struct Located {
    world::SpaceIndex space = world::kOutside;
    bool ambiguous = false;
};
[[nodiscard]] Located locate(const world::World& world, const Vec3& position);

/// True if the cell's BSP holds the position (docs/formats/cells.md#point-in-cell). False for outside and for cells without a
/// tree.
[[nodiscard]] bool cellContains(const world::World& world, world::SpaceIndex space, const Vec3& position);

/// The space reached by moving in a straight line from `from`, which lies in `space`, to `to`: each portal
/// whose opening the segment passes is followed, nearest first.
[[nodiscard]] world::SpaceIndex sweep(const world::World& world, world::SpaceIndex space, const Vec3& from,
                                      const Vec3& to);

} // namespace limen::motion
