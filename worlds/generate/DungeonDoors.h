#pragma once

#include "worlds/generate/DungeonLayout.h"

namespace limen::worlds {

/// Points (across, up) in metres, counter-clockwise. In a passage to the east, `across` is +y. Up is 0 at the
/// floor.
using FlatOutline = std::vector<Vec2>;

/// The openings of a door; openingsOf is their number.
[[nodiscard]] std::vector<FlatOutline> openingOutlines(Door door);
/// The cross-section of a passage with such doors: the opening itself, or wider.
[[nodiscard]] FlatOutline passageOutline(Door door);
/// The opening in a floor, around the origin, seen from above; Narrow is a square, all others an octagon.
[[nodiscard]] FlatOutline hatchOutline(Door door);

/// The number of openings of a door.
[[nodiscard]] std::uint16_t openingsOf(Door door);

/// The extents of an opening: across as in FlatOutline, and up.
struct DoorExtent {
    double from = 0.0, to = 0.0, height = 0.0;
    bool rectangular = true;
};
[[nodiscard]] DoorExtent extentOf(Door door, std::uint16_t opening);

} // namespace limen::worlds
