#pragma once

#include "world/assemble/MaterialRuns.h"
#include "world/mesh/MeshArena.h"

namespace limen::world {

/// Adds ParticleEmitter records to a World: one style and one drawn part each.
class ParticleStyleAssembler {
public:
    ParticleStyleAssembler(Records& records, Models& models, MaterialRuns& materials, MeshArena& arena,
                           World& world)
        : records_(records), models_(models), materials_(materials), arena_(arena), world_(world) {}

    /// The emitter's index in World::particleStyles; kNone if it can show no particle.
    [[nodiscard]] std::uint32_t styleOf(dat::RecordId emitter);

private:
    /// The part that is drawn for each particle: the emitter's mesh, or, if its nearest level of detail is a
    /// sprite, a rectangle of the mesh's size. kNone without a mesh.
    [[nodiscard]] std::uint32_t addPart(const dat::ParticleEmitter& record, ParticleStyle& style);
    [[nodiscard]] std::uint32_t addSprite(const PartMesh& mesh, const Material& material);

    Records& records_;
    Models& models_;
    MaterialRuns& materials_;
    MeshArena& arena_;
    World& world_;
    std::unordered_map<dat::RecordId, std::uint32_t> byEmitter_;
};

} // namespace limen::world
