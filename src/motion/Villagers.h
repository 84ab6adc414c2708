#pragma once

#include "motion/PartPoses.h"
#include "world/World.h"

namespace limen::motion {

/// Where a villager is on its route.
struct VillagerPlace {
    Vec3 feet{0.0};   ///< global
    double yaw = 0.0; ///< compass direction that the villager faces, degrees
    world::SpaceIndex space =
        world::kOutside; ///< that the feet are in, found by a sweep from the last route point
};
[[nodiscard]] VillagerPlace placeOf(const world::World& world, const world::Villager& villager,
                                    double seconds);

/// The point of its cycle that a villager is at.
[[nodiscard]] CyclePoint cyclePointOf(const world::World& world, const world::Villager& villager,
                                      double seconds);

} // namespace limen::motion
