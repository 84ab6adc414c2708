#include "world/Assembly.h"

// The part of Assembly that makes the player's body.
namespace limen::world {

MeshData asGlass(const MeshData& solid) {
    MeshData glass = solid;
    std::vector<std::uint32_t>& blended = glass.indicesOf(SurfaceList::Blended);
    for (const SurfaceList list : {SurfaceList::Opaque, SurfaceList::CutOut, SurfaceList::Split}) {
        std::vector<std::uint32_t>& from = glass.indicesOf(list);
        blended.insert(blended.end(), from.begin(), from.end());
        from.clear();
    }
    return glass;
}

void Assembly::addPlayer(dat::RecordId model, const Dress& dress) {
    world_.player.solid = addBody(model, InstanceKind::Dynamic, movingObject(MovingThing::Player, 0), dress);
    world_.player.ghost = addGhost(world_.player.solid);
}

MovingBody Assembly::addGhost(const MovingBody& solid) {
    MovingBody ghost = solid;
    ghost.firstPart = static_cast<std::uint32_t>(world_.movingParts.size());
    for (std::uint32_t p = solid.firstPart; p < solid.firstPart + solid.partCount; ++p) {
        Instance part = world_.movingParts[p];
        const PartMesh& mesh = *models_.part(part.record); // there: the solid part was made from it
        part.mesh = arena_.add(asGlass(mesh.mesh), contentKey(MeshSource::Ghost, part.record, p));
        part.firstMaterial = ghostMaterials(part.firstMaterial, mesh.surfaces.size());
        world_.movingParts.push_back(part);
    }
    return ghost;
}

std::uint32_t Assembly::ghostMaterials(std::uint32_t firstMaterial, std::size_t count) {
    const auto first = static_cast<std::uint32_t>(world_.materialRefs.size());
    for (std::size_t slot = 0; slot < count; ++slot) {
        Material material = world_.materials[world_.materialRefs[firstMaterial + slot]];
        material.surfaceClass = SurfaceClass::Blended;
        material.flags &= ~Material::kSplit;
        world_.materialRefs.push_back(static_cast<std::uint32_t>(world_.materials.size()));
        world_.materials.push_back(material);
    }
    return first;
}

} // namespace limen::world
