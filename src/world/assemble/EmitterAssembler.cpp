#include "world/assemble/EmitterAssembler.h"

#include "core/Assert.h"
#include "world/Lookup.h"
#include "world/assemble/BodyAssembler.h"

#include <algorithm>

namespace limen::world {

void EmitterAssembler::add(const EmitterEntry& entry) {
    Emitter emitter;
    emitter.name = entry.name;
    emitter.position = entry.position;
    if (!entry.attachedTo.empty()) {
        const auto found = std::find_if(world_.villagers.begin(), world_.villagers.end(),
                                        [&](const Villager& v) { return v.name == entry.attachedTo; });
        if (found == world_.villagers.end())
            return;
        emitter.villager = static_cast<std::uint32_t>(found - world_.villagers.begin());
    } else {
        emitter.space = entry.cell == 0 ? kOutside : findCell(world_, entry.cell);
        const bool there = emitter.space != kNone && (emitter.space != kOutside ||
                                                      findBlock(world_, blockAt(entry.position)) != nullptr);
        if (!there)
            return;
    }
    emitter.rate = entry.rate;
    emitter.life = entry.life;
    emitter.velocity = entry.velocity;
    emitter.acceleration = entry.acceleration;
    emitter.spread = entry.spread;
    emitter.radius = entry.radius;
    std::copy(entry.size.begin(), entry.size.end(), emitter.size);
    std::copy(entry.alpha.begin(), entry.alpha.end(), emitter.alpha);
    emitter.seed = entry.seed;
    emitter.reach = entry.radius +
                    (glm::length(entry.velocity) + std::sqrt(3.0) * entry.spread) * entry.life +
                    0.5 * glm::length(entry.acceleration) * entry.life * entry.life +
                    std::max(entry.size[0], entry.size[1]);
    const dat::RecordId surfaces[] = {entry.surface};
    emitter.sprite =
        addSprite(materials_.add(surfaces, {true}), static_cast<std::uint32_t>(world_.emitters.size()));
    world_.emitters.push_back(std::move(emitter));
}

void EmitterAssembler::addRainDrop() {
    LIMEN_ASSERT(world_.rainDrop == kNone, "a world has one rain drop");
    world_.rainDrop =
        addSprite(materials_.addPlain(Vec4f(0.75f, 0.8f, 0.88f, 0.35f), SurfaceClass::Blended), kNone);
}

std::uint32_t EmitterAssembler::addSprite(std::uint32_t firstMaterial, std::uint32_t key) {
    LIMEN_ASSERT(firstMaterial < world_.materialRefs.size(), "the sprite's material exists");
    const Material& material = world_.materials[world_.materialRefs[firstMaterial]];
    const SurfaceList surfaces = listOf(material.surfaceClass, (material.flags & Material::kSplit) != 0);
    Instance sprite;
    sprite.kind = InstanceKind::Dynamic;
    sprite.mesh =
        arena_.add(spriteMesh(surfaces, Vec2f(-0.5f), Vec2f(0.5f)), contentKey(MeshSource::Sprite, key));
    sprite.bounds = world_.meshes[sprite.mesh].bounds;
    sprite.object = dynamicObject(DynamicObject::Sprite, key);
    sprite.firstMaterial = firstMaterial;
    world_.movingParts.push_back(sprite);
    return static_cast<std::uint32_t>(world_.movingParts.size() - 1);
}

} // namespace limen::world
