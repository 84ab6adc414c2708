#include "world/assemble/MaterialRuns.h"

#include "core/Assert.h"

namespace limen::world {

std::uint32_t MaterialRuns::append(std::span<const std::uint32_t> run) {
    const auto first = static_cast<std::uint32_t>(world_.materialRefs.size());
    for (const std::uint32_t material : run)
        LIMEN_ASSERT(material < world_.materials.size(), "a run refers to the world's materials");
    world_.materialRefs.insert(world_.materialRefs.end(), run.begin(), run.end());
    return first;
}

std::uint32_t MaterialRuns::add(std::span<const dat::RecordId> surfaces, const std::vector<bool>& clamp) {
    std::vector<std::uint32_t> run;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        run.push_back(materials_.material(surfaces[i], i < clamp.size() && clamp[i]));
    return append(run);
}

std::uint32_t MaterialRuns::ofPart(const PartMesh& part) {
    const auto [entry, fresh] = byPart_.try_emplace(part.gfxObj, 0);
    if (fresh)
        entry->second = add(part.surfaces, part.clamp);
    return entry->second;
}

std::uint32_t MaterialRuns::ofDressedPart(const PartMesh& part, std::uint32_t number, const Dress& dress) {
    if (dress.empty())
        return ofPart(part);
    const DressedPart* worn = dress.part(number);
    LIMEN_ASSERT(part.clamp.size() == part.surfaces.size(), "one flag for each slot");
    std::vector<std::uint32_t> run;
    for (std::size_t i = 0; i < part.surfaces.size(); ++i)
        run.push_back(materials_.material(part.surfaces[i], part.clamp[i],
                                          worn != nullptr
                                              ? std::span<const dat::TextureChange>(worn->textures)
                                              : std::span<const dat::TextureChange>(),
                                          dress.overlays));
    return append(run);
}

std::uint32_t MaterialRuns::addBlended(std::uint32_t firstMaterial, std::size_t count) {
    LIMEN_ASSERT(firstMaterial + count <= world_.materialRefs.size(), "the run to copy exists");
    std::vector<std::uint32_t> run;
    for (std::size_t slot = 0; slot < count; ++slot) {
        Material material = world_.materials[world_.materialRefs[firstMaterial + slot]];
        material.surfaceClass = SurfaceClass::Blended;
        material.flags &= ~Material::kSplit;
        run.push_back(static_cast<std::uint32_t>(world_.materials.size()));
        world_.materials.push_back(material);
    }
    return append(run);
}

std::uint32_t MaterialRuns::addPlain(const Vec4f& colour, SurfaceClass surfaces) {
    Material material;
    material.colour = colour;
    material.surfaceClass = surfaces;
    material.flags = surfaces == SurfaceClass::Blended ? Material::kAlpha : 0;
    world_.materials.push_back(material);
    const std::uint32_t run[] = {static_cast<std::uint32_t>(world_.materials.size() - 1)};
    return append(run);
}

} // namespace limen::world
