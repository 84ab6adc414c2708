#pragma once

#include "world/assemble/BakedInstance.h"
#include "world/assemble/MaterialRuns.h"

namespace limen::world {

/// Adds the exteriors of buildings and the shells of cells to a World.
class StructureAssembler {
public:
    StructureAssembler(MaterialRuns& materials, MeshArena& arena, World& world)
        : materials_(materials), arena_(arena), world_(world) {}

    void add(const JoiningBlock& block);

private:
    void addExteriors(const JoiningBlock& block);
    void addShells(const JoiningBlock& block);

    MaterialRuns& materials_;
    MeshArena& arena_;
    World& world_;
};

} // namespace limen::world
