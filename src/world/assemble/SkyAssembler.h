#pragma once

#include "world/assemble/MaterialRuns.h"
#include "world/mesh/MeshArena.h"

#include <map>
#include <utility>

namespace limen::world {

/// Adds the meshes of sky objects to a World, and of the models that replace them in some keyframes.
class SkyAssembler {
public:
    SkyAssembler(Models& models, MaterialRuns& materials, MeshArena& arena, World& world)
        : models_(models), materials_(materials), arena_(arena), world_(world) {}

    void add(const dat::SkyDesc& sky);

private:
    /// Adds a copy of `part` for each part of a model that has a mesh. Model 0 is none.
    void addParts(const SkyPart& part, dat::RecordId model);

    Models& models_;
    MaterialRuns& materials_;
    MeshArena& arena_;
    World& world_;
    std::map<std::pair<dat::RecordId, std::size_t>, std::uint32_t> meshes_; ///< by model and part
};

} // namespace limen::world
