#pragma once

#include "world/assemble/BakedInstance.h"
#include "world/texture/Materials.h"

#include <map>

namespace limen::world {

/// Adds the ground of blocks to a World: one instance a block and 64 terrain cells with their textures.
class TerrainAssembler {
public:
    /// `region`: null if the world has none; then blocks have no ground.
    TerrainAssembler(const dat::Region* region, Materials& materials, MeshArena& arena, World& world)
        : region_(region), materials_(materials), arena_(arena), world_(world) {}

    void add(const JoiningBlock& block);

private:
    /// Yields the first of the block's 64 terrain cells.
    [[nodiscard]] std::uint32_t addCells(const Ground& ground);
    [[nodiscard]] TerrainCell paint(const CellCorners& corners);

    const dat::Region* region_;
    Materials& materials_;
    MeshArena& arena_;
    World& world_;
    std::map<std::uint32_t, TerrainCell> painted_; ///< by palette code
};

} // namespace limen::world
