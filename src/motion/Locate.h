#pragma once

#include "world/World.h"

namespace limen::motion {

/// The space of a position without history (docs/ray-rule.md): the building's cell whose volume contains it,
/// else the outside. Dungeon cells are never guessed. If several cells contain it, the one with the smallest
/// id is taken and `ambiguous` is set.
struct Located {
    world::SpaceIndex space = world::kOutside;
    bool ambiguous = false;
};
[[nodiscard]] Located locate(const world::World& world, const Vec3& position);

/// True if the position is inside the cell's BSP tree (docs/formats/cells.md#point-in-cell). False for the
/// outside and for cells without a tree.
[[nodiscard]] bool cellContains(const world::World& world, world::SpaceIndex space, const Vec3& position);

/// The space at the end of a straight movement from `from`, which is in `space`, to `to`. Each portal whose
/// opening the segment passes is followed, nearest first. A `space` that the world does not have is returned
/// as it is.
[[nodiscard]] world::SpaceIndex sweep(const world::World& world, world::SpaceIndex space, const Vec3& from,
                                      const Vec3& to);

} // namespace limen::motion
