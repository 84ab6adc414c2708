#pragma once

#include "world/mesh/Models.h"

namespace limen::world {

/// Appends meshes to a world's vertex and index arrays. The mesh of a GfxObj is appended once.
class MeshArena {
public:
    explicit MeshArena(World& world) : world_(world) {}

    /// Yields the index in World::meshes.
    std::uint32_t add(const MeshData& data, std::uint64_t contentKey);
    /// Sets MeshVertex::neighbour in a shell's triangles: the walls beyond their edges. Needed in zones of
    /// several cells, where depth alone decides between a wall and the surfaces of another cell behind it.
    /// `inOpenings`: MeshData::inOpenings.
    void setNeighbours(std::uint32_t shell, std::span<const std::uint16_t> inOpenings);
    /// The mesh of a GfxObj, shared by all its instances.
    std::uint32_t shared(const PartMesh& part);

private:
    World& world_;
    std::unordered_map<std::uint64_t, std::uint32_t> byContent_;
};

/// The source of a mesh: the upper bits of its content key.
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
