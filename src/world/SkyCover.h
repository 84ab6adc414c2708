#pragma once

#include "world/World.h"

#include <span>

// Parts of the sky that hide others (docs/decisions/0213-sky-that-is-covered-is-left-out.md).
namespace limen::world {

/// Triangles around the origin, three corners each, counter-clockwise seen from it: the sine of the elevation above which
/// they have a point in every direction. SkyPart::kCoversNothing if they are not closed above the horizon.
[[nodiscard]] double coveredFrom(std::span<const Vec3f> corners);

/// Sets `isOpaque`, `coversFrom` and `shape` of all parts of the sky.
void findSkyCover(World& world);

/// Leaves out parts behind a later one that is opaque, of the same shape and in the same pose. Order is kept.
void leaveOutCovered(const Sky& sky, std::vector<SkyPlacement>& placements);

/// The sine of the elevation above which a part that is not over the land covers every direction, the least of all;
/// SkyPart::kCoversNothing if none does.
[[nodiscard]] double coveredFrom(const Sky& sky, std::span<const SkyPlacement> placements);

} // namespace limen::world
