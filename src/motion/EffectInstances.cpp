#include "motion/EffectInstances.h"

#include "core/Assert.h"
#include "geometry/Compass.h"
#include "motion/Billboards.h"
#include "motion/Locate.h"
#include "motion/Sprites.h"
#include "motion/Villagers.h"

#include <algorithm>

namespace limen::motion {
namespace {

using world::kNone;

/// Metres from its place of birth beyond which a particle is not drawn: an extreme record could send it off
/// the map, where its float position means nothing.
constexpr double kFarthest = 1e5;

/// The frame of an emitter and the space of its origin.
struct EmitterFrame {
    BodyPose pose;
    world::SpaceIndex space = world::kOutside;
};
EmitterFrame frameOf(const world::World& world, const world::Emitter& emitter, double seconds) {
    if (emitter.villager == kNone)
        return {{Mat3(1.0), emitter.position}, emitter.space};
    LIMEN_ASSERT(emitter.villager < world.villagers.size(), "an emitter is on a villager of the world");
    const VillagerPlace carrier = placeOf(world, world.villagers[emitter.villager], seconds);
    const Mat3 turn = turnedTo(carrier.yaw);
    const Vec3 origin = carrier.feet + turn * emitter.position;
    return {{turn, origin}, sweep(world, carrier.space, carrier.feet, origin)};
}

void addSpritesOf(const world::Emitter& emitter, const DynamicStateInput& input,
                  DynamicInstances& instances) {
    const auto [pose, space] = frameOf(instances.world(), emitter, input.seconds);
    DynamicInstances::Spaces spaces = instances.reachedFrom(space, {pose.origin, emitter.reach});
    const bool isAlone = spaces.size() == 1; // then every sprite is in that space, too
    SpriteShape shape{emitter.sprite, {}, 1.0, input.right, input.up, input.forward};
    const SpriteRange living = livingAt(emitter, input.seconds);
    for (std::int64_t n = living.first; n <= living.last && instances.hasSpriteIds(1); ++n) {
        const SpriteState state = spriteAt(emitter, n, input.seconds);
        if (!(state.size > 0.0))
            continue;
        const Vec3 at = pose.origin + pose.linear * state.offset;
        shape.size = Vec2(state.size);
        shape.opacity = state.opacity;
        const std::size_t sprite = addSprite(shape, at, instances);
        if (!isAlone)
            spaces = instances.reachedFrom(sweep(instances.world(), space, pose.origin, at),
                                           instances.state().instances[sprite].bounds);
        instances.setSpaces(sprite, spaces);
    }
}

/// Whether the eye is near enough to an emitter for its particles to be drawn.
bool isInReach(const world::World& world, const world::ParticleSource& source, const Vec3& emitter,
               const Vec3& eye, const world::LevelShare& levels) {
    const std::uint32_t level = world.movingParts[world.particleStyles[source.style].part].level;
    return level == kNone || ObjectView(eye, emitter, false, levels).isIn(world.levels[level].range);
}

/// Appends the living particles of one start of a source. `now`: the carrier's frame at the input's time.
void addStarted(const DynamicStateInput& input, const world::ParticleSource& source, std::int64_t start,
                const CarrierFrame& now, DynamicInstances& instances) {
    const world::World& world = instances.world();
    const world::ParticleStyle& style = world.particleStyles[source.style];
    const std::uint32_t block = instances.blockFor(now.origin);
    eachLiving(style, source, start, input.seconds,
               [&](const ParticleKey& key, double born, double age, double life) {
                   const CarrierFrame then =
                       isCarried(source) ? carrierOf(world, source, born, input.between) : now;
                   const ParticleState state =
                       particleAt(style, key, age, life, then.orientation, source.offset);
                   addParticle(input, {source, style.isParentLocal ? now : then, block}, state, instances);
               });
}

} // namespace

std::size_t addSprite(const SpriteShape& shape, const Vec3& at, DynamicInstances& instances) {
    const world::World& world = instances.world();
    LIMEN_ASSERT(shape.part < world.movingParts.size(), "a sprite shows a moving part of the world");
    world::Instance sprite = world.movingParts[shape.part];
    sprite.block = instances.blockFor(at);
    sprite.linear =
        glm::mat3(Mat3(shape.right * shape.size.x, shape.forward * std::max(shape.size.x, shape.size.y),
                       shape.up * shape.size.y));
    sprite.origin = Vec3f(at - world.blocks[sprite.block].origin());
    sprite.bounds = {at, 0.5 * glm::length(shape.size)};
    sprite.opacity = static_cast<float>(shape.opacity);
    sprite.idBase = instances.takeSpriteIds(1);
    return instances.add(sprite);
}

void addParticle(const DynamicStateInput& input, const ParticleOrigin& from, const ParticleState& state,
                 DynamicInstances& instances) {
    const world::World& world = instances.world();
    LIMEN_ASSERT(from.source.style < world.particleStyles.size(), "a source has a style of the world");
    const world::ParticleStyle& style = world.particleStyles[from.source.style];
    LIMEN_ASSERT(style.part < world.movingParts.size(), "a particle shows a moving part of the world");
    const Vec3 at = from.frame.origin + state.offset;
    world::Instance particle = world.movingParts[style.part];
    const world::Mesh& mesh = world.meshes[particle.mesh];
    const bool isVisible = state.opacity > 0.0 && glm::length(state.offset) < kFarthest;
    if (!isVisible || !instances.hasSpriteIds(mesh.polygonCount))
        return;
    particle.level = kNone; // its emitter is within reach
    const ObjectView view(input.eye, at, false, input.levels);
    const Mat3 linear =
        turnedToEye(style.facing, glm::mat3_cast(state.orientation), view.headingTo(at)) * state.scale;
    particle.block = from.block;
    particle.linear = glm::mat3(linear);
    particle.origin = Vec3f(at - world.blocks[from.block].origin());
    particle.bounds = {at + linear * mesh.bounds.centre, mesh.bounds.radius * state.scale};
    particle.opacity = static_cast<float>(state.opacity);
    particle.idBase = instances.takeSpriteIds(mesh.polygonCount);
    const std::size_t first = instances.add(particle);
    if (from.source.isAlone) {
        instances.setSpaces(first, instances.only(from.frame.space));
        return;
    }
    const world::SpaceIndex space = sweep(world, from.frame.space, from.frame.origin, at);
    instances.setSpaces(first, instances.reachedFrom(space, particle.bounds));
}

void addSprites(const DynamicStateInput& input, DynamicInstances& instances) {
    for (const world::Emitter& emitter : instances.world().emitters)
        addSpritesOf(emitter, input, instances);
}

void addParticles(const DynamicStateInput& input, DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (const world::ParticleSource& asRead : world.particleSources) {
        const std::optional<world::ParticleSource> source = inWorldTime(world, asRead);
        if (!source)
            continue;
        const CarrierFrame now = carrierOf(world, *source, input.seconds, input.between);
        if (!isInReach(world, *source, now.origin, input.eye, input.levels))
            continue;
        const SourceStarts starts = startsAt(world.particleStyles[source->style], *source, input.seconds);
        for (std::int64_t start = starts.first; start <= starts.last; ++start)
            addStarted(input, *source, start, now, instances);
    }
}

} // namespace limen::motion
