#pragma once

#include "world/MeshBuilder.h"
#include "world/Models.h"

namespace limen::world {

/// Puts meshes into a world's arenas; those of GfxObjs once each, by content.
class MeshArena {
public:
    explicit MeshArena(World& world) : world_(world) {}

    /// Yields the mesh's index.
    std::uint32_t add(const MeshData& data, std::uint64_t contentKey);
    /// Tells each triangle of a shell the walls beyond its edges (MeshVertex::neighbour). Needed in zones of several cells, where
    /// depth alone decides between a wall and what another cell has behind it.
    void tellNeighbours(std::uint32_t shell);
    /// The mesh of a GfxObj, shared by everything that uses it.
    std::uint32_t shared(const PartMesh& part);

private:
    World& world_;
    std::unordered_map<std::uint64_t, std::uint32_t> byContent_;
};

/// Content keys: what kind of thing a mesh was made from, and its record.
enum class MeshSource : std::uint64_t {
    GfxObj,
    Shell,
    Terrain,
    Exterior,
    Sky,
    Filling,
    Sprite,
    ShutPane,
    Ghost,
    Particle
};
[[nodiscard]] constexpr std::uint64_t contentKey(MeshSource source, dat::RecordId record,
                                                 std::uint32_t index = 0) {
    return static_cast<std::uint64_t>(source) << 60 | static_cast<std::uint64_t>(index & 0x0FFFFFFFu) << 32 |
           record;
}

} // namespace limen::world
