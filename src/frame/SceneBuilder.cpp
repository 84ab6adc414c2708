#include "frame/SceneBuilder.h"

#include "frame/PackInstance.h"

#include <algorithm>
#include <bit>

namespace limen::frame {

namespace {

/// A unit vector in signed normalised 10-10-10-2.
std::uint32_t packNormal(const Vec3f& n) {
    const auto pack = [](float v) {
        const long i = std::lround(std::clamp(v, -1.0f, 1.0f) * 511.0f);
        return static_cast<std::uint32_t>(i) & 0x3FFu;
    };
    return pack(n.x) | pack(n.y) << 10 | pack(n.z) << 20;
}

gpu::TerrainLayer packLayer(const world::TerrainCell::Layer& in) {
    return {in.texture, in.alpha, in.rotation, in.tiling};
}

gpu::TerrainCell packTerrain(const world::TerrainCell& in) {
    gpu::TerrainCell out;
    out.base = packLayer(in.base);
    for (std::size_t i = 0; i < in.overlays.size(); ++i)
        out.overlays[i] = packLayer(in.overlays[i]);
    for (std::size_t i = 0; i < in.roads.size(); ++i)
        out.roads[i] = packLayer(in.roads[i]);
    return out;
}

/// The resident block that a light is stored relative to: the block that contains it, else any.
std::uint32_t blockFor(const world::World& world, const Vec3& position) {
    for (std::uint32_t b = 0; b < world.blocks.size(); ++b) {
        const Vec3 local = position - world.blocks[b].origin();
        if (local.x >= 0.0 && local.y >= 0.0 && local.x < world::kBlockSize && local.y < world::kBlockSize)
            return b;
    }
    return 0;
}

gpu::Light packLight(const world::World& world, const world::Light& in) {
    const std::uint32_t block = blockFor(world, in.position);
    const Vec3f local(in.position - (world.blocks.empty() ? Vec3(0.0) : world.blocks[block].origin()));
    return {{local, in.range}, {in.colour, std::bit_cast<float>(block)}};
}

/// Indices into the arena. World::indices are relative to the first vertex of their mesh.
std::vector<std::uint32_t> indicesOfArena(const world::World& world) {
    std::vector<std::uint32_t> indices = world.indices;
    for (const world::Mesh& mesh : world.meshes) {
        for (const world::Mesh::Range& range : mesh.ranges)
            for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; ++i)
                indices[i] = world.indices[i] + mesh.firstVertex;
    }
    return indices;
}

void addMaterials(const world::World& world, SceneUpload& scene) {
    for (const world::Material& m : world.materials) {
        std::uint32_t flags = 0;
        flags |= (m.flags & world::Material::kClamp) != 0 ? gpu::kMaterialClamp : 0;
        flags |= (m.flags & world::Material::kAdditive) != 0 ? gpu::kMaterialAdditive : 0;
        flags |= (m.flags & world::Material::kInvAlpha) != 0 ? gpu::kMaterialInvAlpha : 0;
        flags |= (m.flags & world::Material::kAlpha) != 0 ? gpu::kMaterialAlpha : 0;
        flags |= (m.flags & world::Material::kSplit) != 0 ? gpu::kMaterialSplit : 0;
        flags |= (m.flags & world::Material::kIndexed) != 0 ? gpu::kMaterialIndexed : 0;
        scene.materials.push_back({m.colour, m.texture, flags, m.luminosity, m.diffuse});
    }
    scene.materialRefs = world.materialRefs;
}

/// By texture: 1 if every use of it allows clamping to the edge (blend maps; textures with all coordinates
/// within 0..1). If any use repeats a texture, all uses repeat it.
std::vector<std::uint8_t> clampedTextures(const world::World& world) {
    std::vector<std::uint8_t> clamped(world.textures.size(), 0);
    const auto mark = [&](std::uint32_t texture, bool clamp) {
        if (texture != world::kNone)
            clamped[texture] = static_cast<std::uint8_t>(clamped[texture] | (clamp ? 1 : 2));
    };
    for (const world::TerrainCell& cell : world.terrainCells) {
        for (const world::TerrainCell::Layer& layer : cell.overlays)
            mark(layer.alpha, true);
        for (const world::TerrainCell::Layer& layer : cell.roads)
            mark(layer.alpha, true);
    }
    for (const world::Material& m : world.materials)
        mark(m.texture, (m.flags & world::Material::kClamp) != 0);
    for (std::uint8_t& c : clamped)
        c = c == 1 ? 1 : 0;
    return clamped;
}

void addTextures(const world::World& world, SceneUpload& scene) {
    const std::vector<std::uint8_t> clamped = clampedTextures(world);
    for (std::size_t i = 0; i < world.textures.size(); ++i) {
        const world::Image& image = *world.textures[i];
        scene.textures.push_back({image.width, image.height, image.rgba, clamped[i] != 0, image.contentKey});
    }
}

/// Whether a lamp of the instance's light sets reaches its bounds.
bool isLampLit(const world::World& world, const world::Instance& instance) {
    const auto members = std::span(world.members).subspan(instance.firstMember, instance.memberCount);
    return std::any_of(members.begin(), members.end(), [&](world::SpaceIndex space) {
        const world::LightSet& set = world.lightSets[world.spaces[space].lightSet];
        const auto lamps = std::span(world.lights).subspan(set.firstLight, set.lightCount);
        return std::any_of(lamps.begin(), lamps.end(), [&](const world::Light& lamp) {
            return glm::length(lamp.position - instance.bounds.centre) <
                   double{lamp.range} + instance.bounds.radius;
        });
    });
}

} // namespace

SceneUpload buildScene(const StaticScene& scene) {
    const world::World& world = scene.world();
    SceneUpload upload;
    upload.vertices.reserve(world.vertices.size());
    for (const world::MeshVertex& v : world.vertices) {
        upload.vertices.push_back({v.position, packNormal(v.normal), v.uv,
                                   v.polygon | std::uint32_t{v.surface} << 16, v.facet, v.neighbour, v.rest});
    }
    upload.indices = indicesOfArena(world);
    upload.members.assign(scene.members().begin(), scene.members().end());
    upload.instances.assign(scene.records().begin(), scene.records().end());
    for (const world::Level& level : world.levels)
        upload.levels.push_back(packLevel(level));
    upload.pieces = scene.pieces().pieces;
    addMaterials(world, upload);
    addTextures(world, upload);
    for (const world::TerrainCell& cell : world.terrainCells)
        upload.terrainCells.push_back(packTerrain(cell));
    for (const world::LightSet& set : world.lightSets)
        upload.lightSets.push_back({{set.ambient, set.sky}, set.sun, set.firstLight, set.lightCount, 0});
    for (const world::Instance& instance : world.instances)
        upload.lampLit.push_back(isLampLit(world, instance) ? 1 : 0);
    for (const world::Light& light : world.lights)
        upload.lights.push_back(packLight(world, light));
    return upload;
}

} // namespace limen::frame
