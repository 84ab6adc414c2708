#pragma once

#include "motion/PartPoses.h"
#include "world/Particles.h"
#include "world/World.h"

#include <optional>

// The carriers of particle sources: a villager, an idle object, a part of either, or a fixed frame.
namespace limen::motion {

/// A carrier's frame; global.
struct CarrierFrame {
    Vec3 origin{0.0};
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    world::SpaceIndex space = world::kOutside; ///< that the origin is in
};
[[nodiscard]] CarrierFrame carrierOf(const world::World& world, const world::ParticleSource& source,
                                     double seconds, BetweenFrames between);

[[nodiscard]] inline bool isCarried(const world::ParticleSource& source) {
    return source.villager != world::kNone || source.idle != world::kNone;
}

/// The source with `start` and `period` converted from its cycle's seconds to the world's. None if the
/// carrier does not play that cycle, or never reaches that frame.
[[nodiscard]] std::optional<world::ParticleSource> inWorldTime(const world::World& world,
                                                               const world::ParticleSource& source);

} // namespace limen::motion
