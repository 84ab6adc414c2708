#pragma once

#include "world/World.h"

namespace limen::world {

/// The space of a cell id, or kNone. Cost: a binary search.
[[nodiscard]] SpaceIndex findCell(const World& world, dat::RecordId cellId);

/// The resident block with these coordinates, or null. Cost: a binary search.
[[nodiscard]] const Block* findBlock(const World& world, dat::BlockCoord coord);

/// The block that contains a global position; coordinates are clamped to the map.
[[nodiscard]] dat::BlockCoord blockAt(const Vec3& position);

/// Horizontal distance of a global position from a block, metres; 0 inside it.
[[nodiscard]] double metresBeside(dat::BlockCoord block, const Vec3& position);

/// Height of the ground at a global position, metres; NaN where no terrain is resident.
[[nodiscard]] double terrainHeight(const World& world, double x, double y);

} // namespace limen::world
