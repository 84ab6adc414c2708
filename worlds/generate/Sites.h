#pragma once

#include "worlds/generate/Props.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

// Buildings that intersect the ground, around the origin. z = 0 is just above the ground beside them.

/// An underground hall with a shaft up to a hut at each end.
[[nodiscard]] BuildingPlan planVault(const Props& props, Random& random);
/// A tunnel of 54 m along x with a room half way.
[[nodiscard]] BuildingPlan planTunnel(const Props& props, Random& random);
/// Five storeys, two of them below ground, joined by openings in their floors; some have an open top.
[[nodiscard]] BuildingPlan planTower(const Props& props, Random& random);
/// A U-shaped room with windows that face each other across its yard.
[[nodiscard]] BuildingPlan planCourt(const Props& props, Random& random);

} // namespace limen::worlds
