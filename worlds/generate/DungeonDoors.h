#pragma once

#include "worlds/generate/DungeonLayout.h"

namespace limen::worlds {

/// (across, up) in metres, as seen in a passage to the east, whose +y is `across`; counter-clockwise in that plane. Up
/// is 0 at the floor.
using FlatOutline = std::vector<Vec2>;

/// The openings of a door, as many as openingsOf says.
[[nodiscard]] std::vector<FlatOutline> openingOutlines(Door door);
/// The cross-section of a passage with such doors: the opening itself, or wider.
[[nodiscard]] FlatOutline passageOutline(Door door);
/// The opening in a floor, around the origin, seen from above; Narrow is a square, all others an octagon.
[[nodiscard]] FlatOutline hatchOutline(Door door);

/// How many openings a door is made of.
[[nodiscard]] std::uint16_t openingsOf(Door door);

/// The middle of an opening (x along the wall, seen as in a passage to the east; y up) and its extents, and whether it
/// is a rectangle.
struct DoorExtent {
    double from = 0.0, to = 0.0, height = 0.0;
    bool rectangular = true;
};
[[nodiscard]] DoorExtent extentOf(Door door, std::uint16_t opening);

} // namespace limen::worlds
