#include "plain/MeshParts.h"

#include "core/Assert.h"
#include "core/Hash.h"
#include "world/LevelRange.h"
#include "world/Lookup.h"
#include "world/Sky.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace limen::bench {

namespace {

struct VertexHash {
    std::size_t operator()(const PlainVertex& vertex) const {
        Hash hash;
        hash.addWords(std::as_bytes(std::span(&vertex, 1)));
        return hash.value();
    }
};

/// A part while its corners are gathered.
struct GatheredPart {
    MeshPart part;
    std::unordered_map<PlainVertex, std::uint32_t, VertexHash> numbers;

    void add(const PlainVertex& corner) {
        const auto next = static_cast<std::uint32_t>(part.vertices.size());
        const auto [entry, isNew] = numbers.try_emplace(corner, next);
        if (isNew)
            part.vertices.push_back(corner);
        part.indices.push_back(entry->second);
    }
};

PlainSurface surfaceOf(const world::Material& material, float opacity) {
    const auto has = [&](std::uint32_t flag) { return (material.flags & flag) != 0; };
    const bool isBlended = material.surfaceClass == world::SurfaceClass::Blended;
    PlainSurface surface{material.texture,
                         material.surfaceClass,
                         material.colour,
                         material.luminosity,
                         has(world::Material::kClamp),
                         isBlended && has(world::Material::kAdditive),
                         isBlended && has(world::Material::kInvAlpha)};
    if (isBlended)
        surface.colour.w *= opacity;
    return surface;
}

/// By slot: the index of a material, or of terrain the index of a base texture.
std::uint32_t slotKey(const world::World& world, const world::Instance& instance, std::uint32_t slot) {
    return instance.kind == world::InstanceKind::Terrain
               ? world.terrainCells[instance.firstMaterial + slot].base.texture
               : world.materialRefs[instance.firstMaterial + slot];
}

PlainSurface surfaceOf(const world::World& world, const world::Instance& instance, std::uint32_t key) {
    if (instance.kind != world::InstanceKind::Terrain)
        return surfaceOf(world.materials[key], instance.opacity);
    PlainSurface surface;
    surface.texture = key;
    return surface;
}

std::size_t trianglesOf(const world::Mesh& mesh) {
    std::size_t indices = 0;
    for (const world::Mesh::Range& range : mesh.ranges)
        indices += range.indexCount;
    return indices / 3;
}

} // namespace

std::vector<MeshPart> partsOf(const world::World& world, const world::Instance& instance) {
    LIMEN_ASSERT(instance.mesh != world::kNone, "the instance has a mesh");
    const world::Mesh& mesh = world.meshes[instance.mesh];
    const bool isTerrain = instance.kind == world::InstanceKind::Terrain;
    std::map<std::uint32_t, GatheredPart> gathered;
    for (const world::Mesh::Range& range : mesh.ranges) {
        for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; ++i) {
            const world::MeshVertex& v = world.vertices[world.indices[i] + mesh.firstVertex];
            const float tiling =
                isTerrain ? world.terrainCells[instance.firstMaterial + v.surface].base.tiling : 1.0f;
            const auto [entry, isNew] = gathered.try_emplace(slotKey(world, instance, v.surface));
            if (isNew)
                entry->second.part.surface = surfaceOf(world, instance, entry->first);
            entry->second.add({v.position, v.normal, v.uv * tiling});
        }
    }
    std::vector<MeshPart> parts;
    parts.reserve(gathered.size());
    for (auto& [key, found] : gathered)
        parts.push_back(std::move(found.part));
    return parts;
}

Vec3 originNear(const Vec3& eye) {
    world::Block block;
    block.coord = world::blockAt(eye);
    return block.origin();
}

glm::mat4 placementOf(const world::World& world, const world::Instance& instance, const Vec3& origin) {
    LIMEN_ASSERT(instance.block < world.blocks.size(), "the instance has a block");
    const Vec3 at = world.blocks[instance.block].origin() - origin + Vec3(instance.origin);
    glm::mat4 placement(instance.linear);
    placement[3] = Vec4f(Vec3f(at), 1.0f);
    return placement;
}

PlainLight plainLightOf(const world::World& world, const frame::FrameView& view) {
    const world::SkyState sky = world::skyAt(world.sky, view.dayGroup, view.timeOfDay);
    return {sky.sunDirection, sky.sunColour, sky.thingsAmbient()};
}

std::size_t trianglesFrom(const world::World& world, const world::DynamicState& dynamics, const Vec3& eye) {
    const world::RangeSteps steps = world::rangeStepsOf(eye);
    std::size_t triangles = 0;
    for (const std::vector<world::Instance>* instances : {&world.instances, &dynamics.instances})
        for (const world::Instance& instance : *instances)
            if (instance.mesh != world::kNone && world::isInLevelRange(world, instance, steps))
                triangles += trianglesOf(world.meshes[instance.mesh]);
    return triangles;
}

} // namespace limen::bench
