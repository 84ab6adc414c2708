#include "world/assemble/ParticleStyleAssembler.h"

#include "core/Assert.h"
#include "world/assemble/BodyAssembler.h"
#include "world/assemble/LevelEntries.h"
#include "world/records/ParticleStyles.h"

#include <algorithm>
#include <limits>

namespace limen::world {
namespace {

bool fades(const dat::Fade& translucency) {
    return translucency.start != 0.0f || translucency.end != 0.0f || translucency.random != 0.0f;
}

/// Distance of a mesh's farthest corner from its origin, metres.
double sizeOf(const World& world, const Mesh& mesh) {
    double size = 0.0;
    for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v)
        size = std::max(size, glm::length(world.vertices[v].corner()));
    return size;
}

} // namespace

std::uint32_t ParticleStyleAssembler::styleOf(dat::RecordId emitter) {
    const auto [entry, fresh] = byEmitter_.try_emplace(emitter, kNone);
    const dat::ParticleEmitter* record = fresh ? records_.particleEmitter(emitter) : nullptr;
    if (record == nullptr)
        return entry->second;
    std::optional<ParticleStyle> style = particleStyleOf(*record);
    if (!style)
        return kNone;
    style->part = addPart(*record, *style);
    if (style->part == kNone)
        return kNone;
    style->size = sizeOf(world_, world_.meshes[world_.movingParts[style->part].mesh]);
    entry->second = static_cast<std::uint32_t>(world_.particleStyles.size());
    world_.particleStyles.push_back(*style);
    return entry->second;
}

std::uint32_t ParticleStyleAssembler::addPart(const dat::ParticleEmitter& record, ParticleStyle& style) {
    const Model& model = models_.model(record.gfxObj);
    const PartMesh* mesh = model.parts.empty() ? nullptr : models_.part(model.parts.front().gfxObj);
    if (mesh == nullptr || mesh->mesh.empty() || mesh->surfaces.empty())
        return kNone;
    style.facing = facingOf(record.gfxObj, records_);
    const auto key = static_cast<std::uint32_t>(world_.particleStyles.size());
    const bool blends = fades(style.translucency);
    Instance part;
    part.kind = InstanceKind::Dynamic;
    part.firstMaterial = materials_.ofPart(*mesh);
    if (blends)
        part.firstMaterial = materials_.addBlended(part.firstMaterial, mesh->surfaces.size());
    if (style.facing != Facing::Fixed) {
        part.firstMaterial += mesh->mesh.vertices.front().surface;
        LIMEN_ASSERT(part.firstMaterial < world_.materialRefs.size(), "a vertex has a slot of its mesh");
        part.mesh = addSprite(*mesh, world_.materials[world_.materialRefs[part.firstMaterial]]);
    } else {
        part.mesh = blends ? arena_.add(blendedMesh(mesh->mesh), contentKey(MeshSource::Particle, record.id))
                           : arena_.shared(*mesh);
    }
    part.bounds = world_.meshes[part.mesh].bounds;
    part.object = dynamicObject(DynamicObject::Particle, key);
    part.record = mesh->gfxObj;
    part.level = addLevel({levelRangeOf(models_.particleBand(record.gfxObj), 1.0), {}, {}}, world_);
    world_.movingParts.push_back(part);
    return static_cast<std::uint32_t>(world_.movingParts.size() - 1);
}

std::uint32_t ParticleStyleAssembler::addSprite(const PartMesh& mesh, const Material& material) {
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

} // namespace limen::world
