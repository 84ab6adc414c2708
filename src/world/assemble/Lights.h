#pragma once

#include "world/assemble/Members.h"

namespace limen::world {

/// A lamp and the space it is in.
struct PlacedLamp {
    Light light;
    SpaceIndex placedIn = kOutside;
};

/// Adds the lamps in cells, and light sets for every space, for every cell's shell and for static objects in
/// cells (docs/formats/light.md#lamps). A lamp lights the cells that are connected with its own by portals
/// between cells, through walls. Requires members of the instances.
void lightWorld(std::span<const PlacedLamp> lamps, std::span<const ObjectGroup> objects, World& world);

} // namespace limen::world
