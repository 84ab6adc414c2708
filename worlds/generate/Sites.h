#pragma once

#include "worlds/generate/Props.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// Buildings that the ground runs through, around the origin; z = 0 is just above the ground beside them.

/// Two huts over the ends of a hall below ground; shafts lead down.
[[nodiscard]] BuildingPlan planVault(const Props& props, Random& random);
/// A passage along x with a room half way, 54 m from mouth to mouth.
[[nodiscard]] BuildingPlan planTunnel(const Props& props, Random& random);
/// Five storeys, two of them below ground, joined by openings in their floors; some have an open top.
[[nodiscard]] BuildingPlan planTower(const Props& props, Random& random);
/// One room in the shape of a U, windows facing each other over its yard.
[[nodiscard]] BuildingPlan planCourt(const Props& props, Random& random);

} // namespace limen::worlds
