#include "world/assemble/ParticleAssembler.h"

#include "core/Assert.h"
#include "world/assemble/BodyAssembler.h"
#include "world/records/ParticleStyles.h"
#include "world/records/Pose.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Seconds. A source with a longer interval counts as one without births.
constexpr double kLongestInterval = 1e9;
/// Hooks of one object beyond this number are ignored: data with more is damaged.
constexpr std::size_t kMostHooks = 1024;

/// The seed of the particles of an object's `number`-th source, which identifies the source, too.
std::uint64_t seedOf(std::uint64_t object, std::size_t number) {
    return (object ^ number * 0x9E3779B97F4A7C15u) * 0xBF58476D1CE4E5B9u + number;
}

/// How far births are from the emitter along each axis: across the direction of `offset`, or in a sphere if
/// it has none. Metres.
Vec3 spreadOf(const VectorRange& offset) {
    const double most = std::max(std::abs(offset.least), std::abs(offset.most));
    const double length = glm::length(offset.vector);
    const Vec3 along = length > 0.0 ? offset.vector / length : Vec3(0.0);
    return most * glm::sqrt(glm::max(Vec3(1.0) - along * along, Vec3(0.0)));
}

/// particleReach of the horizontal motion alone.
double horizontalReach(ParticleStyle style, const Vec3& offset) {
    for (VectorRange* range : {&style.a, &style.b, &style.c})
        range->vector.z = 0.0;
    return particleReach(style, {offset.x, offset.y, 0.0});
}

Pose restOfPart(const EmitterStart& start, const dat::Setup& setup) {
    return start.part < setup.parts.size() ? restOf(setup, start.part) : Pose();
}

} // namespace

std::vector<EmitterStart> ParticleAssembler::startsOf(const dat::Setup& setup,
                                                      std::span<const std::uint32_t> cycles,
                                                      std::uint64_t seed) {
    std::vector<EmitterStart> starts = starts_.ofDefaultScript(setup, seed);
    std::size_t hooks = 0;
    for (const std::uint32_t cycle : cycles) {
        if (cycle == kNone)
            continue;
        for (const Cycles::Hook& hook : cycles_.hooksOf(cycle)) {
            if (++hooks > kMostHooks || starts.size() > kMostHooks)
                return starts;
            for (EmitterStart start : starts_.ofHook(*hook.hook, setup, seed + hooks)) {
                start.cycle = cycle;
                start.at += hook.seconds;
                if (start.period == 0.0)
                    start.period = hook.period;
                starts.push_back(start);
            }
        }
    }
    return starts;
}

void ParticleAssembler::addPlayed(const PlayEntry& play, dat::RecordId tableId, const dat::Setup& setup,
                                  std::uint64_t seed, std::vector<EmitterStart>& starts) {
    const dat::PhysicsScriptTable* table =
        play.kind != 0 && tableId != 0 ? records_.physicsScriptTable(tableId) : nullptr;
    const dat::RecordId script =
        table != nullptr ? chooseScript(*table, play.kind, static_cast<float>(play.intensity)) : 0;
    if (script == 0)
        return;
    const std::vector<EmitterStart> played = starts_.ofScript(script, setup, seed);
    starts.insert(starts.end(), played.begin(), played.end());
}

void ParticleAssembler::addToObject(const PlacedModel& object, std::uint32_t idle, const ObjectSite& site) {
    const dat::Setup* setup = isSetup(object.model) ? records_.setup(object.model) : nullptr;
    if (setup == nullptr)
        return;
    LIMEN_ASSERT(idle == kNone || idle < world_.idleObjects.size(), "the object is in the world");
    const std::uint32_t standing[] = {
        cycles_.of(object.model, object.motionTable)[static_cast<std::size_t>(Gait::Stand)]};
    std::vector<EmitterStart> starts = startsOf(*setup, standing, object.object);
    addPlayed(object.play, object.scriptTable != 0 ? object.scriptTable : setup->scriptTable, *setup,
              object.object, starts);
    std::size_t number = 0;
    for (const EmitterStart& start : starts) {
        ParticleSource source;
        source.idle = idle;
        source.seed = seedOf(object.object, number++);
        source.space = site.space;
        const Pose rest = restOfPart(start, *setup);
        source.at = {rest.orientation, rest.origin};
        if (idle == kNone) {
            const Vec3 origin = site.blockOrigin + object.origin;
            source.at = {object.orientation * rest.orientation,
                         origin + object.orientation * rest.origin * object.scale};
        }
        if (const auto made = sourceOf(start, *setup, source))
            world_.particleSources.push_back(*made);
    }
}

