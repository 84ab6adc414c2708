#pragma once

#include "motion/DynamicInstances.h"
#include "motion/DynamicStateInput.h"

// Doors of a dynamic state: the portals that they shut, their leaves, and the fillings of shut openings.
namespace limen::motion {

/// Overwrites `out.closed`, and clears `out.fillings` to kNone. An opaque door shuts its portal and the
/// reciprocal while its openness is 0. Both arrays stay empty in a world without doors.
void shutPortals(const world::World& world, const DynamicStateInput& input, world::DynamicState& out);

/// Appends the leaves of all doors and the fillings of shut portals, and sets `fillings`. Requires
/// shutPortals().
void addDoors(const DynamicStateInput& input, DynamicInstances& instances);

} // namespace limen::motion
