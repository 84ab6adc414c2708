#pragma once

#include "motion/DynamicInstances.h"
#include "motion/DynamicStateInput.h"

// Bodies of a dynamic state: villagers, the player, idle and loose objects.
namespace limen::motion {

void addVillagers(const DynamicStateInput& input, DynamicInstances& instances);

/// Appends the solid body, or the ghost if the player is partly transparent, or nothing if it is invisible.
void addPlayer(const DynamicStateInput& input, DynamicInstances& instances);

/// Appends the objects that are animated or turn in place.
void addIdleObjects(const DynamicStateInput& input, DynamicInstances& instances);

/// Appends the static objects whose membership depends on which doors are shut.
void addLooseObjects(DynamicInstances& instances);

/// The orientation of an idle object; its spin is periodic.
[[nodiscard]] Quat orientationOf(const world::IdleObject& idle, double seconds);

} // namespace limen::motion
