#pragma once

#include "world/mesh/Models.h"
#include "world/texture/Materials.h"

namespace limen::world {

/// Adds runs of World::materialRefs: the materials of a mesh by surface slot. Each function yields the first
/// index of its run.
class MaterialRuns {
public:
    MaterialRuns(Materials& materials, World& world) : materials_(materials), world_(world) {}

    /// `clamp`: by slot, true if the picture does not repeat; slots beyond its end repeat.
    std::uint32_t add(std::span<const dat::RecordId> surfaces, const std::vector<bool>& clamp);
    /// The run of a part in its own materials. Parts of one GfxObj share it.
    std::uint32_t ofPart(const PartMesh& part);
    /// The run of part `number` of a Setup that wears `dress`.
    std::uint32_t ofDressedPart(const PartMesh& part, std::uint32_t number, const Dress& dress);
    /// A copy of a run in which every material is blended and none is split.
    std::uint32_t addBlended(std::uint32_t firstMaterial, std::size_t count);
    /// A run of one material without a texture.
    std::uint32_t addPlain(const Vec4f& colour, SurfaceClass surfaces);

private:
    std::uint32_t append(std::span<const std::uint32_t> run);

    Materials& materials_;
    World& world_;
    std::unordered_map<dat::RecordId, std::uint32_t> byPart_; ///< by GfxObj
};

} // namespace limen::world
