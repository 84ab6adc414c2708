#include "world/Assembly.h"

#include <algorithm>
#include <set>

// The part of Assembly that makes instances, materials and the sky.
namespace limen::world {
namespace {

/// Identity of what a record is as a whole (shells, terrain); its objects count from 0 on.
std::uint64_t wholeObject(dat::RecordId record) {
    return static_cast<std::uint64_t>(record) << 32 | 0xFFFFFFFFu;
}

double largestScale(const Mat3& m) {
    return std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
}

/// Sphere of a model-space sphere, globally.
Sphere placedSphere(const Sphere& sphere, const Mat3& linear, const Vec3& origin) {
    if (sphere.radius < 0.0)
        return sphere;
    return {origin + linear * sphere.centre, sphere.radius * largestScale(linear)};
}

const dat::TerrainTexture* terrainTexture(const dat::Region& region, std::uint32_t type) {
    const auto& textures = region.texMerge.textures;
    const auto found =
        std::find_if(textures.begin(), textures.end(), [&](const auto& t) { return t.terrainType == type; });
    if (found != textures.end())
        return &*found;
    return textures.empty() ? nullptr : &textures.front();
}

std::vector<std::uint32_t> codesOf(const std::vector<dat::AlphaMap>& maps) {
    std::vector<std::uint32_t> codes;
    for (const dat::AlphaMap& map : maps)
        codes.push_back(map.code);
    return codes;
}

/// A mesh moved by a part's pose: sky parts turn about the eye and have no place of their own.
MeshData posed(const MeshData& mesh, const ModelPart& part) {
    MeshData out = mesh;
    for (MeshVertex& vertex : out.vertices)
        vertex.position = Vec3f(part.origin + part.linear * vertex.corner());
    return out;
}

} // namespace

Instance& Assembly::addBaked(InstanceKind kind, const MeshData& data, std::uint64_t key, std::uint64_t object,
                             dat::RecordId record) {
    Instance instance;
    instance.kind = kind;
    instance.mesh = arena_.add(data, key);
    instance.block = block_;
    instance.bounds = world_.meshes[instance.mesh].bounds;
    instance.bounds.centre += world_.blocks[block_].origin();
    instance.placedIn = kOutside;
    instance.object = object;
    instance.record = record;
    world_.instances.push_back(instance);
    return world_.instances.back();
}

void Assembly::addTerrain(const BlockContent& block) {
    if (!block.ground)
        return;
    const dat::RecordId id = dat::landBlockId(block.coord);
    const std::uint32_t cells = terrainRun(*block.ground);
    addBaked(InstanceKind::Terrain, block.terrain, contentKey(MeshSource::Terrain, id), wholeObject(id), id)
        .firstMaterial = cells;
}

void Assembly::addExteriors(const BlockContent& block) {
    std::uint32_t index = 0;
    for (const ExteriorContent& exterior : block.exteriors) {
        const std::uint32_t materials = materialRun(exterior.surfaces, {});
        const std::uint64_t key =
            contentKey(MeshSource::Exterior, dat::landBlockInfoId(block.coord), index++);
        addBaked(InstanceKind::Exterior, exterior.mesh, key, exterior.object, exterior.gfxObj).firstMaterial =
            materials;
    }
}

void Assembly::addShells(const BlockContent& block) {
    for (std::uint32_t i = 0; i < block.cells.size(); ++i) {
        const CellContent& cell = block.cells[i];
        const std::uint32_t materials = materialRun(cell.surfaces, {});
        Instance& shell = addBaked(InstanceKind::Shell, cell.shell, contentKey(MeshSource::Shell, cell.id),
                                   wholeObject(cell.id), cell.id);
        shell.firstMaterial = materials;
        shell.placedIn = spaceOf(i);
        if (world_.zones[world_.spaces[spaceOf(i)].zone].spaceCount > 1)
            arena_.tellNeighbours(shell.mesh);
        world_.spaces[spaceOf(i)].shell = static_cast<InstanceIndex>(world_.instances.size() - 1);
    }
}

void Assembly::addObjects(const BlockContent& block) {
    const Vec3 blockOrigin = world_.blocks[block_].origin();
    for (const PlacedModel& object : block.objects) {
        const Model& model = models_.model(object.model);
        const Mat3 linear = glm::mat3_cast(object.orientation) * object.scale;
        const Vec3 origin = blockOrigin + object.origin;
        const auto nextIdle = static_cast<std::uint32_t>(world_.idleObjects.size());
        if (const bool isIdle = addIdle(object); !isIdle)
            addResident(object, model, placedSphere(model.bounds, linear, origin));
        addSources(object, world_.idleObjects.size() > nextIdle ? nextIdle : kNone);
        for (const ModelLight& light : model.lights)
            lamps_.push_back(
                {{origin + linear * light.position, light.colour, light.range}, spaceOf(object.cell)});
    }
}

void Assembly::addResident(const PlacedModel& object, const Model& model, const Sphere& bounds) {
    Group group{static_cast<InstanceIndex>(world_.instances.size()), 0, bounds};
    for (const std::vector<ModelPart>* parts : {&model.parts, &model.farther})
        for (const ModelPart& part : *parts)
            addPart(object, part);
    group.count = static_cast<InstanceIndex>(world_.instances.size()) - group.first;
    if (group.count > 0)
        objects_.push_back(group);
}

void Assembly::addPart(const PlacedModel& object, const ModelPart& part) {
    const PartMesh* mesh = models_.part(part.gfxObj);
    if (mesh == nullptr || mesh->mesh.empty())
        return;
    const Mat3 linear = glm::mat3_cast(object.orientation) * object.scale * part.linear;
    const Vec3 origin = object.origin + object.orientation * part.origin * object.scale;
    Instance instance;
    instance.kind = object.kind;
    instance.mesh = arena_.shared(*mesh);
    instance.block = block_;
    instance.linear = glm::mat3(linear);
    instance.origin = Vec3f(origin);
    instance.bounds =
        placedSphere(world_.meshes[instance.mesh].bounds, linear, world_.blocks[block_].origin() + origin);
    instance.placedIn = spaceOf(object.cell);
    instance.object = object.object;
    instance.record = part.gfxObj;
    instance.firstMaterial = partMaterials(*mesh);
    instance.levelRange = part.reach;
    world_.instances.push_back(instance);
}

std::uint32_t Assembly::materialRun(std::span<const dat::RecordId> surfaces, const std::vector<bool>& clamp) {
    std::vector<std::uint32_t> run;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        run.push_back(materials_.material(surfaces[i], i < clamp.size() && clamp[i]));
    const auto first = static_cast<std::uint32_t>(world_.materialRefs.size());
    world_.materialRefs.insert(world_.materialRefs.end(), run.begin(), run.end());
    return first;
}

std::uint32_t Assembly::partMaterials(const PartMesh& part) {
    const auto [entry, fresh] = partMaterials_.try_emplace(part.gfxObj, 0);
    if (fresh)
        entry->second = materialRun(part.surfaces, clampOf(part));
    return entry->second;
}

std::vector<bool> Assembly::clampOf(const PartMesh& part) {
    // Clamping helps cut-outs, whose border would bleed across; walls of several quads tile on, and need
    // repeat.
    std::vector<bool> clamp = part.clamp;
    for (std::size_t i = 0; i < clamp.size(); ++i) {
        const dat::Surface* surface = records_.surface(part.surfaces[i]);
        clamp[i] = clamp[i] && surface != nullptr && surfaceClassOf(*surface) != SurfaceClass::Opaque;
    }
    return clamp;
}

std::uint32_t Assembly::dressedMaterials(const PartMesh& part, std::uint32_t number, const Dress& dress) {
    if (dress.empty())
        return partMaterials(part);
    const DressedPart* worn = dress.part(number);
    const std::vector<bool> clamp = clampOf(part);
    std::vector<std::uint32_t> run;
    for (std::size_t i = 0; i < part.surfaces.size(); ++i)
        run.push_back(materials_.material(part.surfaces[i], clamp[i],
                                          worn != nullptr
                                              ? std::span<const dat::TextureChange>(worn->textures)
                                              : std::span<const dat::TextureChange>(),
                                          dress.overlays));
    const auto first = static_cast<std::uint32_t>(world_.materialRefs.size());
    world_.materialRefs.insert(world_.materialRefs.end(), run.begin(), run.end());
    return first;
}

std::uint32_t Assembly::terrainRun(const Ground& ground) {
    const auto first = static_cast<std::uint32_t>(world_.terrainCells.size());
    for (int cell = 0; cell < 64; ++cell) {
        const CellCorners corners = ground.corners(cell / 8, cell % 8);
        const auto [entry, fresh] = painted_.try_emplace(paletteCode(corners));
        if (fresh)
            entry->second = paint(corners);
        world_.terrainCells.push_back(entry->second);
        world_.terrainCells.back().split = splitsSouthWestNorthEast(ground.coord, cell / 8, cell % 8) ? 1 : 0;
    }
    return first;
}

TerrainCell Assembly::paint(const CellCorners& corners) {
    const dat::TexMerge& merge = region_->texMerge;
    const BlendRecipe recipe = blendRecipe(corners);
    const std::uint32_t palette = paletteCode(corners);
    const auto layer = [&](std::uint32_t type) {
        TerrainCell::Layer out;
        if (const dat::TerrainTexture* texture = terrainTexture(*region_, type)) {
            out.texture = materials_.plainTexture(texture->texture);
            out.tiling = static_cast<float>(std::clamp(texture->tiling, 1u, 1024u));
        }
        return out;
    };
    const auto masked = [&](std::uint32_t type, const std::vector<dat::AlphaMap>& maps,
                            const AlphaChoice& choice) {
        TerrainCell::Layer out = layer(type);
        out.alpha = materials_.plainTexture(maps[choice.map].texture);
        out.rotation = choice.rotation;
        return out;
    };
    TerrainCell cell;
    cell.base = layer(recipe.base);
    std::size_t used = 0;
    for (const BlendLayer& overlay : recipe.overlays) {
        const bool corner = (overlay.code & (overlay.code - 1)) == 0;
        const std::vector<dat::AlphaMap>& maps = corner ? merge.corners : merge.sides;
        if (const auto choice = chooseTerrainMap(codesOf(maps), overlay.code, palette);
            choice && used < cell.overlays.size())
            cell.overlays[used++] = masked(overlay.terrainType, maps, *choice);
    }
    used = 0;
    for (const std::uint32_t code : recipe.roadCodes)
        if (const auto choice = chooseRoadMap(codesOf(merge.roads), code, palette);
            choice && used < cell.roads.size())
            cell.roads[used++] = masked(kRoadType, merge.roads, *choice);
    return cell;
}

void Assembly::addSky() {
    if (region_ == nullptr || (region_->partsMask & dat::Region::kSky) == 0)
        return;
    world_.sky.desc = region_->sky;
    world_.sky.time = region_->gameTime;
    SkyMeshes meshes;
    for (std::uint32_t group = 0; group < region_->sky.dayGroups.size(); ++group) {
        const std::vector<dat::SkyObject>& objects = region_->sky.dayGroups[group].objects;
        for (std::uint32_t i = 0; i < objects.size(); ++i) {
            addSkyParts({group, i, kNone, 0, objects[i], 0}, objects[i].object, meshes);
            std::set<dat::RecordId> replacements;
            for (const dat::SkyTimeOfDay& time : region_->sky.dayGroups[group].times) {
                for (const dat::SkyObjectReplace& replace : time.replaces)
                    if (replace.objectIndex == i && replacements.insert(replace.gfxObj).second)
                        addSkyParts({group, i, kNone, 0, objects[i], replace.gfxObj}, replace.gfxObj, meshes);
            }
        }
    }
}

void Assembly::addSkyParts(const SkyPart& part, dat::RecordId model, SkyMeshes& meshes) {
    if (model == 0)
        return;
    const std::vector<ModelPart>& parts = models_.model(model).parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const PartMesh* mesh = models_.part(parts[p].gfxObj);
        if (mesh == nullptr || mesh->mesh.empty())
            continue;
        const auto [entry, fresh] = meshes.try_emplace({model, p}, 0);
        if (fresh)
            entry->second = arena_.add(posed(mesh->mesh, parts[p]),
                                       contentKey(MeshSource::Sky, model, static_cast<std::uint32_t>(p)));
        world_.sky.parts.push_back(part);
        world_.sky.parts.back().mesh = entry->second;
        world_.sky.parts.back().firstMaterial = partMaterials(*mesh);
    }
}

} // namespace limen::world