void ParticleAssembler::addToVillager(std::uint32_t villager, dat::RecordId model, const PlayEntry& play) {
    const dat::Setup* setup = isSetup(model) ? records_.setup(model) : nullptr;
    if (setup == nullptr)
        return;
    LIMEN_ASSERT(villager < world_.villagers.size(), "the villager is in the world");
    const std::uint64_t seed = dynamicObject(DynamicObject::Villager, villager);
    std::vector<EmitterStart> starts = startsOf(*setup, world_.villagers[villager].body.cycles, seed);
    addPlayed(play, setup->scriptTable, *setup, seed, starts);
    std::size_t number = 0;
    for (const EmitterStart& start : starts) {
        ParticleSource source;
        source.villager = villager;
        source.seed = seedOf(seed, number++);
        const Pose rest = restOfPart(start, *setup);
        source.at = {rest.orientation, rest.origin};
        if (const auto made = sourceOf(start, *setup, source))
            world_.particleSources.push_back(*made);
    }
}

std::optional<ParticleSource> ParticleAssembler::sourceOf(const EmitterStart& start, const dat::Setup& setup,
                                                          ParticleSource source) {
    LIMEN_ASSERT(source.villager == kNone || source.idle == kNone, "a source has one carrier at most");
    source.style = styles_.styleOf(start.emitter);
    if (source.style == kNone)
        return std::nullopt;
    const ParticleStyle& style = world_.particleStyles[source.style];
    const bool isCarried = source.villager != kNone || source.idle != kNone;
    source.part = isCarried && start.part < setup.parts.size() ? start.part : kNone;
    source.offset = start.offset;
    source.cycle = start.cycle;
    source.start = start.at;
    source.period = start.period;
    source.jitter = start.jitter;
    source.stop = start.stop;
    source.gone = start.gone;
    source.interval = style.interval;
    if (style.isPerMetre) {
        const double speed =
            source.villager != kNone ? std::abs(world_.villagers[source.villager].speed) : 0.0;
        source.interval = speed > 0.0 ? style.interval / speed : kNeverEnds;
    }
    source.replacesItself = start.name != 0 && start.period > 0.0;
    if (source.interval > kLongestInterval)
        source.interval = kNeverEnds;
    source.isEverBurning = style.isEndless() && source.stop == kNeverEnds && source.gone == kNeverEnds &&
                           !source.replacesItself && source.interval < kNeverEnds;
    source.reach = particleReach(style, start.offset);
    return source;
}

void ParticleAssembler::addWeather(const dat::SkyDesc& sky) {
    if (world_.readings.skyParticles == SkyParticles::None)
        return;
    for (std::uint32_t group = 0; group < sky.dayGroups.size(); ++group) {
        const std::vector<dat::SkyObject>& objects = sky.dayGroups[group].objects;
        for (std::uint32_t i = 0; i < objects.size(); ++i)
            addWeather(group, i, objects[i]);
    }
}

void ParticleAssembler::addWeather(std::uint32_t dayGroup, std::uint32_t number,
                                   const dat::SkyObject& object) {
    const dat::Setup bare;
    const dat::Setup* model = isSetup(object.object) ? records_.setup(object.object) : nullptr;
    const dat::Setup& setup = model != nullptr ? *model : bare;
    const std::uint64_t seed = std::uint64_t{dayGroup} << 32 | number;
    const std::vector<EmitterStart> starts = object.script != 0 ? starts_.ofScript(object.script, setup, seed)
                                                                : starts_.ofDefaultScript(setup, seed);
    std::size_t count = 0;
    for (const EmitterStart& start : starts) {
        ParticleSource source;
        source.seed = seedOf(seed, count++);
        source.isAlone = true;
        std::optional<ParticleSource> made = sourceOf(start, setup, source);
        if (!made)
            continue;
        ParticleStyle style = world_.particleStyles[made->style];
        Vec3 spread(0.0);
        if (world_.readings.skyParticles == SkyParticles::Around) {
            spread = spreadOf(style.offset);
            style.offset = {};
        }
        made->style = static_cast<std::uint32_t>(world_.particleStyles.size());
        world_.particleStyles.push_back(style);
        world_.sky.weather.push_back({dayGroup, object, *made, spread, horizontalReach(style, made->offset)});
    }
}

} // namespace limen::world
