#include "world/Assembly.h"

#include "world/ParticleStyles.h"

#include <algorithm>
#include <utility>

// The part of Assembly that makes what moves of the records' own accord: objects that move where they stand, and the particle
// emitters that scripts and animations start.
namespace limen::world {
namespace {

/// Births that are farther apart, in seconds, never come.
constexpr double kLongestInterval = 1e9;
/// Hooks of one object that are followed: more is a mistake of the data.
constexpr std::size_t kMostHooks = 1024;

/// Identity of the `number`-th emitter of something, and the seed of its particles.
std::uint64_t seedOf(std::uint64_t object, std::size_t number) {
    return (object ^ number * 0x9E3779B97F4A7C15u) * 0xBF58476D1CE4E5B9u + number;
}

bool fades(const dat::Fade& translucency) {
    return translucency.start != 0.0f || translucency.end != 0.0f || translucency.random != 0.0f;
}

/// Farthest corner from the origin.
double sizeOf(const World& world, const Mesh& mesh) {
    double size = 0.0;
    for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v)
        size = std::max(size, glm::length(world.vertices[v].corner()));
    return size;
}

/// How far births lie aside along each axis: across the direction of `offset`, or in a ball if that has none.
Vec3 spreadOf(const VectorRange& offset) {
    const double most = std::max(std::abs(offset.least), std::abs(offset.most));
    const double length = glm::length(offset.vector);
    const Vec3 along = length > 0.0 ? offset.vector / length : Vec3(0.0);
    return most * glm::sqrt(glm::max(Vec3(1.0) - along * along, Vec3(0.0)));
}

/// particleReach on the level alone.
double levelRange(ParticleStyle style, const Vec3& offset) {
    for (VectorRange* range : {&style.a, &style.b, &style.c})
        range->vector.z = 0.0;
    return particleReach(style, {offset.x, offset.y, 0.0});
}

} // namespace

bool Assembly::addIdle(const PlacedModel& object) {
    const Vec3 spin = cycles_.spinOf(object.model);
    const std::uint32_t cycle = cycles_.of(object.model)[static_cast<std::size_t>(Gait::Stand)];
    if (cycle == kNone && spin == Vec3(0.0))
        return false;
    const std::size_t parts = world_.movingParts.size(), posed = world_.posedParts.size();
    IdleObject idle;
    idle.body = addBody(object.model, object.kind, object.object);
    const bool rests = cycle == kNone || isAtRest(world_, idle.body, cycle);
    if (idle.body.partCount == 0 || (rests && spin == Vec3(0.0))) {
        world_.movingParts.resize(parts);
        world_.posedParts.resize(posed);
        return false;
    }
    if (spin != Vec3(0.0))
        idle.body.bounds = {Vec3(0.0), glm::length(idle.body.bounds.centre) + idle.body.bounds.radius};
    idle.origin = world_.blocks[block_].origin() + object.origin;
    idle.orientation = object.orientation;
    idle.scale = object.scale;
    idle.spin = spin;
    idle.space = spaceOf(object.cell);
    world_.idleObjects.push_back(idle);
    return true;
}

