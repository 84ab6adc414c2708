#include "frame/SceneBuilder.h"

#include "frame/PackInstance.h"
#include "frame/ReadingDefines.h"

#include <algorithm>

namespace limen::frame {

namespace {

static_assert(world::kNone == gpu::kNoTexture);
static_assert(static_cast<std::uint32_t>(world::LightSet::Kind::Outdoors) == gpu::kLitOutdoors &&
              static_cast<std::uint32_t>(world::LightSet::Kind::Moving) == gpu::kLitMoving &&
              static_cast<std::uint32_t>(world::LightSet::Kind::Thing) == gpu::kLitThing &&
              static_cast<std::uint32_t>(world::LightSet::Kind::Walls) == gpu::kLitWalls);

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
    for (const std::uint32_t detail :
         {world.details.land.texture, world.details.exteriors.texture, world.details.shells.texture})
        mark(detail, false);
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
        upload.lightSets.push_back(
            {static_cast<std::uint32_t>(set.kind), set.firstLamp, set.lampCount, set.sealed ? 1u : 0u});
    upload.lampRefs = world.lampRefs;
    upload.details = {world.details.land.texture, world.details.exteriors.texture,
                      world.details.shells.texture};
    upload.defines = definesOf(world.readings);
    upload.lamps = static_cast<std::uint32_t>(world.lights.size());
    return upload;
}

} // namespace limen::frame
