#include "world/assemble/SkyAssembler.h"

#include "world/SkyCover.h"

#include <set>

namespace limen::world {
namespace {

/// A mesh in the pose of its part: sky parts turn about the eye and have no origin of their own.
MeshData posed(const MeshData& mesh, const ModelPart& part) {
    MeshData out = mesh;
    for (MeshVertex& vertex : out.vertices)
        vertex.position = Vec3f(part.origin + part.linear * vertex.corner());
    return out;
}

} // namespace

void SkyAssembler::add(const dat::SkyDesc& sky) {
    for (std::uint32_t group = 0; group < sky.dayGroups.size(); ++group) {
        const std::vector<dat::SkyObject>& objects = sky.dayGroups[group].objects;
        for (std::uint32_t i = 0; i < objects.size(); ++i) {
            addParts({group, i, kNone, 0, objects[i], 0}, objects[i].object);
            std::set<dat::RecordId> replacements;
            for (const dat::SkyTimeOfDay& time : sky.dayGroups[group].times) {
                for (const dat::SkyObjectReplace& replace : time.replaces)
                    if (replace.objectIndex == i && replacements.insert(replace.gfxObj).second)
                        addParts({group, i, kNone, 0, objects[i], replace.gfxObj}, replace.gfxObj);
            }
        }
    }
    findSkyCover(world_);
}

void SkyAssembler::addParts(const SkyPart& part, dat::RecordId model) {
    if (model == 0)
        return;
    const std::vector<ModelPart>& parts = models_.model(model).parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const PartMesh* mesh = models_.part(parts[p].gfxObj);
        if (mesh == nullptr || mesh->mesh.empty())
            continue;
        const auto [entry, fresh] = meshes_.try_emplace({model, p}, 0);
        if (fresh)
            entry->second = arena_.add(posed(mesh->mesh, parts[p]),
                                       contentKey(MeshSource::Sky, model, static_cast<std::uint32_t>(p)));
        world_.sky.parts.push_back(part);
        world_.sky.parts.back().mesh = entry->second;
        world_.sky.parts.back().firstMaterial = materials_.ofPart(*mesh);
    }
}

} // namespace limen::world
