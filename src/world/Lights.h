#pragma once

#include "world/Membership.h"

namespace limen::world {

/// A lamp as it stands in the world.
struct PlacedLamp {
    Light light;
    SpaceIndex placedIn = kOutside;
};

/// Makes every space's light set, and the lamps' runs. Cells that see outside get part of the sky's light and
/// a little of the sun's, for a sun without shadows would shine through walls; other cells a dim ambient. A
/// lamp lights the cells its range reaches through portals if its rays get there in a straight line, the eight
/// strongest a cell; the outside is lit by lamps that stand outside only.
void lightSpaces(const std::vector<PlacedLamp>& lamps, World& world);

} // namespace limen::world
