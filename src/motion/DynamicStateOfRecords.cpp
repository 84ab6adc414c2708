#include "motion/DynamicStateBuilder.h"

#include "geometry/Compass.h"
#include "motion/Locate.h"
#include "motion/Particles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// The part of Moments that the records tell of: objects that move where they stand, and particles.
namespace limen::motion {
namespace {

using world::kNone;

/// Particles that are farther from where they were born are nowhere, metres.
constexpr double kFarthest = 1e5;

/// How an idle object is turned.
Quat orientationOf(const world::IdleObject& idle, double seconds) {
    const double rate = glm::length(idle.spin);
    if (!(rate > 0.0))
        return idle.orientation;
    return idle.orientation *
           glm::angleAxis(std::remainder(rate * seconds, 2.0 * std::numbers::pi), idle.spin / rate);
}

} // namespace

void DynamicStateBuilder::addIdle(double seconds, world::DynamicState& out) {
    for (const world::IdleObject& idle : world_.idleObjects) {
        const Pose pose{glm::mat3_cast(orientationOf(idle, seconds)) * idle.scale, idle.origin};
        const std::size_t first = out.instances.size();
        addBody(idle.body, pose, cyclePoint(world_, idle.body, world::Gait::Stand, 0.0, seconds), idle.space,
                out);
        const Sphere& sphere = idle.body.bounds;
        if (idle.isAlone)
            reached_.assign(1, idle.space);
        else
            membership_.reach(idle.space,
                              {pose.origin + pose.linear * sphere.centre, sphere.radius * idle.scale},
                              out.closed, reached_);
        giveMembers(first, out);
    }
}

CyclePoint DynamicStateBuilder::cyclePointOf(const world::ParticleSource& source, double seconds) const {
    if (source.villager == kNone) {
        if (source.idle == kNone)
            return {source.cycle, seconds}; // what does not move goes through its frames all the same
        return cyclePoint(world_, world_.idleObjects[source.idle].body, world::Gait::Stand, 0.0, seconds);
    }
    const world::Villager& villager = world_.villagers[source.villager];
    return cyclePoint(world_, villager.body, gaitAt(world_, villager.body, villager.speed),
                      villager.start + villager.speed * seconds, seconds);
}

DynamicStateBuilder::Carrier DynamicStateBuilder::carrierOf(const world::ParticleSource& source,
                                                            double seconds) const {
    const bool walks = source.villager != kNone;
    if (!walks && source.idle == kNone)
        return {source.at.origin, source.at.orientation, source.space};
    Carrier carrier;
    double scale = 1.0;
    if (walks) {
        const Standing standing = this->standing(world_.villagers[source.villager], seconds);
        carrier = {standing.position, glm::quat_cast(turnedTo(standing.yaw)), standing.space};
    } else {
        const world::IdleObject& idle = world_.idleObjects[source.idle];
        carrier = {idle.origin, orientationOf(idle, seconds), idle.space};
        scale = idle.scale;
    }
    if (source.part == kNone)
        return carrier;
    const world::MovingBody& body =
        walks ? world_.villagers[source.villager].body : world_.idleObjects[source.idle].body;
    const PartPoses poses(world_, body, cyclePointOf(source, seconds));
    const world::PartFrame part = poses.frameOf(source.part).value_or(source.at);
    const Vec3 origin = carrier.origin + carrier.orientation * part.origin * scale;
    return {origin, carrier.orientation * part.orientation,
            sweep(world_, carrier.space, carrier.origin, origin)};
}

std::optional<world::ParticleSource> DynamicStateBuilder::timed(const world::ParticleSource& source) const {
    world::ParticleSource timed = source;
    if (source.cycle != kNone) {
        // A carrier comes through its cycle evenly.
        const CyclePoint begin = cyclePointOf(source, 0.0), second = cyclePointOf(source, 1.0);
        const double rate = second.seconds - begin.seconds;
        if (begin.cycle != source.cycle || !(rate > 0.0))
            return std::nullopt;
        timed.start = (source.start - begin.seconds) / rate;
        timed.period = source.period / rate;
        if (!std::isfinite(timed.start) || !std::isfinite(timed.period))
            return std::nullopt; // it never comes that far
    }
    if (timed.replacesItself)
        timed.gone = std::min(timed.gone, timed.period);
    return timed;
}

void DynamicStateBuilder::addParticles(const DynamicStateInput& input, const world::ParticleSource& asRead,
                                       world::DynamicState& out) {
    const std::optional<world::ParticleSource> source = timed(asRead);
    if (!source)
        return;
    const world::ParticleStyle& style = world_.particleStyles[source->style];
    const Carrier now = carrierOf(*source, input.seconds);
    const SourceStarts starts = startsAt(style, *source, input.seconds);
    for (std::int64_t start = starts.first; start <= starts.last; ++start)
        addStarted(input, *source, start, now, out);
}

void DynamicStateBuilder::addStarted(const DynamicStateInput& input, const world::ParticleSource& source,
                                     std::int64_t start, const Carrier& now, world::DynamicState& out) {
    const world::ParticleStyle& style = world_.particleStyles[source.style];
    const bool isCarried = source.villager != kNone || source.idle != kNone;
    const std::uint32_t block = blockFor(now.origin);
    eachLiving(style, source, start, input.seconds,
               [&](const ParticleKey& key, double born, double age, double life) {
                   const Carrier then = isCarried ? carrierOf(source, born) : now;
                   const ParticleState state =
                       particleAt(style, key, age, life, then.orientation, source.offset);
                   addParticle(input, source, style.isParentLocal ? now : then, state, block, out);
               });
}

void DynamicStateBuilder::addParticle(const DynamicStateInput& input, const world::ParticleSource& source,
                                      const Carrier& from, const ParticleState& state, std::uint32_t block,
                                      world::DynamicState& out) {
    const world::ParticleStyle& style = world_.particleStyles[source.style];
    const Vec3 at = from.origin + state.offset;
    world::Instance particle = world_.movingParts[style.part];
    const world::Mesh& mesh = world_.meshes[particle.mesh];
    const bool isAnywhere = state.opacity > 0.0 && glm::length(state.offset) < kFarthest;
    if (!isAnywhere || sprites_ + mesh.polygonCount > world::kMostSprites)
        return;
    const Mat3 linear =
        (style.facesEye ? Mat3(input.right, input.forward, input.up) : glm::mat3_cast(state.orientation)) *
        state.scale;
    particle.block = block;
    particle.linear = glm::mat3(linear);
    particle.origin = Vec3f(at - world_.blocks[block].origin());
    particle.bounds = {at + linear * mesh.bounds.centre, mesh.bounds.radius * state.scale};
    particle.opacity = static_cast<float>(state.opacity);
    particle.idBase = world_.spriteIds + sprites_;
    sprites_ += mesh.polygonCount;
    out.instances.push_back(particle);
    if (source.isAlone)
        reached_.assign(1, from.space);
    else
        membership_.reach(sweep(world_, from.space, from.origin, at), particle.bounds, out.closed, reached_);
    giveMembers(out.instances.size() - 1, out);
}

} // namespace limen::motion
