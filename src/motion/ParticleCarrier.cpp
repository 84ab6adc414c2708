#include "motion/ParticleCarrier.h"

#include "core/Assert.h"
#include "geometry/Compass.h"
#include "motion/BodyInstances.h"
#include "motion/Locate.h"
#include "motion/Villagers.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

using world::kNone;
using world::ParticleSource;
using world::World;

CyclePoint cyclePointOfCarrier(const World& world, const ParticleSource& source, double seconds) {
    if (source.villager != kNone)
        return cyclePointOf(world, world.villagers[source.villager], seconds);
    if (source.idle != kNone)
        return cyclePoint(world, world.idleObjects[source.idle].body, world::Gait::Stand, 0.0, seconds);
    return {source.cycle, seconds}; // a fixed source advances through the frames of its cycle all the same
}

/// The frame of a carried source's carrier without regard to parts, and the carrier's scale.
struct WholeCarrier {
    CarrierFrame frame;
    const world::MovingBody& body;
    double scale = 1.0;
};
WholeCarrier wholeCarrierOf(const World& world, const ParticleSource& source, double seconds) {
    if (source.villager != kNone) {
        const world::Villager& villager = world.villagers[source.villager];
        const VillagerPlace place = placeOf(world, villager, seconds);
        return {{place.feet, glm::quat_cast(turnedTo(place.yaw)), place.space}, villager.body, 1.0};
    }
    const world::IdleObject& idle = world.idleObjects[source.idle];
    return {{idle.origin, orientationOf(idle, seconds), idle.space}, idle.body, idle.scale};
}

} // namespace

CarrierFrame carrierOf(const World& world, const ParticleSource& source, double seconds,
                       BetweenFrames between) {
    LIMEN_ASSERT(source.villager == kNone || source.villager < world.villagers.size(),
                 "a source is carried by a villager of the world");
    LIMEN_ASSERT(source.idle == kNone || source.idle < world.idleObjects.size(),
                 "a source is carried by an idle object of the world");
    if (!isCarried(source))
        return {source.at.origin, source.at.orientation, source.space};
    const WholeCarrier carrier = wholeCarrierOf(world, source, seconds);
    const CarrierFrame& whole = carrier.frame;
    if (source.part == kNone)
        return whole;
    const PartPoses poses(world, carrier.body, cyclePointOfCarrier(world, source, seconds), between);
    const world::PartFrame part = poses.frameOf(source.part).value_or(source.at);
    const Vec3 origin = whole.origin + whole.orientation * part.origin * carrier.scale;
    return {origin, whole.orientation * part.orientation, sweep(world, whole.space, whole.origin, origin)};
}

std::optional<ParticleSource> inWorldTime(const World& world, const ParticleSource& source) {
    ParticleSource timed = source;
    if (source.cycle != kNone) {
        // A carrier advances through its cycle at a constant rate.
        const CyclePoint begin = cyclePointOfCarrier(world, source, 0.0);
        const CyclePoint second = cyclePointOfCarrier(world, source, 1.0);
        const double rate = second.seconds - begin.seconds;
        if (begin.cycle != source.cycle || !(rate > 0.0))
            return std::nullopt;
        timed.start = (source.start - begin.seconds) / rate;
        timed.period = source.period / rate;
        timed.jitter = source.jitter / rate;
        if (!std::isfinite(timed.start) || !std::isfinite(timed.period))
            return std::nullopt; // the carrier never reaches that frame
    }
    return timed;
}

} // namespace limen::motion
