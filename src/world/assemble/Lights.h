#pragma once

#include "world/World.h"

namespace limen::world {

/// A lamp and the space it is in.
struct PlacedLamp {
    Light light;
    SpaceIndex placedIn = kOutside;
};

/// Adds a light set for every space. Cells that see outside get part of the sky's light and little of the
/// sun's, because the sun casts no shadows and would shine through walls. Other cells get a dim ambient. A
/// lamp lights a cell if its range reaches it through portals and its rays arrive there in a straight line;
/// each cell takes its eight strongest lamps. Lamps in cells do not light the outside.
void lightSpaces(std::span<const PlacedLamp> lamps, World& world);

} // namespace limen::world
