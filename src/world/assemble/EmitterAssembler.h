#pragma once

#include "world/MovingEntries.h"
#include "world/assemble/MaterialRuns.h"
#include "world/mesh/MeshArena.h"

namespace limen::world {

/// Adds the sprite emitters of world.json and the rain drop to a World. Requires: all blocks and villagers
/// are in it.
class EmitterAssembler {
public:
    EmitterAssembler(MaterialRuns& materials, MeshArena& arena, World& world)
        : materials_(materials), arena_(arena), world_(world) {}

    /// Left out if the villager, the cell or the block it refers to is not loaded.
    void add(const EmitterEntry& entry);
    void addRainDrop();

private:
    /// A unit square in one material. `key` makes its content key and its identity unique.
    [[nodiscard]] std::uint32_t addSprite(std::uint32_t firstMaterial, std::uint32_t key);

    MaterialRuns& materials_;
    MeshArena& arena_;
    World& world_;
};

} // namespace limen::world