/// What a Setup's own script starts, and the hooks of its cycles.
std::vector<EmitterStart> Assembly::startsOf(const dat::Setup& setup, std::span<const std::uint32_t> cycles) {
    std::vector<EmitterStart> starts = starts_.ofDefaultScript(setup);
    std::size_t hooks = 0;
    for (const std::uint32_t cycle : cycles) {
        if (cycle == kNone)
            continue;
        for (const Cycles::Hook& hook : cycles_.hooksOf(cycle)) {
            if (++hooks > kMostHooks || starts.size() > kMostHooks)
                return starts;
            for (EmitterStart start : starts_.ofHook(*hook.hook, setup)) {
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

void Assembly::addSources(const PlacedModel& object, std::uint32_t idle) {
    const dat::Setup* setup = object.model >> 24 == 0x02 ? records_.setup(object.model) : nullptr;
    if (setup == nullptr)
        return;
    const std::uint32_t stands[] = {cycles_.of(object.model)[static_cast<std::size_t>(Gait::Stand)]};
    std::size_t number = 0;
    for (const EmitterStart& start : startsOf(*setup, stands)) {
        ParticleSource source;
        source.idle = idle;
        source.seed = seedOf(object.object, number++);
        source.space = spaceOf(object.cell);
        const Pose rest = start.part < setup->parts.size() ? restOf(*setup, start.part) : Pose();
        source.at = {rest.orientation, rest.origin};
        if (idle == kNone) {
            const Vec3 origin = world_.blocks[block_].origin() + object.origin;
            source.at = {object.orientation * rest.orientation,
                         origin + object.orientation * rest.origin * object.scale};
        }
        if (const auto made = sourceOf(start, *setup, source))
            world_.particleSources.push_back(*made);
    }
}

void Assembly::addSources(std::uint32_t villager, dat::RecordId model, const PlayEntry& play) {
    const dat::Setup* setup = model >> 24 == 0x02 ? records_.setup(model) : nullptr;
    if (setup == nullptr)
        return;
    std::vector<EmitterStart> starts = startsOf(*setup, world_.villagers[villager].body.cycles);
    const dat::PhysicsScriptTable* table =
        play.kind != 0 && setup->scriptTable != 0 ? records_.physicsScriptTable(setup->scriptTable) : nullptr;
    const dat::RecordId script =
        table != nullptr ? chooseScript(*table, play.kind, static_cast<float>(play.intensity)) : 0;
    if (script != 0) {
        const std::vector<EmitterStart> played = starts_.ofScript(script, *setup);
        starts.insert(starts.end(), played.begin(), played.end());
    }
    std::size_t number = 0;
    for (const EmitterStart& start : starts) {
        ParticleSource source;
        source.villager = villager;
        source.seed = seedOf(movingObject(MovingThing::Villager, villager), number++);
        const Pose rest = start.part < setup->parts.size() ? restOf(*setup, start.part) : Pose();
        source.at = {rest.orientation, rest.origin};
        if (const auto made = sourceOf(start, *setup, source))
            world_.particleSources.push_back(*made);
    }
}

std::optional<ParticleSource> Assembly::sourceOf(const EmitterStart& start, const dat::Setup& setup,
                                                 ParticleSource source) {
    source.style = particleStyle(start.emitter);
    if (source.style == kNone)
        return std::nullopt;
    const ParticleStyle& style = world_.particleStyles[source.style];
    const bool isCarried = source.villager != kNone || source.idle != kNone;
    source.part = isCarried && start.part < setup.parts.size() ? start.part : kNone;
    source.offset = start.offset;
    source.cycle = start.cycle;
    source.start = start.at;
    source.period = start.period;
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

void Assembly::addWeather() {
    if (region_ == nullptr || (region_->partsMask & dat::Region::kSky) == 0)
        return;
    for (std::uint32_t group = 0; group < region_->sky.dayGroups.size(); ++group) {
        const std::vector<dat::SkyObject>& objects = region_->sky.dayGroups[group].objects;
        for (std::uint32_t i = 0; i < objects.size(); ++i)
            addWeather(group, i, objects[i]);
    }
}

/// What its script starts at the eye; an object without one that is a Setup may have one of its own. formats/sky_weather.md.
void Assembly::addWeather(std::uint32_t dayGroup, std::uint32_t number, const dat::SkyObject& object) {
    const dat::Setup bare;
    const dat::Setup* model = object.object >> 24 == 0x02 ? records_.setup(object.object) : nullptr;
    const dat::Setup& setup = model != nullptr ? *model : bare;
    const std::vector<EmitterStart> starts =
        object.script != 0 ? starts_.ofScript(object.script, setup) : starts_.ofDefaultScript(setup);
    std::size_t count = 0;
    for (const EmitterStart& start : starts) {
        ParticleSource source;
        source.seed = seedOf(std::uint64_t{dayGroup} << 32 | number, count++);
        source.isAlone = true;
        std::optional<ParticleSource> made = sourceOf(start, setup, source);
        if (!made)
            continue;
        ParticleStyle style = world_.particleStyles[made->style];
        const Vec3 spread = spreadOf(style.offset);
        style.offset = {};
        made->style = static_cast<std::uint32_t>(world_.particleStyles.size());
        world_.particleStyles.push_back(style);
        world_.sky.weather.push_back({dayGroup, object, *made, spread, levelRange(style, made->offset)});
    }
}

std::uint32_t Assembly::particleStyle(dat::RecordId emitter) {
    const auto [entry, fresh] = particleStyles_.try_emplace(emitter, kNone);
    const dat::ParticleEmitter* record = fresh ? records_.particleEmitter(emitter) : nullptr;
    if (record == nullptr)
        return entry->second;
    std::optional<ParticleStyle> style = particleStyleOf(*record);
    if (!style)
        return kNone;
    style->part = particlePart(*record, *style);
    if (style->part == kNone)
        return kNone;
    style->size = sizeOf(world_, world_.meshes[world_.movingParts[style->part].mesh]);
    entry->second = static_cast<std::uint32_t>(world_.particleStyles.size());
    world_.particleStyles.push_back(*style);
    return entry->second;
}

/// What is drawn for each particle: its mesh, or, where the nearest level of detail is a sprite, a flat picture as large.
std::uint32_t Assembly::particlePart(const dat::ParticleEmitter& record, ParticleStyle& style) {
    const Model& model = models_.model(record.gfxObj);
    const PartMesh* mesh = model.parts.empty() ? nullptr : models_.part(model.parts.front().gfxObj);
    if (mesh == nullptr || mesh->mesh.empty() || mesh->surfaces.empty())
        return kNone;
    style.facesEye = isSprite(record.gfxObj, records_);
    const auto key = static_cast<std::uint32_t>(world_.particleStyles.size());
    const bool blends = fades(style.translucency);
    Instance part;
    part.kind = InstanceKind::Dynamic;
    part.firstMaterial = partMaterials(*mesh);
    if (blends)
        part.firstMaterial = ghostMaterials(part.firstMaterial, mesh->surfaces.size());
    if (style.facesEye) {
        part.firstMaterial += mesh->mesh.vertices.front().surface;
        part.mesh = particleSprite(*mesh, world_.materials[world_.materialRefs[part.firstMaterial]]);
    } else {
        part.mesh = blends ? arena_.add(asGlass(mesh->mesh), contentKey(MeshSource::Particle, record.id))
                           : arena_.shared(*mesh);
    }
    part.bounds = world_.meshes[part.mesh].bounds;
    part.object = movingObject(MovingThing::Particle, key);
    part.record = mesh->gfxObj;
    part.levelRange = model.parts.front().reach;
    world_.movingParts.push_back(part);
    return static_cast<std::uint32_t>(world_.movingParts.size() - 1);
}

std::uint32_t Assembly::particleSprite(const PartMesh& mesh, const Material& material) {
    Vec2f low(std::numeric_limits<float>::infinity()), high(-low);
    for (const MeshVertex& vertex : mesh.mesh.vertices) {
        const Vec2f at(vertex.position.x, vertex.position.z);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const SurfaceList surfaces = listOf(material.surfaceClass, (material.flags & Material::kSplit) != 0);
    return arena_.add(
        spriteMesh(surfaces, low, high),
        contentKey(MeshSource::Particle, mesh.gfxObj, static_cast<std::uint32_t>(world_.movingParts.size())));
}

void Assembly::findAloneness() {
    const Membership membership(world_);
    std::vector<SpaceIndex> reached;
    const auto isAlone = [&](SpaceIndex space, const Sphere& sphere) {
        membership.reach(space, sphere, {}, reached);
        return reached.size() == 1;
    };
    for (IdleObject& idle : world_.idleObjects) {
        const Sphere& sphere = idle.body.bounds;
        const Vec3 centre = idle.origin + idle.orientation * sphere.centre * idle.scale;
        idle.isAlone = isAlone(idle.space, {centre, sphere.radius * idle.scale});
    }
    for (ParticleSource& source : world_.particleSources)
        if (source.villager == kNone && source.idle == kNone)
            source.isAlone = isAlone(source.space, {source.at.origin, source.reach});
}

} // namespace limen::world
